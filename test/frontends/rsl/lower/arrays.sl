// RUN: rslc -S -o - %s | FileCheck %s

float total(float list[]; output float n) {
  float sum = 0;
  uniform float i;
  for (i = 0; i < arraylength(list); i += 1)
    sum += list[i];
  n = arraylength(list);
  return sum;
}

surface arrays() {
  float a[3] = {1, 2};
  color c[2];
  float n;
  // CHECK: [[I:%[0-9]+]] = call i32 @anysl_index(ptr %s)
  // CHECK: [[E:%[0-9]+]] = call ptr @anysl_element(ptr %a, ptr @anysl_type_float, i32 3, i32 [[I]])
  // CHECK: add_float(ptr [[SUM:%[0-9]+]], ptr [[E]], ptr
  // CHECK: copy_float(ptr [[E]], ptr [[SUM]])
  a[s] += 1;
  // CHECK: [[C1:%[0-9]+]] = call ptr @anysl_element(ptr %c, ptr @anysl_type_color, i32 2, i32 1)
  // CHECK: set_color(ptr [[C1]], ptr
  c[1][2] = 0.5;
  // The length of the argument, then its elements.
  // CHECK: anysl_const_float(ptr [[N:%[0-9]+]], double 3.000000e+00)
  // CHECK: lt_float(ptr %i, ptr [[N]])
  // CHECK: element(ptr %a, ptr @anysl_type_float, i32 3, i32 %
  n = total(a, n);
  float b[3] = a;
  // CHECK: [[B:%[0-9]+]] = call ptr @anysl_element(ptr %b, ptr @anysl_type_float, i32 3, i32 2)
  // CHECK: [[A:%[0-9]+]] = call ptr @anysl_element(ptr %a, ptr @anysl_type_float, i32 3, i32 2)
  // CHECK: copy_float(ptr [[B]], ptr [[A]])
  b = a;
  Ci = c[1] * b[0] * n;
}
