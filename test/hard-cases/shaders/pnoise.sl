#include "case.h"

surface hard_pnoise(CASE varying float x = 0, period = 0; output varying float r = 0, one = 0;) {
  IF_ACTIVE {
    r = pnoise(x, period);
    one = pnoise(x, 1);
  }
}
