#include "case.h"

surface hard_reflect(CASE varying vector i = 0, n = 0; output varying vector r = 0;) {
  IF_ACTIVE {
    r = reflect(i, n);
  }
}
