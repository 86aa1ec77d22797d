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

/// A derivative as a number, with what is known of its own derivatives.
template <typename Real>
anysl_float asNumber(const Real &x) {
  constexpr int order = derivativeOrder<anysl_float>;
  Expansion<PlainOf<anysl_float>> result = {finite(valueOf(x)), 0, 0, 0, 0, 0};
  // Of an arithmetic that is calls nothing goes away, and each would look as if somebody read it.
  if constexpr (order == 1 && !isScalarOnly<Real>)
    result.u = result.v = anysl_unknown_derivative();
  if constexpr (order == 2) {
    result.u = finite(derivativeU(x)), result.v = finite(derivativeV(x));
    result.uu = result.uv = result.vv = anysl_unknown_derivative();
  }
  return expand<anysl_float>(result);
}

// Generic, so that only reals with derivatives are asked for their parts.
constexpr auto byU = []<typename Real>(const Real &x) {
  if constexpr (hasDerivatives<Real>)
    return asNumber(x.u);
  else
    return Real(0);
};
constexpr auto byV = []<typename Real>(const Real &x) {
  if constexpr (hasDerivatives<Real>)
    return asNumber(x.v);
  else
    return Real(0);
};

} // namespace

void anysl_Du_float(anysl_float *result, const anysl_float *x) { *result = byU(*x); }
void anysl_Dv_float(anysl_float *result, const anysl_float *x) { *result = byV(*x); }
void anysl_Du_color(anysl_color *result, const anysl_color *c) { *result = each(byU, *c); }
void anysl_Dv_color(anysl_color *result, const anysl_color *c) { *result = each(byV, *c); }
void anysl_Du_vector(anysl_vector *result, const anysl_vector *p) { *result = each(byU, *p); }
void anysl_Dv_vector(anysl_vector *result, const anysl_vector *p) { *result = each(byV, *p); }

void anysl_detach_float(anysl_float *result, const anysl_float *x) {
  *result = withDerivatives<anysl_float>(valueOf(*x), 0, 0);
}
