#include "../case.h"

// u and v are 0 where this runs, so that x + u has the value x and the derivative 1.
surface hard_filterwidth(CASE varying float edge = 0, x = 0, slope = 0; output varying float r = 0, plain = 0;) {
  IF_ACTIVE {
    r = filterstep(edge, x + slope * u);
    plain = step(edge, x);
  }
}
