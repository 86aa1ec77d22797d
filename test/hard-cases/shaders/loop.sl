#include "case.h"

surface hard_loop(CASE varying float from = 0, to = 0, step = 0; output varying float rounds = 0, last = 0;) {
  IF_ACTIVE {
    // Written so that NaN leaves: the condition to go on fails.
    float t = from;
    while (t < to && rounds < 100) {
      t += step;
      rounds += 1;
    }
    last = t;
  }
}
