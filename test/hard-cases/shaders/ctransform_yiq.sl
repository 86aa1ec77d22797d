#include "case.h"

surface hard_ctransform_yiq(CASE varying color c = 0; output varying color there = 0, back = 0;) {
  IF_ACTIVE {
    there = ctransform("rgb", "yiq", c);
    back = ctransform("yiq", "rgb", there);
  }
}
