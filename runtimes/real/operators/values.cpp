//===-- runtimes/real/operators/values.cpp - constants, construction, copies and components ---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/runtime.h>

using namespace anysl;

//===-- Constants and construction ------------------------------------------------------------===//

void anysl_const_float(anysl_float *result, double number) { *result = anysl_float(number); }

void anysl_const_string(anysl_string *result, const char *text) { *result = text; }

void anysl_make_color(anysl_color *result, const anysl_float *r, const anysl_float *g,
                      const anysl_float *b) {
  *result = {*r, *g, *b};
}

void anysl_make_vector(anysl_vector *result, const anysl_float *x, const anysl_float *y,
                       const anysl_float *z) {
  *result = {*x, *y, *z};
}

void anysl_make_matrix(anysl_matrix *result, const anysl_float *a, const anysl_float *b,
                       const anysl_float *c, const anysl_float *d, const anysl_float *e,
                       const anysl_float *f, const anysl_float *g, const anysl_float *h,
                       const anysl_float *i, const anysl_float *j, const anysl_float *k,
                       const anysl_float *l, const anysl_float *m, const anysl_float *n,
                       const anysl_float *o, const anysl_float *p) {
  *result = {{{*a, *b, *c, *d}, {*e, *f, *g, *h}, {*i, *j, *k, *l}, {*m, *n, *o, *p}}};
}

void anysl_splat_color(anysl_color *result, const anysl_float *x) { *result = {*x, *x, *x}; }

void anysl_splat_vector(anysl_vector *result, const anysl_float *x) { *result = {*x, *x, *x}; }

void anysl_splat_matrix(anysl_matrix *result, const anysl_float *x) {
  anysl_float zero(0);
  *result = {{{*x, zero, zero, zero},
              {zero, *x, zero, zero},
              {zero, zero, *x, zero},
              {zero, zero, zero, *x}}};
}

void anysl_color_from_vector(anysl_color *result, const anysl_vector *a) {
  *result = {a->x, a->y, a->z};
}

void anysl_vector_from_color(anysl_vector *result, const anysl_color *a) {
  *result = {a->r, a->g, a->b};
}

void anysl_float_from_test(anysl_float *result, bool condition) {
  *result = select(condition, anysl_float(1), anysl_float(0));
}

//===-- Copies --------------------------------------------------------------------------------===//

void anysl_copy_float(anysl_float *result, const anysl_float *a) { *result = *a; }
void anysl_copy_color(anysl_color *result, const anysl_color *a) { *result = *a; }
void anysl_copy_vector(anysl_vector *result, const anysl_vector *a) { *result = *a; }
void anysl_copy_matrix(anysl_matrix *result, const anysl_matrix *a) { *result = *a; }
void anysl_copy_string(anysl_string *result, const anysl_string *a) { *result = *a; }

//===-- Components ----------------------------------------------------------------------------===//
// The index is compared, not converted: i < 1 is component 0, i < 2 component 1, any other 2. So it
// is floored and clamped at once, no number is out of range, and nothing is addressed by it. NaN is
// 0.

namespace {

anysl_float pick(const anysl_float &i, const anysl_float &a, const anysl_float &b,
                 const anysl_float &c) {
  return select(i >= 2, c, select(i >= 1, b, a));
}

void replace(const anysl_float &i, const anysl_float &x, anysl_float &a, anysl_float &b,
             anysl_float &c) {
  auto isLast = i >= 2, isMiddle = i >= 1;
  a = select(isMiddle, a, x);
  b = select(isMiddle & !isLast, x, b);
  c = select(isLast, x, c);
}

/// Whether `i`, floored and clamped to [0, 3], is `k`.
auto names(const anysl_float &i, int k) {
  auto isBelow = i >= k + 1, reaches = i >= k;
  if (k == 3)
    isBelow = false;
  if (k == 0)
    reaches = true;
  return reaches & !isBelow;
}

} // namespace

void anysl_get_color(anysl_float *result, const anysl_color *a, const anysl_float *i) {
  *result = pick(*i, a->r, a->g, a->b);
}

void anysl_set_color(anysl_color *a, const anysl_float *i, const anysl_float *x) {
  replace(*i, *x, a->r, a->g, a->b);
}

void anysl_get_vector(anysl_float *result, const anysl_vector *a, const anysl_float *i) {
  *result = pick(*i, a->x, a->y, a->z);
}

void anysl_set_vector(anysl_vector *a, const anysl_float *i, const anysl_float *x) {
  replace(*i, *x, a->x, a->y, a->z);
}

void anysl_get_matrix(anysl_float *result, const anysl_matrix *a, const anysl_float *row,
                      const anysl_float *column) {
  anysl_float found(0);
  repeat<16>([&](auto k) {
    auto isRow = names(*row, k / 4), isColumn = names(*column, k % 4);
    found = select(isRow & isColumn, a->m[k / 4][k % 4], found);
  });
  *result = found;
}

void anysl_set_matrix(anysl_matrix *a, const anysl_float *row, const anysl_float *column,
                      const anysl_float *x) {
  anysl_float value = *x;
  repeat<16>([&](auto k) {
    anysl_float &element = a->m[k / 4][k % 4];
    auto isRow = names(*row, k / 4), isColumn = names(*column, k % 4);
    element = select(isRow & isColumn, value, element);
  });
}
