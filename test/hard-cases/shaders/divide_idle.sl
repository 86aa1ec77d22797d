#include "case.h"

surface hard_divide_idle(CASE varying float a = 0, b = 0; output varying float quotient = 0, rest = 0, element = 0;) {
  IF_ACTIVE {
    float list[4] = {10, 20, 30, 40};
    quotient = floor(a / b);
    rest = mod(a, b);
    element = list[quotient];
  }
}
