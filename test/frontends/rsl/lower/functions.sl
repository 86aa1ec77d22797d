// Functions are expanded in place; arguments cannot alias what the body writes.
// RUN: rslc -S -o - %s | FileCheck %s

void swap(output float a, b) { float keep = a; a = b; b = keep; }
float early(float x) {
  if (x > 1)
    return 5;
  return x;
}
color tint() { extern color Cs; return 2 * Cs; }

surface functions(output varying float r = 0) {
  float x = s, y = t;
  // CHECK: copy_float(ptr %y, ptr %t)
  // CHECK-NEXT: copy_float(ptr [[A:%[a-z0-9]+]], ptr %x)
  // CHECK-NEXT: copy_float(ptr [[B:%[a-z0-9]+]], ptr %y)
  // CHECK: copy_float(ptr %keep, ptr [[A]])
  // CHECK: copy_float(ptr [[A]], ptr [[B]])
  // CHECK: copy_float(ptr [[B]], ptr %keep)
  // CHECK: copy_float(ptr %x, ptr [[A]])
  // CHECK: copy_float(ptr %y, ptr [[B]])
  swap(x, y);
  // CHECK: br i1 %{{[0-9]+}}, label %[[THEN:[a-z0-9]+]], label %[[ELSE:[a-z0-9]+]]
  // CHECK: [[THEN]]:
  // CHECK: copy_float(ptr %early, ptr
  // CHECK: br label %[[END:[a-z0-9.]+]]
  // CHECK: [[ELSE]]:
  // CHECK: copy_float(ptr %early, ptr %x)
  // CHECK: [[END]]:
  r = early(x);
  // A nested function sees the variables around it.
  void bump(float by) { extern float x; x += by; }
  // CHECK: copy_float(ptr [[BY:%[0-9]+]], ptr %x)
  // CHECK: add_float(ptr [[NEW:%[0-9]+]], ptr %x, ptr [[BY]])
  // CHECK: copy_float(ptr %x, ptr [[NEW]])
  bump(x);
  // CHECK: scale_color(ptr %{{[0-9]+}}, ptr %Cs, ptr
  Ci = tint();
  // The left operand is taken before the assignment on the right changes it.
  // CHECK: copy_float(ptr [[OLD:%[0-9]+]], ptr %x)
  // CHECK: copy_float(ptr %x, ptr
  // CHECK: add_float(ptr %{{[0-9]+}}, ptr [[OLD]], ptr %x)
  r = x + (x = 3);
  // An output argument of a built-in gets a slot of its own.
  // CHECK: fresnel(ptr %I, ptr %N, ptr {{.*}}, ptr [[KR:%[0-9]+]], ptr [[KT:%[0-9]+]], ptr %{{[0-9]+}}, ptr %{{[0-9]+}})
  // CHECK: copy_float(ptr %x, ptr [[KR]])
  // CHECK: copy_float(ptr %y, ptr [[KT]])
  fresnel(I, N, 1.5, x, y);
}
