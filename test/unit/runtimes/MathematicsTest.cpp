//===-- test/unit/runtimes/MathematicsTest.cpp - functions of real numbers --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <cfloat>
#include <random>

TEST_CASE("an array index is floored, and defined for every number") {
  CHECK(call<anysl_index>(Real(2.9)) == 2);
  CHECK(call<anysl_index>(Real(-0.1)) == -1);
  CHECK(call<anysl_index>(Real(-3)) == -3);
  CHECK(call<anysl_index>(notANumber) == 0);
  CHECK(call<anysl_index>(Real(3e9)) == call<anysl_index>(largest));
  CHECK(call<anysl_index>(Real(3e9)) > 2147480000);
  CHECK(call<anysl_index>(Real(-3e9)) < -2147480000);
  CHECK(call<anysl_index>(infinite) == call<anysl_index>(largest));
}

TEST_CASE("elementary functions are the math tier's inside their domain") {
  const Real x = Real(0.7);
  const double y = plain(x);
  CHECK(call<anysl_abs>(Real(-0.7)) == x);
  CHECK(call<anysl_floor>(Real(-1.5)) == -2);
  CHECK(call<anysl_ceil>(Real(-1.5)) == -1);
  CHECK(call<anysl_sqrt>(x) == near(std::sqrt(y)));
  CHECK(call<anysl_inversesqrt>(x) == near(1 / std::sqrt(y)));
  CHECK(call<anysl_exp>(x) == near(std::exp(y)));
  CHECK(call<anysl_log>(x) == near(std::log(y)));
  CHECK(call<anysl_sin>(x) == near(std::sin(y)));
  CHECK(call<anysl_cos>(x) == near(std::cos(y)));
  CHECK(call<anysl_tan>(x) == near(std::tan(y)));
  CHECK(call<anysl_asin>(x) == near(std::asin(y)));
  CHECK(call<anysl_acos>(x) == near(std::acos(y)));
  CHECK(call<anysl_atan>(x) == near(std::atan(y)));
  CHECK(call<anysl_atan2>(x, Real(-2)) == near(std::atan2(y, -2.0)));
}

TEST_CASE("the arc tangent of two numbers has C's quadrants") {
  const double pi = 3.14159265358979323846;
  CHECK(call<anysl_atan2>(0, 0) == 0);
  CHECK(call<anysl_atan2>(0, -1) == near(pi));
  CHECK(call<anysl_atan2>(Real(-0.0), -1) == near(-pi));
  CHECK(call<anysl_atan2>(infinite, infinite) == near(pi / 4));
  CHECK(call<anysl_atan2>(-1, 0) == near(-pi / 2));
}

TEST_CASE("outside its domain a function gives a finite number") {
  for (Real x : {Real(-1e-9), Real(-1), -largest}) {
    CHECK(call<anysl_sqrt>(x) == 0);
    CHECK(call<anysl_inversesqrt>(x) == 0);
    CHECK(call<anysl_log>(x) == 0);
  }
  CHECK(call<anysl_inversesqrt>(0) == 0);
  CHECK(call<anysl_log>(0) == 0);
  CHECK(call<anysl_log>(Real(-0.0)) == 0);
  CHECK(anysl::isFinite(call<anysl_log>(Limits::denorm_min())));
  CHECK(call<anysl_exp>(Real(1e6)) == largest);
  CHECK(plain(call<anysl_exp>(Real(-1e6))) == 0);
  Real above = 1 + spacing;
  CHECK(call<anysl_acos>(above) == 0);
  CHECK(call<anysl_acos>(-above) == near(std::acos(-1.0)));
  CHECK(call<anysl_asin>(above) == near(std::asin(1.0)));
  CHECK(call<anysl_asin>(-7) == near(std::asin(-1.0)));
  CHECK(anysl::isNaN(call<anysl_sqrt>(notANumber)));
  CHECK(anysl::isNaN(call<anysl_log>(notANumber)));
  CHECK(anysl::isNaN(call<anysl_acos>(notANumber)));
}

TEST_CASE("powers 0, 1 and 2 are exact, and a negative base has integer powers only") {
  for (Real x : {Real(0), Real(-0.3), Real(0.1), Real(123.456), largest, infinite, notANumber})
    CHECK(call<anysl_pow>(x, 0) == 1);
  for (Real x : {Real(0.1), Real(123.456), Real(-7.3), Real(0)}) {
    CHECK(call<anysl_pow>(x, 1) == x);
    CHECK(call<anysl_pow>(x, 2) == x * x);
  }
  CHECK(call<anysl_pow>(2, 10) == near(1024));
  CHECK(call<anysl_pow>(2, Real(0.5)) == near(std::sqrt(2.0)));
  CHECK(call<anysl_pow>(-2, 3) == near(-8));
  CHECK(call<anysl_pow>(-2, -3) == near(-0.125));
  CHECK(call<anysl_pow>(-2, 4) == near(16));
  CHECK(call<anysl_pow>(-2, Real(0.5)) == 0);
  CHECK(call<anysl_pow>(0, -1) == 0);
  CHECK(call<anysl_pow>(0, 3) == 0);
  CHECK(call<anysl_pow>(10, 5000) == largest);
  CHECK(call<anysl_pow>(-10, 5001) == -largest);
  CHECK(anysl::isNaN(call<anysl_pow>(notANumber, 3)));
  CHECK(anysl::isNaN(call<anysl_pow>(3, notANumber)));
  CHECK(anysl::isNaN(call<anysl_pow>(-3, notANumber)));
}

TEST_CASE("mod has the sign of its second operand and stays below it") {
  CHECK(call<anysl_mod>(Real(5.5), 2) == 1.5);
  CHECK(call<anysl_mod>(Real(-1.5), 1) == 0.5);
  CHECK(call<anysl_mod>(-5, 3) == 1);
  CHECK(call<anysl_mod>(5, -3) == -1);
  CHECK(call<anysl_mod>(-5, -3) == -2);
  CHECK(call<anysl_mod>(6, 3) == 0);
  CHECK(call<anysl_mod>(-6, 3) == 0);
  CHECK(call<anysl_mod>(5, 0) == 0);
  CHECK(call<anysl_mod>(0, 0) == 0);
  Real almost = call<anysl_mod>(Real(-1e-20), 1);
  CHECK(almost < 1);
  CHECK(plain(almost) == near(1, 1));
}

TEST_CASE("mod stays in range for every finite operand") {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> exponent(-44, 38), mantissa(1, 2);
  for (int i = 0; i < 200000; ++i) {
    Real a = Real((i & 1 ? -1 : 1) * mantissa(generator) * std::pow(10, exponent(generator)));
    Real b = Real(mantissa(generator) * std::pow(10, exponent(generator)));
    Real r = call<anysl_mod>(a, b);
    if (!(r >= 0 && r < b))
      FAIL("mod(" << a << ", " << b << ") = " << r);
    // While the quotient is small the result is the true one, rounded; next to 0 and b it may be
    // either.
    if (std::abs(plain(a) / plain(b)) < 1e4) {
      long double exact = std::fmod((long double)plain(a), (long double)plain(b));
      exact = exact < 0 ? exact + plain(b) : exact;
      long double error = std::abs(exact - plain(r));
      error = std::min(error, std::abs(error - plain(b)));
      if (plain(b) > Limits::min() && error > plain(b) * spacing)
        FAIL("mod(" << a << ", " << b << ") = " << r << ", not " << double(exact));
    }
  }
}

TEST_CASE("minimum and maximum work component by component") {
  CHECK(call<anysl_min_float>(1, 2) == 1);
  CHECK(call<anysl_min_float>(2, 1) == 1);
  CHECK(call<anysl_max_float>(1, 2) == 2);
  CHECK(call<anysl_max_float>(2, 1) == 2);
  checkColor(call<anysl_min_color>(anysl_color(1, 5, 3), anysl_color(4, 2, 3)), 1, 2, 3);
  checkColor(call<anysl_max_color>(anysl_color(1, 5, 3), anysl_color(4, 2, 3)), 4, 5, 3);
  checkVector(call<anysl_min_vector>(anysl_vector(1, 5, 3), anysl_vector(4, 2, 3)), 1, 2, 3);
  checkVector(call<anysl_max_vector>(anysl_vector(1, 5, 3), anysl_vector(4, 2, 3)), 4, 5, 3);
}
