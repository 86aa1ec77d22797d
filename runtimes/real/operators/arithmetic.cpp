//===-- runtimes/real/operators/arithmetic.cpp - sums, products, quotients --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/domain.h>
#include <anysl/runtime.h>

using namespace anysl;

// `result` may be an operand as well: everything is read before anything is written.

namespace {

constexpr auto negate = [](const anysl_float &a) { return -a; };
constexpr auto add = [](const anysl_float &a, const anysl_float &b) { return a + b; };
constexpr auto subtract = [](const anysl_float &a, const anysl_float &b) { return a - b; };
constexpr auto multiply = [](const anysl_float &a, const anysl_float &b) { return a * b; };
constexpr auto over = [](const anysl_float &a, const anysl_float &b) { return divide(a, b); };

} // namespace

//===-- Real numbers --------------------------------------------------------------------------===//

void anysl_neg_float(anysl_float *result, const anysl_float *a) { *result = -*a; }

void anysl_add_float(anysl_float *result, const anysl_float *a, const anysl_float *b) {
  *result = *a + *b;
}

void anysl_sub_float(anysl_float *result, const anysl_float *a, const anysl_float *b) {
  *result = *a - *b;
}

void anysl_mul_float(anysl_float *result, const anysl_float *a, const anysl_float *b) {
  *result = *a * *b;
}

void anysl_div_float(anysl_float *result, const anysl_float *a, const anysl_float *b) {
  *result = divide(*a, *b);
}

//===-- Colours -------------------------------------------------------------------------------===//

void anysl_neg_color(anysl_color *result, const anysl_color *a) { *result = each(negate, *a); }

void anysl_add_color(anysl_color *result, const anysl_color *a, const anysl_color *b) {
  *result = each(add, *a, *b);
}

void anysl_sub_color(anysl_color *result, const anysl_color *a, const anysl_color *b) {
  *result = each(subtract, *a, *b);
}

void anysl_mul_color(anysl_color *result, const anysl_color *a, const anysl_color *b) {
  *result = each(multiply, *a, *b);
}

void anysl_div_color(anysl_color *result, const anysl_color *a, const anysl_color *b) {
  *result = each(over, *a, *b);
}

void anysl_scale_color(anysl_color *result, const anysl_color *a, const anysl_float *x) {
  *result = *a * *x;
}

//===-- Points, vectors, normals --------------------------------------------------------------===//

void anysl_neg_vector(anysl_vector *result, const anysl_vector *a) { *result = -*a; }

void anysl_add_vector(anysl_vector *result, const anysl_vector *a, const anysl_vector *b) {
  *result = *a + *b;
}

void anysl_sub_vector(anysl_vector *result, const anysl_vector *a, const anysl_vector *b) {
  *result = *a - *b;
}

void anysl_mul_vector(anysl_vector *result, const anysl_vector *a, const anysl_vector *b) {
  *result = each(multiply, *a, *b);
}

void anysl_div_vector(anysl_vector *result, const anysl_vector *a, const anysl_vector *b) {
  *result = each(over, *a, *b);
}

void anysl_scale_vector(anysl_vector *result, const anysl_vector *a, const anysl_float *x) {
  *result = *a * *x;
}

void anysl_dot(anysl_float *result, const anysl_vector *a, const anysl_vector *b) {
  *result = dot(*a, *b);
}

void anysl_cross(anysl_vector *result, const anysl_vector *a, const anysl_vector *b) {
  *result = {a->y * b->z - a->z * b->y, a->z * b->x - a->x * b->z, a->x * b->y - a->y * b->x};
}

//===-- Matrices, element by element ----------------------------------------------------------===//

void anysl_neg_matrix(anysl_matrix *result, const anysl_matrix *a) { *result = each(negate, *a); }

void anysl_add_matrix(anysl_matrix *result, const anysl_matrix *a, const anysl_matrix *b) {
  *result = each(add, *a, *b);
}

void anysl_sub_matrix(anysl_matrix *result, const anysl_matrix *a, const anysl_matrix *b) {
  *result = each(subtract, *a, *b);
}

void anysl_scale_matrix(anysl_matrix *result, const anysl_matrix *a, const anysl_float *x) {
  anysl_float factor = *x;
  *result = each([factor](const anysl_float &element) { return element * factor; }, *a);
}
