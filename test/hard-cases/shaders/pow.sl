#include "case.h"

surface hard_pow(CASE varying float x = 0, y = 0; output varying float r = 0;) {
  IF_ACTIVE {
    r = pow(x, y);
  }
}
