// Parameters: cells in order of declaration, defaults in init, varying ones point by point, outputs stored.
// RUN: rslc -S -o - %s | FileCheck %s

surface parameters(float a = 1; color c = (1, 2, 3); string name = "x"; matrix m = 2;
                   float list[2] = {5, 6}; float b = a * 2;
                   varying float v = 3; varying float w = s + v; output varying color out = 0;
                   float unused = 9) {
  // CHECK-LABEL: define void @parameters(
  // CHECK: load_param_float(ptr %a, ptr %ctx, i32 0)
  // CHECK: load_param_color(ptr %c, ptr %ctx, i32 1)
  // CHECK: load_param_string(ptr %name, ptr %ctx, i32 4)
  // CHECK: load_param_matrix(ptr %m, ptr %ctx, i32 5)
  // CHECK: [[E0:%[0-9]+]] = call ptr @anysl_element(ptr %list, ptr @anysl_type_float, i32 2, i32 0)
  // CHECK: load_param_float(ptr [[E0]], ptr %ctx, i32 21)
  // CHECK: load_param_float(ptr %{{[0-9]+}}, ptr %ctx, i32 22)
  // CHECK: load_param_float(ptr %b, ptr %ctx, i32 23)
  // CHECK: [[BOUND:%[0-9]+]] = call i1 @anysl_param_is_bound(ptr %ctx, i32 6)
  // CHECK: br i1 [[BOUND]], label %[[IS:[a-z0-9]+]], label %[[NOT:[a-z0-9]+]]
  // CHECK: [[IS]]:
  // CHECK: load_varying_float(ptr %v, ptr %ctx, i32 6, i32 0)
  // CHECK: [[NOT]]:
  // CHECK: load_param_float(ptr %v, ptr %ctx, i32 24)
  // CHECK: param_is_bound(ptr %ctx, i32 7)
  // CHECK: add_float(ptr [[SUM:%[0-9]+]], ptr %s, ptr %v)
  // CHECK: copy_float(ptr %w, ptr [[SUM]])
  // CHECK-NOT: %unused
  out = c;
  Ci = a + b + list[1] + v + w + comp(m, 0, 0);
  if (name == "y") Ci = 0;
  // CHECK: store_varying_color(ptr %ctx, i32 8, i32 0, ptr %out)
}

// CHECK-LABEL: define void @parameters.init(
// CHECK: [[SET:%[0-9]+]] = call i1 @anysl_param_is_set(ptr %ctx, i32 0)
// CHECK: br i1 [[SET]], label %[[NEXT:[a-z0-9]+]], label %default
// CHECK: store_param_float(ptr %ctx, i32 0, ptr
// CHECK: [[NEXT]]:
// CHECK: param_is_set(ptr %ctx, i32 1)
// CHECK: store_param_color(ptr %ctx, i32 1, ptr
// CHECK: store_param_string(ptr %ctx, i32 4, ptr
// CHECK: splat_matrix
// CHECK: store_param_matrix(ptr %ctx, i32 5, ptr
// CHECK: store_param_float(ptr %ctx, i32 21, ptr
// CHECK: store_param_float(ptr %ctx, i32 22, ptr
// A later default sees what the host has set earlier.
// CHECK: load_param_float(ptr [[A:%[a-z0-9]+]], ptr %ctx, i32 0)
// CHECK: mul_float(ptr [[B:%[0-9]+]], ptr [[A]], ptr
// CHECK: store_param_float(ptr %ctx, i32 23, ptr [[B]])
// CHECK: store_param_float(ptr %ctx, i32 24, ptr
// A default that varies is computed in the body.
// CHECK-NOT: param_is_set(ptr %ctx, i32 7)
// CHECK: param_is_set(ptr %ctx, i32 8)

// CHECK: !{!"list", !"float", !"uniform", i1 false, i32 2, i32 21}
// CHECK: !{!"out", !"color", !"varying", i1 true, i32 0, i32 26}
