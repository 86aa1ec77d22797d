#include "../case.h"

// u and v are 0 where this runs, so that x + u has the value x and the derivative 1.
surface hard_atan2_slope(CASE varying float y = 0, x = 0; output varying float byY = 0, byX = 0;) {
  IF_ACTIVE {
    float r = atan(y + u, x + v);
    byY = Du(r);
    byX = Dv(r);
  }
}
