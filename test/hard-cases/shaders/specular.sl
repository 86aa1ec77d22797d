#include "case.h"

surface hard_specular(CASE varying vector l = 0, v = 0; varying float roughness = 0; output varying float blinn = 0, mirrored = 0;) {
  IF_ACTIVE {
    blinn = comp(specularbrdf(normalize(l), normal(0, 0, 1), normalize(v), roughness), 0);
    vector m = reflect(-normalize(v), vector(0, 0, 1));
    mirrored = pow(clamp(m . normalize(l), 0, 1), 1 / roughness);
  }
}
