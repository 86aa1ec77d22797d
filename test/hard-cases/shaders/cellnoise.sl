#include "case.h"

surface hard_cellnoise(CASE varying float x = 0; output varying float here = 0, start = 0, before = 0, after = 0;) {
  IF_ACTIVE {
    here = cellnoise(x);
    start = cellnoise(floor(x));
    before = cellnoise(floor(x) - 1);
    after = cellnoise(floor(x) + 1);
  }
}
