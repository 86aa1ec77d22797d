// The last parameters of functions and methods may have defaults, which calls may leave out; a default may use the parameters before
// it. What a renderer calls takes as many arguments as the renderer has, also where the method could take more.
// RUN: rslc %s -Werror -DCALLED -o %t.called.bc && anysl-link %t.called.bc -o %t.called.so --width 1
// RUN: anysl-info %t.called.bc | FileCheck %s --check-prefix=INFO
// RUN: rslc %s -Werror -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --grid 2x1 --width 1 --coshader area=%t.called.so --print Ci --print a --print b --print c | FileCheck %s
// RUN: anysl-shade %t.so --grid 2x1 --width 8 --coshader area=%t.called.so --print Ci --print a --print b --print c | FileCheck %s
// RUN: anysl-shade %t.so --grid 2x1 --width 8 --light %t.called.so --coshader area=%t.called.so --print Ci --print lit | FileCheck %s --check-prefix=LIT

#ifdef CALLED
class area(float intensity = 2) {
  public void light(output vector L; output color Cl; point from = (0, 0, 0); output float weights[] = {}) {
    resize(weights, 2);
    weights[0] = xcomp(from);
    weights[1] = intensity;
    L = vector(0, 0, -3);
    Cl = intensity;
  }
  public float scaled(float x, by = 10 * x) { return x + by; }
}
#else
struct Scale {
  float factor = 3;
  float of(float x, power = 1, add = 100 * power) { return pow(factor * x, power) + add; }
}

void both(output float x, y = 7; float by = 2) { x *= by; y *= by; }
color sum(color colors[2] = {(1, 2, 3), (10, 20, 30)}) { return colors[0] + colors[1]; }

surface defaults(output varying float a = 0, b = 0, c = 0; output varying color lit = 0) {
  float nested(float x = s, y = 2 * x;) { return x + y; }
  Scale scale;
  float x = 1, y = 2;
  both(x);
  both(x, y);
  both(x, y, 10);
  // x: 1 2 4 40, y: 2 4 40
  a = x * 100 + y;
  b = scale->of(2) * 10000 + scale->of(2, 2) * 10 + scale->of(2, 2, 5) / 41;
  c = nested() + nested(10) * 10 + nested(10, 1) * 1000;
  Ci = sum();
  // So can a call of another shader, whose method is not known here.
  shader light = getshader("area");
  vector dir = 0;
  color brightness = 0;
  float weights[2] = {-1, -1};
  light->light(dir, brightness);
  Ci += brightness;
  light->light(dir, brightness, P + 5, weights);
  Ci += color(weights[0], weights[1], light->scaled(0.5) + light->scaled(1, 1) * 1000);
  illuminance(P) lit += Cl;
}
#endif

// At s = 0 and 1, which P begins with:
// (11, 22, 33) + 2 + (P + 5, 2, 5.5 + 2000); 106 and 36 + 200, (36 + 5) / 41; 3 s + 30 * 10 + 11 * 1000
// CHECK:      0 0  Ci 18 26 2040.5 a 4040 b 1062361 c 11300
// CHECK-NEXT: 1 0  Ci 19 26 2040.5 a 4040 b 1062361 c 11303
// LIT:        0 0  Ci 18 26 2040.5 lit 2 2 2
// INFO-DAG: light area
// INFO-DAG: method area.light(tt)v
// INFO-DAG: method area.light(ttt)v
// INFO-DAG: method area.light(tttf*64)v
// INFO-DAG: method area.scaled(f)f
// INFO-DAG: method area.scaled(ff)f
