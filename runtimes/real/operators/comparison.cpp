//===-- runtimes/real/operators/comparison.cpp - conditions -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/runtime.h>

using namespace anysl;

// Conditions are joined with &, not &&: a branch would cost more than the comparison it saves.

namespace {

bool areEqual(const anysl_color &a, const anysl_color &b) {
  return (a.r == b.r) & (a.g == b.g) & (a.b == b.b);
}

bool areEqual(const anysl_vector &a, const anysl_vector &b) {
  return (a.x == b.x) & (a.y == b.y) & (a.z == b.z);
}

bool areEqual(const anysl_matrix &a, const anysl_matrix &b) {
  bool equal = true;
  repeat<16>([&](auto k) { equal &= a.m[k / 4][k % 4] == b.m[k / 4][k % 4]; });
  return equal;
}

bool areEqual(anysl_string a, anysl_string b) {
  if (a == b)
    return true;
  a = a ? a : "";
  b = b ? b : "";
  while (*a && *a == *b)
    ++a, ++b;
  return *a == *b;
}

} // namespace

bool anysl_lt_float(const anysl_float *a, const anysl_float *b) { return *a < *b; }
bool anysl_le_float(const anysl_float *a, const anysl_float *b) { return *a <= *b; }
bool anysl_gt_float(const anysl_float *a, const anysl_float *b) { return *a > *b; }
bool anysl_ge_float(const anysl_float *a, const anysl_float *b) { return *a >= *b; }
bool anysl_eq_float(const anysl_float *a, const anysl_float *b) { return *a == *b; }
bool anysl_ne_float(const anysl_float *a, const anysl_float *b) { return *a != *b; }
bool anysl_eq_color(const anysl_color *a, const anysl_color *b) { return areEqual(*a, *b); }
bool anysl_ne_color(const anysl_color *a, const anysl_color *b) { return !areEqual(*a, *b); }
bool anysl_eq_vector(const anysl_vector *a, const anysl_vector *b) { return areEqual(*a, *b); }
bool anysl_ne_vector(const anysl_vector *a, const anysl_vector *b) { return !areEqual(*a, *b); }
bool anysl_eq_matrix(const anysl_matrix *a, const anysl_matrix *b) { return areEqual(*a, *b); }
bool anysl_ne_matrix(const anysl_matrix *a, const anysl_matrix *b) { return !areEqual(*a, *b); }
bool anysl_eq_string(const anysl_string *a, const anysl_string *b) { return areEqual(*a, *b); }
bool anysl_ne_string(const anysl_string *a, const anysl_string *b) { return !areEqual(*a, *b); }
