#include "case.h"

surface hard_atan2(CASE varying float y = 0, x = 0; output varying float r = 0;) {
  IF_ACTIVE {
    r = atan(y, x);
  }
}
