//===-- test/unit/math/SpecialValueTests.cpp - what C's Annex F asks of every tier ------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/verify-math/Tiers.h"
#include "tools/verify-math/Truth.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace anysl::verify;

namespace {

constexpr double Inf = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

float ofFloat(const Tier &t, std::string_view name, float x, float y = 0) {
  float result;
  t.batches[findFunction(name) - functions().data()].ofFloats(&x, &y, &result, 1);
  return result;
}
double ofDouble(const Tier &t, std::string_view name, double x, double y = 0) {
  double result;
  t.batches[findFunction(name) - functions().data()].ofDoubles(&x, &y, &result, 1);
  return result;
}

bool same(double a, double b) {
  return std::isnan(a) || std::isnan(b) ? std::isnan(a) && std::isnan(b)
                                        : a == b && std::signbit(a) == std::signbit(b);
}

/// Checks an exact value in every tier, for float and double.
void exactly(std::string_view name, double x, double y, double wanted) {
  for (const Tier &t : tiers()) {
    INFO(t.name << ' ' << name << '(' << x << ", " << y
                << ") = " << ofFloat(t, name, float(x), float(y)) << ", in double "
                << ofDouble(t, name, x, y) << ", not " << wanted);
    CHECK(same(ofFloat(t, name, float(x), float(y)), wanted));
    CHECK(same(ofDouble(t, name, x, y), wanted));
  }
}
void exactly(std::string_view name, double x, double wanted) { exactly(name, x, 0, wanted); }

} // namespace

TEST_CASE("trigonometric functions of zero, infinity and NaN") {
  for (const char *odd : {"sin", "tan", "asin", "atan", "sinh", "tanh", "cbrt"}) {
    exactly(odd, 0.0, 0.0);
    exactly(odd, -0.0, -0.0);
    exactly(odd, NaN, NaN);
  }
  exactly("cos", 0.0, 1);
  exactly("cos", -0.0, 1);
  for (const char *name : {"sin", "cos", "tan", "asin", "acos"}) {
    exactly(name, Inf, NaN);
    exactly(name, -Inf, NaN);
  }
  exactly("acos", 1, 0.0);
  for (const char *name : {"asin", "acos"}) {
    exactly(name, 1.5, NaN);
    exactly(name, -1.5, NaN);
  }
}

TEST_CASE("exponentials and hyperbolic functions of zero, infinity and NaN") {
  for (const char *name : {"exp", "exp2"}) {
    exactly(name, 0.0, 1);
    exactly(name, -0.0, 1);
    exactly(name, Inf, Inf);
    exactly(name, -Inf, 0.0);
    exactly(name, NaN, NaN);
    exactly(name, 1e30, Inf);
    exactly(name, -1e30, 0.0);
  }
  exactly("cosh", 0.0, 1);
  exactly("cosh", -Inf, Inf);
  exactly("sinh", Inf, Inf);
  exactly("sinh", -Inf, -Inf);
  exactly("tanh", Inf, 1);
  exactly("tanh", -Inf, -1);
}

TEST_CASE("powers of two come out of exp2 exactly, down to the smallest denormal") {
  for (int n = -149; n <= 127; ++n)
    exactly("exp2", n, std::ldexp(1.0, n));
}

TEST_CASE("logarithms of zero, negative numbers, one, infinity and NaN") {
  for (const char *name : {"log", "log2", "log10"}) {
    exactly(name, 0.0, -Inf);
    exactly(name, -0.0, -Inf);
    exactly(name, -1, NaN);
    exactly(name, -Inf, NaN);
    exactly(name, 1, 0.0);
    exactly(name, Inf, Inf);
    exactly(name, NaN, NaN);
  }
}

TEST_CASE("pow's exact cases") {
  for (double x : {0.0, -0.0, 1.0, -1.0, 0.3, -7.0, Inf, -Inf, NaN}) {
    exactly("pow", x, 0.0, 1);
    exactly("pow", x, -0.0, 1);
  }
  for (double y : {0.5, -3.0, 1e30, Inf, -Inf, NaN})
    exactly("pow", 1, y, 1);
  for (const Tier &t : tiers())
    for (float x : {0.1f, 3.7f, -2.3f, 1e-20f, 1.00001f, 65535.0f}) {
      INFO(t.name << ' ' << x);
      CHECK(ofFloat(t, "pow", x, 1) == x);
      CHECK(ofFloat(t, "pow", x, 2) == x * x);
      CHECK(ofDouble(t, "pow", x, 1) == double(x));
      CHECK(ofDouble(t, "pow", x, 2) == double(x) * double(x));
    }
}

TEST_CASE("pow of zero, infinity and negative numbers as in C") {
  exactly("pow", 0.0, -1, Inf);
  exactly("pow", -0.0, -1, -Inf);
  exactly("pow", -0.0, -2, Inf);
  exactly("pow", -0.0, 3, -0.0);
  exactly("pow", 0.0, 0.5, 0.0);
  exactly("pow", 0.0, -Inf, Inf);
  exactly("pow", -1, Inf, 1);
  exactly("pow", -1, -Inf, 1);
  exactly("pow", 0.5, Inf, 0.0);
  exactly("pow", 0.5, -Inf, Inf);
  exactly("pow", -2, Inf, Inf);
  exactly("pow", -Inf, 3, -Inf);
  exactly("pow", -Inf, -3, -0.0);
  exactly("pow", -Inf, 0.5, Inf);
  exactly("pow", Inf, -0.5, 0.0);
  exactly("pow", -2, 0.5, NaN);
  exactly("pow", NaN, 1, NaN);
  exactly("pow", -2, 3, -8);
  exactly("pow", -2, 4, 16);
}

TEST_CASE("an angle just below the middle of two denormal floats is rounded down") {
  // atan(t) is less than t, which is 1.5 times the smallest float; 3.5 times; and 2.5 times.
  const Tier &cr = *findTier("cr");
  CHECK(ofFloat(cr, "atan2", 0x3p-149f, 2) == 0x1p-149f);
  CHECK(ofFloat(cr, "atan2", -0x7p-149f, 2) == -0x3p-149f);
  CHECK(ofFloat(cr, "atan2", 0x5p-149f, 2) == 0x2p-149f);
}

TEST_CASE("the tier cr rounds correctly where a double is on the wrong side of a middle") {
  const Tier &cr = *findTier("cr");
  CHECK(ofFloat(cr, "asin", 0x1.107434p-1f) == 0x1.1f4b64p-1f);
  CHECK(ofFloat(cr, "asin", -0x1.107434p-1f) == -0x1.1f4b64p-1f);
  CHECK(ofFloat(cr, "acos", 0x1.110b46p-26f) == 0x1.921fb6p+0f);
  CHECK(ofFloat(cr, "acos", 0x1.04c444p-12f) == 0x1.920f6ap+0f);
  CHECK(ofFloat(cr, "atan", 0x1.1ad646p-4f) == 0x1.1a6386p-4f);
  CHECK(ofFloat(cr, "atan", -0x1.1ad646p-4f) == -0x1.1a6386p-4f);
  CHECK(ofFloat(cr, "exp2", 0x1.853a6ep-9f) == 0x1.00870ap+0f);
  CHECK(ofFloat(cr, "exp2", -0x1.e7526ep-6f) == 0x1.f58d62p-1f);
  CHECK(ofFloat(cr, "log", 0x1.827a74p-7f) == -0x1.1c2b1ep+2f);
  CHECK(ofFloat(cr, "log", 0x1.2f1fd6p+3f) == 0x1.1fcbcep+1f);
  CHECK(ofFloat(cr, "log", 0x1.bacb4ap+25f) == 0x1.1e0696p+4f);
  CHECK(ofFloat(cr, "log", 0x1.b121a6p+76f) == 0x1.a9a3f2p+5f);
  CHECK(ofFloat(cr, "log", 0x1.6351d8p+95f) == 0x1.08b512p+6f);
  CHECK(ofFloat(cr, "log10", 0x1.fddcf4p-98f) == -0x1.d33a46p+4f);
}

TEST_CASE("atan2's table") {
  exactly("atan2", 0.0, 0.0, 0.0);
  exactly("atan2", -0.0, 0.0, -0.0);
  exactly("atan2", 0.0, 1, 0.0);
  exactly("atan2", -0.0, Inf, -0.0);
  exactly("atan2", NaN, 1, NaN);
  exactly("atan2", 1, NaN, NaN);
  const double pi = 3.14159265358979323846;
  struct {
    double y, x, angle;
  } cases[] = {{0.0, -0.0, pi},      {-0.0, -0.0, -pi},       {0.0, -1, pi},
               {-0.0, -Inf, -pi},    {1, 0.0, pi / 2},        {-1, -0.0, -pi / 2},
               {Inf, 3, pi / 2},     {-Inf, -3, -pi / 2},     {Inf, Inf, pi / 4},
               {-Inf, Inf, -pi / 4}, {Inf, -Inf, 3 * pi / 4}, {1, -Inf, pi},
               {3, 3, pi / 4},       {-2, -2, -3 * pi / 4}};
  for (const Tier &t : tiers())
    for (auto c : cases) {
      INFO(t.name << " atan2(" << c.y << ", " << c.x << ')');
      double bound = t.bound > 0 ? 0x1p-21 : 0x1p-12;
      CHECK(ofFloat(t, "atan2", float(c.y), float(c.x)) ==
            Approx(c.angle).epsilon(bound).margin(0));
      CHECK(ofDouble(t, "atan2", c.y, c.x) == Approx(c.angle).epsilon(0x1p-50).margin(0));
    }
}

TEST_CASE("roots, reciprocals and lengths of zero, infinity and negative numbers") {
  exactly("sqrt", -0.0, -0.0);
  exactly("sqrt", -1, NaN);
  exactly("sqrt", Inf, Inf);
  exactly("inversesqrt", 0.0, Inf);
  exactly("inversesqrt", -0.0, -Inf);
  exactly("inversesqrt", Inf, 0.0);
  exactly("inversesqrt", -1, NaN);
  exactly("inversesqrt", 16, 0.25);
  exactly("reciprocal", 0.0, Inf);
  exactly("reciprocal", -0.0, -Inf);
  exactly("reciprocal", -Inf, -0.0);
  exactly("divide", 0.0, 0.0, NaN);
  exactly("divide", -1, 0.0, -Inf);
  exactly("cbrt", Inf, Inf);
  exactly("cbrt", -Inf, -Inf);
  exactly("hypot", Inf, NaN, Inf);
  exactly("hypot", NaN, -Inf, Inf);
  exactly("hypot", NaN, 1, NaN);
  exactly("hypot", 0.0, -0.0, 0.0);
}

TEST_CASE("exact roots and lengths come out exactly") {
  for (int n = 1; n <= 200; ++n) {
    exactly("sqrt", n * n, n);
    exactly("hypot", 3 * n, -4 * n, 5 * n);
  }
}
