//===-- test/unit/runtimes/DerivativesTest.cpp - operators that read derivatives --------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"

using namespace anysl;

extern "C" anysl_number anysl_unknown_derivative(void);
anysl_number anysl_unknown_derivative() { return 0; }

namespace {

/// x, which changes by u and v as given, if a real can.
Real changing(anysl_number x, anysl_number u, anysl_number v) {
  return withDerivatives<Real>(x, u, v);
}

/// What a real without derivatives gives in place of a derivative.
anysl_number expected(anysl_number derivative) { return hasDerivatives<Real> ? derivative : 0; }

bool isConstant(const Real &x) { return derivativeU(x) == 0 && derivativeV(x) == 0; }

} // namespace

TEST_CASE("a derivative is a number, and a plain number has none") {
  Real x = changing(1, 2, 3), y = changing(4, 5, 6), z = changing(7, 8, 9);
  CHECK(valueOf(x) == 1);
  CHECK(valueOf(call<anysl_Du_float>(x)) == expected(2));
  CHECK(valueOf(call<anysl_Dv_float>(x)) == expected(3));
  CHECK(isConstant(call<anysl_Du_float>(x)));
  anysl_color c(x, y, z), cu = call<anysl_Du_color>(c), cv = call<anysl_Dv_color>(c);
  CHECK(valueOf(cu.r) == expected(2));
  CHECK(valueOf(cu.g) == expected(5));
  CHECK(valueOf(cv.b) == expected(9));
  anysl_vector p(x, y, z), pu = call<anysl_Du_vector>(p), pv = call<anysl_Dv_vector>(p);
  CHECK(valueOf(pu.z) == expected(8));
  CHECK(valueOf(pv.x) == expected(3));
  CHECK(valueOf(pv.y) == expected(6));
  CHECK(isConstant(pv.y));
}

TEST_CASE("a derivative beyond all numbers is 0") {
  Real x = changing(1, Limits::infinity(), Limits::quiet_NaN());
  CHECK(valueOf(call<anysl_Du_float>(x)) == 0);
  CHECK(valueOf(call<anysl_Dv_float>(x)) == 0);
  x = changing(1, -Limits::infinity(), Limits::max());
  CHECK(valueOf(call<anysl_Du_float>(x)) == 0);
  CHECK(valueOf(call<anysl_Dv_float>(x)) == expected(Limits::max()));
}

TEST_CASE("a number that is detached is a constant") {
  Real x = call<anysl_detach_float>(changing(3, 1, 2));
  CHECK(valueOf(x) == 3);
  CHECK(isConstant(x));
}

TEST_CASE("a derivative has derivatives where numbers carry those of second order") {
  // f = u^2 v at (2, 3): f_u = 2 u v, f_v = u^2.
  Real u = changing(2, 1, 0), v = changing(3, 0, 1), f = u * u * v;
  constexpr bool carried = derivativeOrder<Real> > 1;
  Real fu = call<anysl_Du_float>(f), fv = call<anysl_Dv_float>(f);
  CHECK(valueOf(fu) == expected(12));
  CHECK(valueOf(fv) == expected(4));
  CHECK(valueOf(call<anysl_Du_float>(fu)) == (carried ? 6 : 0));
  CHECK(valueOf(call<anysl_Dv_float>(fu)) == (carried ? 4 : 0));
  CHECK(valueOf(call<anysl_Du_float>(fv)) == (carried ? 4 : 0));
  CHECK(valueOf(call<anysl_Dv_float>(fv)) == 0);
}
