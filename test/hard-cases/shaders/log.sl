#include "case.h"

surface hard_log(CASE varying float x = 0; output varying float r = 0;) {
  IF_ACTIVE {
    r = log(x);
  }
}
