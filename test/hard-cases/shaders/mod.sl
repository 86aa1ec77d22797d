#include "case.h"

surface hard_mod(CASE varying float a = 0, b = 0; output varying float r = 0;) {
  IF_ACTIVE {
    r = mod(a, b);
  }
}
