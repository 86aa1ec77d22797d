// RSL has no '--': between and before values it is two minus signs.
// RUN: rslc %s -Werror -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 1x1 --width 1 --print a --print b | FileCheck %s
// RUN: anysl-shade %t.so --grid 1x1 --width 8 --print a --print b | FileCheck %s
// CHECK: a 4 1 7 -4  b 1 1 1
surface minus(output varying float a[4] = {0, 0, 0, 0}; output varying color b = 0) {
  float x = 3, y[2] = {2, 4};
  a[0] = x--1;
  a[1] = --1;
  a[2] = x--y[1];
  a[3] = -x--(y[0] - 3);
  b = --(1, 1, 1);
}
