#include "case.h"

surface hard_unit_dot(CASE varying vector v = 0; output varying float angle = 0, sine = 0, highlight = 0;) {
  IF_ACTIVE {
    vector n = normalize(v);
    float c = n . n;
    angle = acos(c);
    sine = sqrt(1 - c * c);
    highlight = comp(specularbrdf(n, normal(n), n, 1e-6), 0);
  }
}
