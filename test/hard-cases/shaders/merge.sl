#include "case.h"

surface hard_merge(CASE varying float which = 0, x = 0, y = 0; output varying float r = 0;) {
  IF_ACTIVE {
    if (which > 0)
      r = 1 + x;
    else
      r = 2 + y;
  }
}
