#include "case.h"

surface hard_filterstep(CASE varying float edge = 0, a = 0, b = 0; output varying float r = 0, same = 0;) {
  IF_ACTIVE {
    r = filterstep(edge, a, b);
    same = filterstep(edge, a, a);
  }
}
