#include "case.h"

surface hard_faceforward(CASE varying vector n = 0, i = 0, reference = 0; output varying vector r = 0;) {
  IF_ACTIVE {
    r = faceforward(n, i, reference);
  }
}
