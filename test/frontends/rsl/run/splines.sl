// The curves of spline(), at s = 0, 0.25, 0.5, 0.75, 1 and outside.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 5x1 --width 1 --print a --print b --print c --print d --print e --print f --print g --print h --print same > %t.1
// RUN: anysl-shade %t.so --grid 5x1 --width 8 --print a --print b --print c --print d --print e --print f --print g --print h --print same > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8

float bend(float x; float knots[]) { return spline(x, knots); }

surface splines(string basis = "hermite"; output varying float a = 0, b = 0, c = 0, d = 0, f = 0, g = 0, h = 0, same = 0; output varying color e = 0) {
  float knots[5] = {0, 1, 3, 2, 0};
  // Catmull-Rom goes through 1, 3, 2; between the first two at the half: (-0 + 9*1 + 9*3 - 2) / 16.
  a = bend(s, knots);
  // Bezier: one segment from 0 to 8, at the half (0 + 3*4 + 3*0 + 8) / 8.
  b = spline("bezier", s, 0, 4, 0, 8);
  // B-spline at the beginning (1*0 + 4*6 + 1*0) / 6, at the half (1*0 + 23*6 + 23*0 + 1*6) / 48.
  c = spline("bspline", s, 0, 6, 0, 6);
  // Linear, from the second to the last but one.
  d = spline("linear", s, 9, 1, 3, 9);
  // Colors, each component by itself: at the half (-k0 + 9 k1 + 9 k2 - k3) / 16.
  e = spline(s, color(0), color(0, 1, 2), color(1, 1, 4), color(1));
  // Hermite from 1 to 2 with slopes 0: 1 + 3 t^2 - 2 t^3.
  f = spline("hermite", s, 1, 0, 2, 0);
  g = float spline(2 * s - 0.5, 0, 1, 2, 3) + spline("power", s, 0, 0, 10, 5);
  // The basis may be known at run time only, and be another from point to point; what is no name is Catmull-Rom.
  h = spline(s < 0.4 ? "linear" : s < 0.6 ? "bezier" : "nonsense", s, 9, 1, 3, 9);
  same = spline(basis, s, 1, 0, 2, 0) == f && spline(basis == "" ? "x" : "b-spline", s, 0, 6, 0, 6) == c ? 1 : 0;
  // An array that grows has as many knots as are in it.
  float grown[];
  float i;
  for (i = 0; i < 5; i += 1)
    push(grown, knots[i]);
  same += spline(s, grown) == a ? 1 : 0;
}

// CHECK:      0 0  a 1  b 0  c 4  d 1  e 0 1 2  f 1  g 6  h 1  same 2
// CHECK-NEXT: 1 0  a 2.125  b {{.*}}  d 1.5  e {{.*}}  f 1.15625  g 8.5  h 1.5  same 2
// CHECK-NEXT: 2 0  a 3  b 2.5  c 3  d 2  e 0.5 1.0625 3.3125  f 1.5  g 11.5  h 3.75  same 2
// CHECK-NEXT: 3 0  a 2.75  b {{.*}}  d 2.5  e {{.*}}  f 1.84375  g 14.5  h 1.984375  same 2
// CHECK-NEXT: 4 0  a 2  b 8  c 2  d 3  e 1 1 4  f 2  g 17  h 3  same 2
