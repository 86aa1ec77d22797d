//===-- runtimes/real/operators/derivatives.cpp - derivatives as numbers ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Here a derivative becomes a number that a shader sees. Where it has grown beyond all numbers on
// the way, it is 0, as at a singular point.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/runtime.h>

using namespace anysl;

namespace {

/// 0 for what is infinite or NaN.
template <typename T>
T finite(T x) {
  return isFinite(x) ? x : T(0);
}

constexpr auto byU = [](const anysl_float &x) { return anysl_float(finite(derivativeU(x))); };
constexpr auto byV = [](const anysl_float &x) { return anysl_float(finite(derivativeV(x))); };

} // namespace

void anysl_Du_float(anysl_float *result, const anysl_float *x) { *result = byU(*x); }
void anysl_Dv_float(anysl_float *result, const anysl_float *x) { *result = byV(*x); }
void anysl_Du_color(anysl_color *result, const anysl_color *c) { *result = each(byU, *c); }
void anysl_Dv_color(anysl_color *result, const anysl_color *c) { *result = each(byV, *c); }
void anysl_Du_vector(anysl_vector *result, const anysl_vector *p) { *result = each(byU, *p); }
void anysl_Dv_vector(anysl_vector *result, const anysl_vector *p) { *result = each(byV, *p); }
