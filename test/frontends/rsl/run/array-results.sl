// Functions and methods of other shaders that give arrays and structures. s is 0, 0.5, 1.
// RUN: rslc %S/Inputs/samples.sl -o %t.lib.bc -Werror && anysl-link %t.lib.bc -o %t.lib.so --width 1
// RUN: rslc %s -o %t.bc -Werror && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 3x1 --coshader lib=%t.lib.so --width 1 --print Ci --print a --print b --print c --print d --print e --print f --print g --print h > %t.1
// RUN: anysl-shade %t.so --grid 3x1 --coshader lib=%t.lib.so --width 8 --print Ci --print a --print b --print c --print d --print e --print f --print g --print h > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8
// RUN: anysl-shade %t.so --grid 3x1 --print e --print f --print g --print h | FileCheck %s --check-prefix=NONE
// RUN: anysl-info %t.lib.bc | FileCheck %s --check-prefix=INFO

struct Sample { varying vector dir = 0; varying float pdf = 0; float w[2] = {0, 0}; string tag = ""; }
float[] squares(float n) { float a[]; float i; for (i = 1; i <= n; i += 1) push(a, i * i); return a; }
float[2] pair(float x, y) { if (x > y) return {y, x}; return {x, y}; }
color[2] both(color c) { color r[2]; r[0] = c; r[1] = 1 - c; return r; }
string[] words() { return {"x", "y", "z"}; }
float total(float a[]) { float t = 0, i; for (i = 0; i < arraylength(a); i += 1) t += a[i]; return t; }
surface results(output varying float a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0) {
  // As many as each point asks for.
  float q[] = squares(2 + 2 * s);
  a = arraylength(q) * 100 + total(q);
  float p[2] = pair(3 * s, 1);
  b = p[0] * 10 + p[1] + pair(1, 2)[1] * 100;
  p = {p[1], p[0]};
  c = p[0] * 10 + p[1];
  Ci = both(color(s, 0, 0))[1];
  d = total(pair(4, 5)) + total(squares(3)) * 100 + arraylength(words());
  // An array may be longer than what gets it, and the other way round.
  shader l = getshader("lib");
  float three[3] = l->scaled(s);
  float many[] = l->upto(3), few[2] = l->upto(5);
  e = three[0] + three[1] * 10 + three[2] * 100 + arraylength(many) * 1000 + many[2] * 10000 + few[1] * 100000;
  Sample x = l->draw(s);
  f = xcomp(x->dir) + x->pdf * 10 + x->w[0] * 100 + x->w[1] * 1000;
  if (x->tag == "lib") f += 10000;
  float t[3] = l->table;
  g = t[0] * 100 + t[1] * 10 + t[2] + total(l->upto(4)) * 1000;
  string n[2] = l->names();
  if (n[0] == "a" && n[1] == "bc") h = 1;
  // What there is not is 0.
  p = l->nothing(); h += 10 * (p[0] + p[1] + total(l->missing(1)));
}

// CHECK:      0 0  Ci 1 1 1 a 205 b 201 c 10 d 1412 e 243340 f 19820 g 12567 h 1
// CHECK-NEXT: 1 0  Ci 0.5 1 1 a 314 b 211.5 c 16 d 1412 e 243340.5 f 19820.5 g 12567 h 1
// CHECK-NEXT: 2 0  Ci 0 1 1 a 430 b 213 c 31 d 1412 e 243341 f 19821 g 12567 h 1
// NONE: 0 0  e 0 f 0 g 0 h 0
// INFO: method lib.scaled(f)f3
// INFO: method lib.upto(f)f*64
// INFO: method lib.draw(f)tff2s
// INFO: method lib.names()s2
