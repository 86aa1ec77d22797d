#include "case.h"

surface hard_basis(CASE varying vector z = 0; output varying vector x = 0, y = 0;) {
  IF_ACTIVE {
    // The axis that z is farther from gives a cross product without cancellation.
    x = normalize(z ^ (abs(zcomp(z)) < 0.7 ? vector(0, 0, 1) : vector(1, 0, 0)));
    y = z ^ x;
  }
}
