// A function may be defined again, as headers that are put together do: who comes later calls the later one.
// RUN: rslc %s -Wno-function-redefined -Werror -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 1x1 --width 8 | FileCheck %s
// CHECK: Ci 1 2 3

float twice(float x) { return 1 + 0 * x; }
float first() { return twice(0); }
float twice(float y) { return 2 + 0 * y; }
float twice(float x, y) { return 3; }

surface redefined() { Ci = color(first(), twice(0), twice(0, 0)); }
