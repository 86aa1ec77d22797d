#include "case.h"

surface hard_denormal(CASE varying float x = 0; output varying float half = 0, twice = 0, same = 0, root = 0;) {
  IF_ACTIVE {
    half = 0.5 * x;
    twice = x + x;
    same = x == 0 ? 1 : 0;
    root = sqrt(x);
  }
}
