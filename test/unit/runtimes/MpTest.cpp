//===-- test/unit/runtimes/MpTest.cpp - numbers of hundreds of bits ---------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The tests of all reals hold the operators of this one to the digits of double. Here are the
// digits beyond.
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <anysl/domain.h>
#include <cstring>
#include <random>

using namespace anysl;

namespace {

/// Whether two numbers agree to within some units of the last of 200 bits.
bool agree(const Mp &a, const Mp &b, double units = 2) {
  return absOf(a - b) <= absOf(b) * Mp(units * 0x1p-199);
}

/// Numbers whose digits use all of a double's.
std::vector<Mp> numbers(double low, double high) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> number(low, high);
  std::vector<Mp> result;
  for (int i = 0; i < 200; ++i)
    result.push_back(number(generator));
  return result;
}

/// Pi as four doubles, each the nearest to what those before it leave.
Mp pi() {
  Mp sum = 0;
  for (double part : {0x1.4cf98e804177dp-163, -0x1.f1976b7ed8fbcp-109, 0x1.1a62633145c07p-53,
                      0x1.921fb54442d18p+1})
    sum = sum + Mp(part);
  return sum;
}

} // namespace

TEST_CASE("variables are 0 before anything is assigned to them") {
  Mp x;
  std::memset(&x, 0, sizeof x);
  CHECK(x == 0);
  CHECK(x + 3 == 3);
  CHECK_FALSE(hasSign(x));
}

TEST_CASE("numbers of a host come back as they were") {
  for (double x : {0.0, 1.0, -1.5, 0.1, 1e300, -1e-300, 5e-324, HUGE_VAL, -HUGE_VAL})
    CHECK(double(Mp(x)) == x);
  CHECK(std::signbit(double(Mp(-0.0))));
  CHECK(std::isnan(double(Mp(NAN))));
  CHECK(double(Mp(1e300) * Mp(1e300)) == HUGE_VAL);
  CHECK(double(Mp(1) + Mp(0x1p-60)) == 1);
}

TEST_CASE("sums and products have 200 bits") {
  Mp third = divide(Mp(1), Mp(3)), tiny = Mp(0x1p-190);
  CHECK(agree(third + third + third, 1));
  CHECK(third != Mp(1 / 3.0));
  CHECK((1 + tiny) - 1 == tiny);
  CHECK((1 + tiny) * (1 - tiny) == 1);
  CHECK(fusedMultiplyAdd(1 + tiny, 1 - tiny, -1) == -(tiny * tiny));
  CHECK(1 - justBelow(Mp(1)) == Mp(0x1p-200));
}

TEST_CASE("elementary functions have 200 bits") {
  CHECK(agree(4 * math::atan(Mp(1)), pi(), 4));
  for (const Mp &x : numbers(-3, 3)) {
    Mp s = math::sin(x), c = math::cos(x);
    CHECK(agree(s * s + c * c, 1, 4));
    CHECK(agree(math::tan(x) * c, s, 4));
    CHECK(agree(math::log(math::exp(x)), x, 16 / std::abs(double(x))));
    CHECK(agree(math::log2(math::exp2(x)), x, 16 / std::abs(double(x))));
    CHECK(agree(math::sinh(x) + math::cosh(x), math::exp(x), 64 * std::exp(-2 * double(x)) + 4));
    CHECK(agree(math::tan(math::atan(x)), x, 16));
    CHECK(agree(math::atan2(x, 1), math::atan(x)));
  }
  for (const Mp &x : numbers(0.01, 50)) {
    Mp root = math::sqrt(x), cube = math::cbrt(x);
    CHECK(agree(root * root, x, 4));
    CHECK(agree(cube * cube * cube, x, 4));
    CHECK(agree(math::inversesqrt(x) * root, 1, 4));
    CHECK(agree(math::reciprocal(x) * x, 1, 4));
    CHECK(agree(math::pow(x, Mp(0.5)), root, 4));
    CHECK(agree(math::log10(x) * math::log(Mp(10)), math::log(x), 1e3));
    CHECK(agree(math::hypot(3 * x, 4 * x), 5 * x, 4));
    CHECK(agree(math::divide(x, root), root, 4));
  }
  for (const Mp &x : numbers(-1, 1)) {
    CHECK(agree(math::sin(math::asin(x)), x, 16));
    CHECK(agree(math::acos(x) + math::asin(x), math::asin(Mp(1)), 4));
    CHECK(agree(math::tanh(x) * math::cosh(x), math::sinh(x), 4));
  }
  // An angle of 1.6e21 turns.
  CHECK(double(math::sin(Mp(1e22))) == Approx(-0.8522008497671888).epsilon(1e-15));
}

TEST_CASE("lattice cells are those of exact integers") {
  CHECK(latticeCell(Mp(-1)) == 0xffffffffu);
  CHECK(latticeCell(Mp(0x1p40) + 5) == 5);
  CHECK(latticeCell(Mp(0x1p60) + 3) == 3); // which no double is
  for (double x : {1e30, -1e30, double(NAN), double(HUGE_VAL)})
    CHECK(latticeCell(Mp(x)) == latticeCell(x));
  CHECK(floorOf(Mp(2) - Mp(0x1p-150)) == 1);
  CHECK(ceilOf(Mp(2) + Mp(0x1p-150)) == 3);
}

TEST_CASE("a magnitude is brought near 1 by a power of two and back") {
  for (double m : {1e-320, 1e-30, 0.75, 1.0, 3.0, 1e300}) {
    Mp down, up;
    scaleFor(Mp(m), down, up);
    CHECK(down * up == 1);
    CHECK(Mp(m) * down >= 1);
    CHECK(Mp(m) * down < 2);
  }
}
