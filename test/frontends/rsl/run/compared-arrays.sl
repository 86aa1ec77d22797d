// Arrays are equal where all their elements are and they have as many, and what lies behind the length does not count.
// RUN: rslc %s -Werror -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 3x1 --width 1 --print fixed --print grown --print texts | FileCheck %s
// RUN: anysl-shade %t.so --grid 3x1 --width 8 --print fixed --print grown --print texts | FileCheck %s

surface compared(float given[] = {}; output varying float fixed = 0, grown = 0, texts = 0) {
  float a[2] = {1, s}, b[2] = {1, 0.5};
  color c[2] = {color(1, 2, 3), 4}, d[2] = {color(1, 2, 3), color(4, 4, 4 * s)};
  point p[1] = {(1, 2, 3)};
  normal n[1] = {(1, 2, 3)};
  fixed = (a == b) + 10 * (a != b) + 100 * (c == d) + 1000 * (p == n);

  float x[], y[];
  grown = x == y;                     // both are empty
  push(x, 1);
  grown += 10 * (x == y);
  push(y, 1);
  push(y, 2);
  grown += 100 * (pop(y) == 2 && x == y);
  resize(x, 2);
  grown += 1000 * (x != b);           // 0 where b has 0.5
  x[1] = s;
  grown += 10000 * (x == b) + 100000 * (given == x);

  string t[2] = {"a", "b"}, u[2] = {"a", "c"};
  shader none[1] = {null}, nobody[1] = {null};
  texts = (t == u) + 10 * (t != u) + 100 * (none == nobody);
}

// CHECK:      0 0  fixed 1010 grown 1101 texts 110
// CHECK-NEXT: 1 0  fixed 1001 grown 11101 texts 110
// CHECK-NEXT: 2 0  fixed 1110 grown 1101 texts 110
