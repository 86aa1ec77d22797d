#include "case.h"

surface hard_angle(CASE varying vector a = 0, b = 0; output varying float r = 0;) {
  IF_ACTIVE {
    r = atan(length(a ^ b), a . b);
  }
}
