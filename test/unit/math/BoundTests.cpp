//===-- test/unit/math/BoundTests.cpp - the bounds of the math tiers, on a sample -------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// One float in 4099, and always the arguments where the full check (scripts/verify-math) found each
// tier's largest error.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/verify-math/Inputs.h"
#include "tools/verify-math/Statistics.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace anysl::verify;

namespace {

constexpr uint64_t Stride = 4099, PairCount = 200000, DoubleCount = 2000;

/// The arguments that the committed table names for a function and type, in any tier.
std::vector<Arguments<double>> worstCases(std::string_view function, std::string_view type) {
  std::vector<Arguments<double>> result;
  std::ifstream file(ANYSL_ACCURACY_TABLE);
  std::string line, field;
  while (std::getline(file, line)) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    while (std::getline(in, field, ','))
      fields.push_back(field);
    if (fields.size() > 8 && fields[0] == function && fields[1] == type)
      result.push_back(
          {std::strtod(fields[7].c_str(), nullptr), std::strtod(fields[8].c_str(), nullptr)});
  }
  return result;
}

void checkFloats(std::string_view name) {
  const Function &f = *findFunction(name);
  size_t index = &f - functions().data();
  std::vector<float> x, y;
  if (f.arguments == 1)
    for (uint64_t i = 0; i < (uint64_t(1) << 32); i += Stride)
      x.push_back(floatAt(i));
  else
    for (uint64_t i = 0; i < PairCount; ++i) {
      Arguments<float> a = pairAt(f, i);
      x.push_back(a.x);
      y.push_back(a.y);
    }
  y.resize(x.size());
  for (Arguments<double> a : worstCases(name, "float")) {
    x.push_back(float(a.x));
    y.push_back(float(a.y));
  }
  std::vector<float> result(x.size());
  std::vector<Truth> truth;
  for (size_t i = 0; i < x.size(); ++i)
    truth.push_back(truthOf(f, x[i], y[i]));
  for (const Tier &tier : tiers()) {
    tier.batches[index].ofFloats(x.data(), y.data(), result.data(), x.size());
    Statistics s;
    for (size_t i = 0; i < x.size(); ++i)
      s.add(truth[i], result[i], x[i], y[i]);
    INFO(tier.name << ": " << s.maxUlp << " ULP at " << s.x << ", " << s.y << "; relative "
                   << s.maxRelative << "; wrong special values " << s.wrong);
    CHECK(s.holds(tier, f, false));
  }
}

void checkDoubles(std::string_view name) {
  const Function &f = *findFunction(name);
  size_t index = &f - functions().data();
  std::vector<Arguments<double>> arguments = worstCases(name, "double");
  for (uint64_t i = 0; i < DoubleCount; ++i)
    arguments.push_back(doublesAt(f, i));
  for (const Tier &tier : tiers()) {
    Statistics s;
    for (Arguments<double> a : arguments) {
      double got;
      tier.batches[index].ofDoubles(&a.x, &a.y, &got, 1);
      s.addDouble(f, a.x, a.y, got);
    }
    INFO(tier.name << ": " << s.maxUlp << " ULP at " << s.x << ", " << s.y
                   << "; wrong special values " << s.wrong);
    CHECK(s.holds(tier, f, true));
  }
}

} // namespace

#define MATH_UNARY(name, low, high, bits)                                                          \
  TEST_CASE("every tier's bound holds for " #name " of float") { checkFloats(#name); }             \
  TEST_CASE("every tier's bound holds for " #name " of double") { checkDoubles(#name); }
#define MATH_BINARY(name, lowX, highX, lowY, highY, bits) MATH_UNARY(name, , , )
#include <anysl/MathFunctions.def>

TEST_CASE("sin and cos round correctly where a double's error is too large") {
  // Nearer to the middle of two floats than the evaluation in double was exact; the last two have
  // a remainder of pi of their own.
  for (const char *name : {"sin", "cos"}) {
    const Function &f = *findFunction(name);
    for (float x : {0x1.33333p+13f, 0x1.95f654p+44f, 0x1.119ae6p+115f}) {
      float y = 0, result;
      findTier("cr")->batches[&f - functions().data()].ofFloats(&x, &y, &result, 1);
      INFO(name << " " << x);
      CHECK(result == truthOf(f, x, y).rounded);
    }
  }
}

TEST_CASE("the check itself finds an error of more than half a unit") {
  const Function &f = *findFunction("exp");
  Truth one = truthOf(f, 0, 0);
  CHECK(errorInUlp(one, 1) == 0);
  CHECK(errorInUlp(one, 1 + 0x1p-23f) == 1);
  CHECK(errorInUlp(one, 1 - 0x1p-24f) == 0.5);
  CHECK(std::isinf(errorInUlp(one, std::nanf(""))));
  CHECK(errorInUlp(f, 0, 0, 1 + 0x1p-52) == 1);
  CHECK(std::isinf(errorInUlp(*findFunction("sin"), 0, 0, -0.0)));
  Statistics s;
  s.add(one, 1 + 0x1p-22f, 0, 0);
  CHECK_FALSE(s.holds(*findTier("u10"), f, false));
}

TEST_CASE("the truth is certain where double is in doubt") {
  // exp(x) for |x| < 2^-24 lies just beside 1, between two floats' middles.
  CHECK(truthOf(*findFunction("exp"), 0x1p-25f, 0).rounded == 1);
  CHECK(truthOf(*findFunction("exp"), 0x1.000002p-24f, 0).rounded == 1 + 0x1p-23f);
  // 4097² = 2^24 + 2^13 + 1 is an exact middle; ties go to even.
  CHECK(truthOf(*findFunction("pow"), 4097, 2).rounded == 16785408.0f);
}
