// Operators, conversions, arrays and functions, against values worked out by hand.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,4
// RUN: anysl-shade %t.so --grid 1x1 --width 1 --set Cs=0.25,0.5,1 --print a --print b --print c --print d --print e --print f --print g --print h --print k --print m --print n > %t.1
// RUN: anysl-shade %t.so --grid 1x1 --width 4 --set Cs=0.25,0.5,1 --print a --print b --print c --print d --print e --print f --print g --print h --print k --print m --print n > %t.4
// RUN: diff %t.1 %t.4
// RUN: FileCheck %s < %t.4

void swap(output float x, y) {
  float keep = x;
  x = y;
  y = keep;
}

float sum(float list[]) {
  float total = 0;
  uniform float i;
  for (i = 0; i < arraylength(list); i += 1)
    total += list[i];
  return total;
}

surface values(output varying vector a = 0, b = 0, c = 0; output varying float d = 0, e = 0, f = 0, g = 0;
               output varying color h = 0; output varying float k = 0; output varying float m[2] = {0, 0};
               output varying float n = 0) {
  vector X = (1, 2, 3), Y = (4, 5, 6);
  a = X * 2 ^ Y;                    // (2, 4, 6) x (4, 5, 6) = (24-30, 24-12, 10-16)
  b = X + X ^ Y;                    // (1, 2, 3) + (12-15, 12-6, 5-8)
  c = 12 / X - -X;                  // (12, 6, 4) + (1, 2, 3)
  d = 2 * X.Y - 2 - 1;              // 2 * 32 - 3
  float x = 3, y = 5;
  swap(x, y);
  e = x * 10 + y;
  float list[4] = {1, 2, 4};
  list[3] = 8;
  list[1.9] += 16;                  // the element below
  f = sum(list);
  X[1] = 7;
  setzcomp(X, 9);
  g = X[0] * 100 + ycomp(X) * 10 + X[2];
  h = Cs * color(4, 2, 1) + 1;      // (1, 1, 1) + 1
  h[2] *= 5;
  matrix M = matrix(1, 0, 0, 0,  0, 2, 0, 0,  0, 0, 3, 0,  5, 6, 7, 1);
  point p = transform(M, point(1, 1, 1)); // (1, 2, 3) + (5, 6, 7)
  k = p[0] * 10000 + p[1] * 100 + p[2];
  m[0] = (Cs == color(0.25, 0.5, 1)) + ("a" == "a") + ("a" == "b") + (X != Y) + !(1 > 2);
  m[1] = mod(-1.5, 1) + step(0.5, 0.5) + smoothstep(0, 1, 0.25) + clamp(5, 3, 1) + round(2.5);
  n = determinant(2 * M) / 16;      // 6
}

// CHECK: a -6 12 -6 b -2 8 0 c 13 8 7 d 61 e 53 f 31 g 179 h 2 2 10 k 60810 m 4 {{.*}} n 6
