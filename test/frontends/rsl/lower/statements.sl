// Control flow is plain branches; && and || evaluate both sides.
// RUN: rslc -S -o - %s | FileCheck %s

surface statements() {
  uniform float i, j;
  float x = 0;
  // CHECK: br label %loop
  // CHECK: loop:
  // CHECK: [[C:%[0-9]+]] = call i1 @anysl_lt_float(ptr %i
  // CHECK: br i1 [[C]], label %loop.body, label %loop.end
  for (i = 0; i < 3; i += 1) {
    while (x < 10) {
      // CHECK: [[BOTH:%[0-9]+]] = and i1
      // CHECK: br i1 [[BOTH]]
      // CHECK: br label %loop.end
      if (x > 5 && random() > 0.5)
        break 2;
      // CHECK: br label %loop.step
      if (x > 7)
        continue 2;
      x += 1;
    }
  }
  // CHECK: loop.end:
  // CHECK: xor i1
  // CHECK: call i1 @anysl_ne_float(ptr %x
  if (!(x > 1) || x)
    x = 2;
  // CHECK: br i1 %{{[0-9]+}}, label %true, label %false
  Ci = x > 1 ? Cs : 1;
}
