#include "case.h"

surface hard_spline_unity(CASE varying float x = 0, k = 0; output varying float catmullRom = 0, bezier = 0, bspline = 0, linear = 0;) {
  IF_ACTIVE {
    catmullRom = spline(x, k, k, k, k, k);
    bezier = spline("bezier", x, k, k, k, k, k, k, k);
    bspline = spline("bspline", x, k, k, k, k, k);
    linear = spline("linear", x, k, k, k, k, k);
  }
}
