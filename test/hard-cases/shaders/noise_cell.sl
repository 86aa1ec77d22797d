#include "case.h"

surface hard_noise_cell(CASE varying float x = 0; output varying float r = 0, cell = 0;) {
  IF_ACTIVE {
    r = noise(x);
    cell = cellnoise(x);
  }
}
