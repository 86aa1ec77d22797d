#include "case.h"

surface hard_ctransform_xyY(CASE varying color c = 0; output varying color there = 0, back = 0;) {
  IF_ACTIVE {
    there = ctransform("rgb", "xyY", c);
    back = ctransform("xyY", "rgb", there);
  }
}
