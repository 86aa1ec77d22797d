//===-- runtimes/real/operators/mathematics.cpp - functions of real numbers -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What these give outside their domain stands in <anysl/domain.h>.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/domain.h>
#include <anysl/runtime.h>

using namespace anysl;

namespace {

/// If one operand is NaN, both give the other one or NaN alike at every width: a comparison
/// decides.
constexpr auto smaller = [](const anysl_float &a, const anysl_float &b) { return smallerOf(a, b); };
constexpr auto larger = [](const anysl_float &a, const anysl_float &b) { return largerOf(a, b); };

} // namespace

int32_t anysl_index(const anysl_float *x) { return toInteger(floorOf(*x)); }

void anysl_abs(anysl_float *result, const anysl_float *x) { *result = absOf(*x); }
void anysl_floor(anysl_float *result, const anysl_float *x) { *result = floorOf(*x); }
void anysl_ceil(anysl_float *result, const anysl_float *x) { *result = ceilOf(*x); }
void anysl_sqrt(anysl_float *result, const anysl_float *x) { *result = squareRoot(*x); }
void anysl_inversesqrt(anysl_float *result, const anysl_float *x) {
  *result = inverseSquareRoot(*x);
}
void anysl_exp(anysl_float *result, const anysl_float *x) { *result = exponential(*x); }
void anysl_log(anysl_float *result, const anysl_float *x) { *result = logarithm(*x); }
void anysl_sin(anysl_float *result, const anysl_float *x) { *result = math::sin(*x); }
void anysl_cos(anysl_float *result, const anysl_float *x) { *result = math::cos(*x); }
void anysl_tan(anysl_float *result, const anysl_float *x) { *result = math::tan(*x); }
void anysl_asin(anysl_float *result, const anysl_float *x) {
  *result = math::asin(limitToUnit(*x));
}
void anysl_acos(anysl_float *result, const anysl_float *x) {
  *result = math::acos(limitToUnit(*x));
}
void anysl_atan(anysl_float *result, const anysl_float *x) { *result = math::atan(*x); }

void anysl_atan2(anysl_float *result, const anysl_float *y, const anysl_float *x) {
  *result = math::atan2(*y, *x);
}

void anysl_pow(anysl_float *result, const anysl_float *x, const anysl_float *y) {
  *result = power(*x, *y);
}

void anysl_mod(anysl_float *result, const anysl_float *a, const anysl_float *b) {
  *result = modulo(*a, *b);
}

void anysl_min_float(anysl_float *result, const anysl_float *a, const anysl_float *b) {
  *result = smaller(*a, *b);
}

void anysl_max_float(anysl_float *result, const anysl_float *a, const anysl_float *b) {
  *result = larger(*a, *b);
}

void anysl_min_color(anysl_color *result, const anysl_color *a, const anysl_color *b) {
  *result = each(smaller, *a, *b);
}

void anysl_max_color(anysl_color *result, const anysl_color *a, const anysl_color *b) {
  *result = each(larger, *a, *b);
}

void anysl_min_vector(anysl_vector *result, const anysl_vector *a, const anysl_vector *b) {
  *result = each(smaller, *a, *b);
}

void anysl_max_vector(anysl_vector *result, const anysl_vector *a, const anysl_vector *b) {
  *result = each(larger, *a, *b);
}
