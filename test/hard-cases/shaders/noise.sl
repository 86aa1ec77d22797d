#include "case.h"

surface hard_noise(CASE varying point p = 0; output varying float one = 0, three = 0;) {
  IF_ACTIVE {
    one = noise(xcomp(p));
    three = noise(p);
  }
}
