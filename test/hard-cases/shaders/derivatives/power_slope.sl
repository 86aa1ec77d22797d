#include "../case.h"

// u and v are 0 where this runs, so that x + u has the value x and the derivative 1.
surface hard_power_slope(CASE varying float x = 0, y = 0; output varying float r = 0, byY = 0;) {
  IF_ACTIVE {
    r = Du(pow(x + u, y));
    byY = Dv(pow(x, y + v));
  }
}
