#include "case.h"

surface hard_smoothstep(CASE varying float low = 0, high = 0, x = 0; output varying float r = 0;) {
  IF_ACTIVE {
    r = smoothstep(low, high, x);
  }
}
