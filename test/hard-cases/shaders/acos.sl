#include "case.h"

surface hard_acos(CASE varying float x = 0; output varying float c = 0, s = 0;) {
  IF_ACTIVE {
    c = acos(x);
    s = asin(x);
  }
}
