#include "case.h"

surface hard_ctransform_xyz(CASE varying color c = 0; output varying color there = 0, back = 0;) {
  IF_ACTIVE {
    there = ctransform("rgb", "xyz", c);
    back = ctransform("xyz", "rgb", there);
  }
}
