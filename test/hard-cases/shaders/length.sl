#include "case.h"

surface hard_length(CASE varying vector v = 0; output varying float l = 0, d = 0;) {
  IF_ACTIVE {
    l = length(v);
    d = distance(point(v), point(0));
  }
}
