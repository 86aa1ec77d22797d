#include "abi.h"

LOAD_SCALE { return x > 0 ? p[i] * x : -x; }

MIXED {
  double r = y;
  for (int k = 0; k < (n & 7); ++k)
    r = r * x + k;
  return r;
}

WIDE_RESULT { return x < 0 ? x * x : x / 3; }

ITERATIONS {
  int k = 0;
  for (n &= 1023; n > 1 && k < 50; ++k)
    n = n & 1 ? 3 * n + 1 : n / 2;
  return k;
}

BYTES { return y > x ? (signed char)(x + y) : (signed char)(x * 3); }

LONGS { return y > 0 ? y / (x | 1) : y * x; }

STORE_SCALED {
  if (x > 0.5f)
    *p = x * scale;
}
