//===-- test/unit/cost/StabilityTests.cpp - which operator spoilt a result --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Blame.h"
#include "lib/Plot/HeatMap.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <deque>

using namespace anysl::cost;

namespace {

/// Two traces that are made together, operator by operator; each stands on a line of its own.
struct Traces {
  Trace rounded, exact;
  std::deque<AnyslNoteSite> sites;

  uint32_t add(const char *op, double value, double truth, std::vector<uint32_t> reads = {},
               uint32_t kind = ANYSL_NOTE_VALUE) {
    sites.push_back({kind, uint32_t(sites.size() + 1), 1, 1, 0, 0, "shader", "shader.sl", op});
    addTo(rounded, value, reads);
    return addTo(exact, truth, reads);
  }
  /// On one of the two ways only.
  uint32_t addOnlyTo(Trace &trace, const char *op, double value) {
    sites.push_back(
        {ANYSL_NOTE_VALUE, uint32_t(sites.size() + 1), 1, 1, 0, 0, "shader", "shader.sl", op});
    return addTo(trace, value, {});
  }
  void store(const char *name, uint32_t fromRounded, uint32_t fromExact) {
    sites.push_back(
        {ANYSL_NOTE_STORE, uint32_t(sites.size() + 1), 1, 1, 0, 0, "shader", "shader.sl", name});
    addTo(rounded, rounded.steps[fromRounded].results[0], {fromRounded});
    addTo(exact, exact.steps[fromExact].results[0], {fromExact});
  }

  uint32_t addTo(Trace &trace, double value, const std::vector<uint32_t> &reads) {
    TraceStep &step = trace.steps.emplace_back();
    step.site = &sites.back();
    step.results[0] = value;
    step.readsFrom.assign(reads.begin(), reads.end());
    return uint32_t(trace.steps.size() - 1);
  }

  /// What is to blame for the only result.
  Culprit culprit() const {
    TraceComparison comparison(rounded, exact, digitsOf("float"));
    REQUIRE(comparison.results().size() == 1);
    auto found = comparison.blame(comparison.results()[0]);
    REQUIRE(found);
    return *found;
  }
};

} // namespace

TEST_CASE("digits are lost as far as numbers differ, beside the largest of a triple", "[cost]") {
  // 24 bits are 7.22 decimal digits.
  double digits = digitsOf("float");
  CHECK(digits == Approx(7.2247).margin(1e-4));
  CHECK(lostDigits({1.0}, {1.0}, digits) == 0);
  CHECK(lostDigits({1.001}, {1.0}, digits) == Approx(digits - 3).margin(1e-9));
  CHECK(lostDigits({5.0}, {1.0}, digits) == digits);
  CHECK(lostDigits({1e-30}, {0.0}, digits) == digits);
  CHECK(lostDigits({1.0, 2e-9, 0}, {1.0, 1e-9, 0}, digits) == 0);
  CHECK(std::isinf(lostDigits({HUGE_VAL}, {1.0}, digits)));
  CHECK(lostDigits({NAN}, {NAN}, digits) == 0);
}

TEST_CASE("a difference of nearly equal numbers is to blame, not what was rounded before",
          "[cost]") {
  Traces traces;
  uint32_t one = traces.add("const_float", 1, 1);
  uint32_t cosine = traces.add("cos", 1 - 6e-8, 1 - 5e-8);
  uint32_t versine = traces.add("sub_float", 6e-8, 5e-8, {one, cosine});
  uint32_t half = traces.add("mul_float", 3e-8, 2.5e-8, {versine});
  traces.store("Ci", half, half);
  Culprit culprit = traces.culprit();
  CHECK(culprit.cause == Cause::LostDigits);
  CHECK(culprit.step == versine);
  CHECK(culprit.added > 6);
}

TEST_CASE("an error is followed through sums and products to where it arose", "[cost]") {
  Traces traces;
  uint32_t small = traces.add("sub_float", 2e-7, 1e-7); // wholly wrong
  uint32_t root = traces.add("sqrt", std::sqrt(2e-7), std::sqrt(1e-7), {small});
  uint32_t large = traces.add("load_float", 0.7, 0.7);
  uint32_t sum =
      traces.add("add_float", 0.7 + std::sqrt(2e-7), 0.7 + std::sqrt(1e-7), {large, root});
  traces.store("Ci", sum, sum);
  CHECK(traces.culprit().step == small);
}

TEST_CASE("what is wrong and does not matter is not to blame", "[cost]") {
  Traces traces;
  uint32_t tiny = traces.add("sub_float", 2e-12, 1e-12);
  uint32_t bad = traces.add("acos", 0.7001, 0.7);
  uint32_t sum = traces.add("add_float", 0.7001 + 2e-12, 0.7 + 1e-12, {tiny, bad});
  traces.store("Ci", sum, sum);
  CHECK(traces.culprit().step == bad);
}

TEST_CASE("a branch is to blame for what is computed on one way only, and for nothing else",
          "[cost]") {
  Traces traces;
  uint32_t before = traces.add("sub_float", 2e-7, 1e-7);
  uint32_t decision = traces.add("lt_float", 1, 0, {before}, ANYSL_NOTE_DECISION);
  uint32_t rounded = traces.addOnlyTo(traces.rounded, "copy_float", 5);
  uint32_t exact = traces.addOnlyTo(traces.exact, "copy_float", 1);
  for (int i = 0; i < 6; ++i) // where both meet again
    traces.add("const_float", i, i);

  SECTION("of one way only") {
    traces.store("Ci", rounded, exact);
    Culprit culprit = traces.culprit();
    CHECK(culprit.cause == Cause::Branch);
    CHECK(culprit.step == decision);
  }
  SECTION("computed before") {
    traces.store("Ci", before, before);
    CHECK(traces.culprit().cause == Cause::LostDigits);
    CHECK(traces.culprit().step == before);
  }
  SECTION("computed afterwards") {
    uint32_t after = traces.add("acos", 0.7001, 0.7);
    traces.store("Ci", after, after);
    CHECK(traces.culprit().cause == Cause::LostDigits);
  }
}

TEST_CASE("the first operator that makes infinity of finite numbers is to blame for NaN",
          "[cost]") {
  Traces traces;
  uint32_t large = traces.add("load_float", 3e38, 3e38);
  uint32_t product = traces.add("mul_float", HUGE_VAL, 9e76, {large, large});
  uint32_t difference = traces.add("sub_float", NAN, 0, {product, product});
  traces.store("Ci", difference, difference);
  CHECK(traces.culprit().cause == Cause::NotFinite);
  CHECK(traces.culprit().step == product);
}

TEST_CASE("a map with fewer places keeps the largest value of each", "[cost]") {
  anysl::plot::HeatMap map;
  map.width = 4, map.height = 2;
  map.values = {1, 2, 3, NAN, 5, 0, 0, NAN};
  anysl::plot::HeatMap small = reduced(map, 2);
  CHECK(small.width == 2);
  CHECK(small.height == 2);
  CHECK(small.values == std::vector<double>{2, 3, 5, 0});
  CHECK(reduced(map, 8).values.size() == 8);
}
