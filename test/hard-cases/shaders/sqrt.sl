#include "case.h"

surface hard_sqrt(CASE varying float x = 0; output varying float r = 0, inverse = 0;) {
  IF_ACTIVE {
    r = sqrt(x);
    inverse = inversesqrt(x);
  }
}
