#include "case.h"

surface hard_normalize(CASE varying vector v = 0; output varying vector n = 0;) {
  IF_ACTIVE {
    n = normalize(v);
  }
}
