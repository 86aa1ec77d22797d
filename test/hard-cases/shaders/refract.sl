#include "case.h"

surface hard_refract(CASE varying vector i = 0, n = 0; varying float eta = 1; output varying vector t = 0;) {
  IF_ACTIVE {
    t = refract(i, n, eta);
  }
}
