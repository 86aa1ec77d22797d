#include "../case.h"

// u and v are 0 where this runs, so that x + u has the value x and the derivative 1.
surface hard_length_slope(CASE varying vector p = 0; output varying float r = 0; output varying vector n = 0;) {
  IF_ACTIVE {
    vector q = p + vector(u, 0, 0);
    r = Du(length(q));
    n = Du(normalize(q));
  }
}
