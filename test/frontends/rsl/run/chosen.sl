// Structures and arrays chosen by '?:', and methods of what calls give. s is 0, 0.5, 1.
// RUN: rslc %s -Wall -Werror -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 3x1 --width 1 --print a --print b --print c --print d | FileCheck %s
// RUN: anysl-shade %t.so --grid 3x1 --width 8 --print a --print b --print c --print d | FileCheck %s
struct Pair {
  float x = 1;
  varying float y[2] = {2, 3};
  float sum() { return x + y[0] + y[1]; }
}
Pair make(float x, y) { Pair p; p->x = 7; p->y = {x, y}; return p; }
float calls(output float n; float x) { n += 1; return x; }

surface chosen(output varying float a = 0, b = 0, c = 0; output varying float d[2] = {0, 0}) {
  a = make(1, 2)->sum() + 100 * Pair(5)->sum() + 10000 * make(s, 4)->y[1];
  Pair p = s > 0.7 ? make(10, 20) : Pair("x", 4);
  float n = 0;
  // Only one side runs.
  Pair q = s < 0.3 ? make(calls(n, 1), 1) : make(calls(n, 2), calls(n, 3));
  b = p->sum() + 100 * q->sum() + 10000 * n;
  c = (s < 0.3 ? p : q)->sum();
  float one[2] = {1, 2}, two[2] = {3, s};
  d = s > 0.3 ? two : one;
}
// a = 10 + 1000 + 40000. p is (4; 2, 3) and at last (7; 10, 20); q is (7; 1, 1), then (7; 2, 3).
// CHECK:      0 0  a 41010 b 10909 c 9 d 1 2
// CHECK-NEXT: 1 0  a 41010 b 21209 c 12 d 3 0.5
// CHECK-NEXT: 2 0  a 41010 b 21237 c 12 d 3 1
