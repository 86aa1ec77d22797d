// What a function changes, its arguments do not see, however they are handed over.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 8
// RUN: anysl-shade %t.so --grid 1x1 --print outer --print same --print element --print nested | FileCheck %s

// The argument is the variable that the function changes, and of another type.
void shift(vector by) {
  extern point P;
  P += by;
  P += by;
}

// Both outputs are one variable: the last copy stays.
void both(output float a, b) {
  a += 1;
  b += 10;
}

float add(float a, b) { return a + b; }
float bump(output float x) { x += 1; return x; }

surface aliasing(output varying vector outer = 0; output varying float same = 0, element = 0, nested = 0) {
  P = (1, 2, 3);
  shift(P);
  outer = P;
  float x = 1;
  both(x, x);
  same = x;
  float list[2] = {1, 0};
  float i = 0;
  // The element is chosen before the value changes the index.
  list[i] = (i = 1) + 4;
  element = list[0] * 10 + list[1];
  float n = 0;
  nested = add(n, add(bump(n), bump(n)));
}

// CHECK: outer 3 6 9  same 11  element 50  nested 3
