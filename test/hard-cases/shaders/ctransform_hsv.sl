#include "case.h"

surface hard_ctransform_hsv(CASE varying color c = 0; output varying color there = 0, back = 0;) {
  IF_ACTIVE {
    there = ctransform("rgb", "hsv", c);
    back = ctransform("hsv", "rgb", there);
  }
}
