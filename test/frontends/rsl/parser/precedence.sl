// How tightly operators bind, tightest first: ! and unary -, casts, '.', * and /, ^, + and -, comparisons,
// &&, ||, ?:, assignment.
// RUN: rslc -S -o - %s | FileCheck %s

surface precedence() {
  vector A = (1, 2, 3), B = (4, 5, 6);
  float x = s, y = t;

  // A*2^B is (A*2)^B
  // CHECK: [[SCALED:%[0-9]+]], ptr %A, ptr
  // CHECK: anysl_cross(ptr %{{[0-9]+}}, ptr [[SCALED]], ptr %B)
  vector c = A * 2 ^ B;

  // A + A^B is A + (A^B)
  // CHECK: anysl_cross(ptr [[CROSS:%[0-9]+]], ptr %A, ptr %B)
  // CHECK: anysl_add_vector(ptr %{{[0-9]+}}, ptr %A, ptr [[CROSS]])
  vector d = A + A ^ B;

  // x * A.B is x * (A.B)
  // CHECK: anysl_dot(ptr [[DOT:%[0-9]+]], ptr %A, ptr %B)
  // CHECK: anysl_mul_float(ptr %{{[0-9]+}}, ptr %x, ptr [[DOT]])
  float e = x * A.B;

  // -A.B is (-A).B
  // CHECK: anysl_neg_vector(ptr [[NEG:%[0-9]+]], ptr %A)
  // CHECK: anysl_dot(ptr %{{[0-9]+}}, ptr [[NEG]], ptr %B)
  float f = -A.B;

  // x - y - x is (x - y) - x
  // CHECK: anysl_sub_float(ptr [[DIFF:%[0-9]+]], ptr %x, ptr %y)
  // CHECK: anysl_sub_float(ptr %{{[0-9]+}}, ptr [[DIFF]], ptr %x)
  float g = x - y - x;

  // A cast takes the next operand only: (float x) + y
  // CHECK: anysl_splat_color(ptr [[CAST:%[0-9]+]], ptr %x)
  // CHECK: anysl_splat_color(ptr [[OTHER:%[0-9]+]], ptr %y)
  // CHECK: anysl_add_color(ptr %{{[0-9]+}}, ptr [[CAST]], ptr [[OTHER]])
  color h = color x + y;

  // x < y == y < x compares two conditions; && binds tighter than ||.
  // CHECK: [[LT:%[0-9]+]] = call i1 @anysl_lt_float(ptr %x, ptr %y)
  // CHECK: [[GT:%[0-9]+]] = call i1 @anysl_gt_float(ptr %x, ptr %y)
  // CHECK: [[EQ:%[0-9]+]] = call i1 @anysl_eq_float(ptr %x, ptr %y)
  // CHECK: [[AND:%[0-9]+]] = and i1 [[GT]], [[EQ]]
  // CHECK: or i1 [[LT]], [[AND]]
  if (x < y || x > y && x == y)
    Ci = 1;

  // x = y = 2 assigns from the right.
  // CHECK: anysl_const_float(ptr [[TWO:%[0-9]+]], double 2.000000e+00)
  // CHECK: anysl_copy_float(ptr %y, ptr [[TWO]])
  // CHECK: anysl_copy_float(ptr %x, ptr %y)
  x = y = 2;
}
