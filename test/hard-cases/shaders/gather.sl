#include "case.h"

surface hard_gather(CASE varying float i = 0; output varying float element = 0, component = 0;) {
  IF_ACTIVE {
    float list[5] = {1, 2, 4, 8, 16};
    element = list[i];
    list[i] = 32;
    element += list[i];
    component = comp(color(1, 2, 4), i);
  }
}
