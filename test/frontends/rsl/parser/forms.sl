// Forms that shaders use and that are easy to leave out of a grammar.
// RUN: rslc -S -o - %s | FileCheck %s

// A function without a result type; parameters in groups; a comma before a new type.
split(float a, b; color c, float d; output float e) {
  e = a + b + comp(c, 0) + d;
}

// `light`, `surface`, `volume`, `incident` are names like any other.
// CHECK: define void @forms(ptr %ctx)
surface forms(float light = 1, surface = 2; color volume = 3, string name = "x";;
              output varying float incident = 0; varying float list[3] = {1, 2, 3}) {
  float i, j;
  float e = 0;
  split(1, 2, color 3, 4, e);
  // CHECK: loop:
  for (i = 0, j = 3; i < j; i += 1, j -= 1)
    e += i;
  for (;;) { break; }
  for (float k = 0; k < 2; k += 1)
    if (k > 0) { continue; } else ;
  while (e > 0) e -= 1;
  point p = (1, 2, 3);
  matrix m = (1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1);
  // An array's element, a triple's component.
  list[1] = list[2] + p[0];
  p[1] = 2;
  // A nested function, with and without a result type.
  float twice(float x) { return 2 * x; }
  reset(output float x) { x = 0; }
  reset(e);
  incident = twice(e) + +e;
  Ci = light * surface * volume * color(list[1]);
  // The result of a condition as a number.
  Oi = (e > 1) + !(e < 2);
  // CHECK: anysl_store_varying_float(ptr %ctx, i32 4, i32 0, ptr %incident)
  return;
}
