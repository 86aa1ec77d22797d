#include "case.h"

surface hard_tone(CASE varying float x = 0; output varying float gamma = 0, tone = 0;) {
  IF_ACTIVE {
    gamma = pow(x, 1 / 2.2);
    tone = 1 - exp(-max(x, 0));
  }
}
