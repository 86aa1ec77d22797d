// A class shader is one shader for each kind of its methods; members keep what construct, begin and other methods set.
// RUN: rslc %s -o %t.bc && anysl-link %t.bc -o %t.so --width 1,8
// RUN: anysl-shade %t.so --shader surface:layered --grid 2x1 --width 1 --print Ci --print Oi --print seen > %t.1
// RUN: anysl-shade %t.so --shader surface:layered --grid 2x1 --width 8 --print Ci --print Oi --print seen > %t.8
// RUN: diff %t.1 %t.8
// RUN: FileCheck %s < %t.8
// RUN: anysl-shade %t.so --shader layered --grid 1x1 --width 8 --print Ci | FileCheck %s --check-prefix=FIRST
// RUN: anysl-shade %t.so --shader displacement:layered --grid 2x1 --print P --print N --param height=2 | FileCheck %s --check-prefix=MOVE
// RUN: anysl-shade %t.so --shader phases --grid 2x1 --print Ci --print Oi | FileCheck %s --check-prefix=PHASES
// RUN: not anysl-shade %t.so --shader light:layered 2>&1 | FileCheck %s --check-prefix=NONE
// RUN: anysl-info %t.so | FileCheck %s --check-prefix=INFO
// RUN: anysl-info %t.bc | FileCheck %s --check-prefix=INFO

class layered(float height = 1; color tint = (1, 2, 3); output varying float seen = 0) {
  uniform float scale;
  varying float amount = 5;
  vector moved;
  float offset = height * 100;              // a default may use parameters

  public void construct() { scale = 10; }
  public void begin() { amount += s * scale; }
  public void displacement(output point P; output normal N) {
    P += raise() * N;
    moved = vector(P);
    N = normal(0, 1, 0);
  }
  public void opacity(output color Oi) { Oi = Os * 0.5; }
  public void surface(output color Ci, Oi) {
    Ci = tint * this->amount + helper(offset);
    seen = zcomp(moved) * 10 + this->height;
    Oi *= 0.5;
  }
  // Neither order nor `public` matters.
  float raise() { return height * double(0.5); }
  private float double(float x) { return 2 * x; }
  color helper(float x) { return color(x, 0, 0); }
}

class phases() {
  struct Part { varying color c = 0; void set(color x) { c = x; } }
  Part diffuse;
  public void prelighting(output color Ci, Oi) { diffuse->set((s, 1, 0)); Oi = 0.25; }
  public void lighting(output color c; output color o) { c = diffuse->c * 2; }
  public void postlighting(output color Ci) { Ci += 1; }
}

// scale 10, amount 5 + 10 s, offset 100. The surface sees what displacement leaves in members, with its own P and N.
// CHECK:      0 0  Ci 105 10 15 Oi 0.25 0.25 0.25 seen 11
// CHECK-NEXT: 1 0  Ci 115 30 45 Oi 0.25 0.25 0.25 seen 11
// FIRST: Ci 105 10 15
// MOVE:      0 0  P 0 0 2 N 0 1 0
// MOVE-NEXT: 1 0  P 1 0 2 N 0 1 0
// PHASES:      0 0  Ci 1 3 1 Oi 0.25 0.25 0.25
// PHASES-NEXT: 1 0  Ci 3 3 1 Oi 0.25 0.25 0.25
// NONE: no shader 'light:layered'; it has surface:layered, displacement:layered, {{.*}}surface:phases
// INFO: surface layered
// INFO: displacement layered
// INFO: surface phases
