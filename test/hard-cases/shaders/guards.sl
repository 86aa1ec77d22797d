#include "case.h"

surface hard_guards(CASE varying float x = 0; output varying float isnan = 0, isinf = 0, difference = 0;) {
  IF_ACTIVE {
    isnan = x != x ? 1 : 0;
    isinf = x == x && x - x != 0 ? 1 : 0;
    difference = (x + 1) - x;
  }
}
