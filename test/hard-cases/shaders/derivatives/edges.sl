#include "../case.h"

// u and v are 0 where this runs, so that x + u has the value x and the derivative 1.
surface hard_edges(CASE varying float x = 0; output varying float root = 0, inverse = 0, logarithm = 0, arc = 0;) {
  IF_ACTIVE {
    float y = x + u;
    root = Du(sqrt(y));
    inverse = Du(inversesqrt(y));
    logarithm = Du(log(y));
    arc = Du(acos(y));
  }
}
