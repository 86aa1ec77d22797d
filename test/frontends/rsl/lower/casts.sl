// `type "space" expr` transforms any expression; without a space it only converts.
// RUN: rslc -S -o - %s | FileCheck %s

surface casts(string mine = "world") {
  // CHECK: [[SHADER:%[0-9]+]], ptr @text
  // CHECK: space_matrix(ptr [[M:%[0-9]+]], ptr %ctx, ptr [[FROM:%[0-9]+]], ptr [[TO:%[0-9]+]])
  // CHECK: transform_point(ptr %{{[0-9]+}}, ptr [[M]], ptr
  point p = point "shader" (1, 2, 3);
  // CHECK: transform_vector(
  vector v = vector "world" N;
  // CHECK: transform_normal(
  normal n = normal "object" N;
  // CHECK: ctransform(ptr %{{[0-9]+}}, ptr %{{[0-9]+}}, ptr %{{[0-9]+}}, ptr
  color c = color "hsv" (0.1, s, t);
  // CHECK: mul_matrix(
  matrix m = matrix "shader" 1;
  // CHECK: transform_point(
  p = transform(mine, P);
  // CHECK: transform_point(
  p = transform("world", mine, P);
  // CHECK: transform_vector(ptr %{{[0-9]+}}, ptr %m, ptr %v)
  v = vtransform(m, v);
  // CHECK: color_from_vector(
  // CHECK: vector_from_color(
  c = v; v = c;
  // CHECK: splat_matrix(
  // CHECK: scale_matrix(
  // CHECK: div_matrix(
  m = (m + 2) * 3 / m;
  // CHECK: float_from_test(
  float b = s > t;
  Ci = c * b; P = p; N = n;
}
