#include "../case.h"

// u and v are 0 where this runs, so that x + u has the value x and the derivative 1.
surface hard_area(CASE varying vector a = 0, b = 0, n = 0, ng = 0; output varying float size = 0; output varying vector m = 0;) {
  IF_ACTIVE {
    N = normal(n);
    Ng = normal(ng);
    dPdu = a;
    dPdv = b;
    point p = point(a * u + b * v);
    size = area(p);
    m = calculatenormal(p);
  }
}
