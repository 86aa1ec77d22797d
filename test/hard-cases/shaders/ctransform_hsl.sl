#include "case.h"

surface hard_ctransform_hsl(CASE varying color c = 0; output varying color there = 0, back = 0;) {
  IF_ACTIVE {
    there = ctransform("rgb", "hsl", c);
    back = ctransform("hsl", "rgb", there);
  }
}
