#include "case.h"

surface hard_fresnel(CASE varying vector i = 0, n = 0; varying float eta = 1; output varying float kr = 0, kt = 0; output varying vector r = 0, t = 0;) {
  IF_ACTIVE {
    fresnel(i, n, eta, kr, kt, r, t);
  }
}
