#include "case.h"

surface hard_spline(CASE varying float x = 0, a = 0, b = 0, c = 0, d = 0, e = 0; output varying float r = 0, few = 0;) {
  IF_ACTIVE {
    r = spline(x, a, b, c, d, e);
    float knots[4];
    knots[0] = a; knots[1] = b; knots[2] = c; knots[3] = d;
    few = spline("linear", x, knots);
  }
}
