#include "case.h"

surface hard_microfacet(CASE varying vector h = 0; varying float alpha = 0; output varying float d = 0;) {
  IF_ACTIVE {
    // The sine from the part of h across the normal (0, 0, 1), which 1 - c * c would have lost.
    float a = alpha * alpha, c = zcomp(h) * zcomp(h);
    float s = xcomp(h) * xcomp(h) + ycomp(h) * ycomp(h);
    float k = alpha * c + s / alpha;
    d = 1 / (PI * k * k);
  }
}
