//===-- test/unit/cost/CostTests.cpp - errors, fronts, the order of changes ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Errors.h"
#include "lib/Cost/Mixtures.h"
#include "lib/Plot/Plot.h"
#include "lib/Shade/Timing.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace anysl;

TEST_CASE("A ULP is the distance to the next float", "[cost]") {
  std::minstd_rand random(7);
  for (int i = 0; i < 10000; ++i) {
    float value = std::ldexp(1 + float(random() % 1000000) / 1000000, int(random() % 270) - 145);
    if (!std::isfinite(value))
      continue;
    // Outwards, so that a power of two has the distance of its own binade.
    CHECK(cost::floatUlp(value) ==
          double(std::nextafter(value, std::numeric_limits<float>::infinity())) - double(value));
    CHECK(cost::floatUlp(-double(value)) == cost::floatUlp(value));
  }
  CHECK(cost::floatUlp(0) == 0x1p-149);
  CHECK(cost::floatUlp(0x1p-200) == 0x1p-149);
}

static shade::Result numbers(std::vector<double> values) { return {"x", 1, 0, std::move(values)}; }

TEST_CASE("Errors have the values of their definitions", "[cost]") {
  cost::ErrorStats stats = cost::compare({numbers({1.25, -3, 0.5, 0})}, {numbers({1, 0, 0.5, 0})});
  CHECK(stats.numbers == 4);
  CHECK(stats.max == 3);
  CHECK(stats.rms == Approx(std::sqrt((0.0625 + 9) / 4)));
  CHECK(stats.maxUlps == 3 / 0x1p-149);
  // 1.25 is as white as 1, and -3 as black as 0.
  CHECK(stats.changed8 == 0);
  CHECK(stats.notNumbers == 0);
  stats = cost::compare({numbers({0.5, 100 / 255.0})}, {numbers({0.5001, 101 / 255.0})});
  CHECK(stats.changed8 == 0.5);
  CHECK(stats.changed16 == 1);
}

TEST_CASE("What is no number is counted, unless both are alike", "[cost]") {
  double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  cost::ErrorStats stats =
      cost::compare({numbers({nan, inf, 1, nan, inf})}, {numbers({nan, inf, 1.5, 1, -inf})});
  CHECK(stats.notNumbers == 2);
  CHECK(stats.max == inf);
  CHECK(stats.rms == Approx(std::sqrt(0.25 / 3)));
}

TEST_CASE("A Pareto front has what nothing beats", "[cost]") {
  std::vector<plot::Point> points;
  std::minstd_rand random(3);
  for (int i = 0; i < 200; ++i)
    points.push_back({double(random() % 50), double(1 + random() % 50)});
  points.push_back({std::nan(""), 0.5});
  std::vector<size_t> front = plot::paretoFront(points);
  auto beats = [](const plot::Point &a, const plot::Point &b) {
    return a.x <= b.x && a.y <= b.y && (a.x < b.x || a.y < b.y);
  };
  REQUIRE(!front.empty());
  for (size_t i = 0; i + 1 < points.size(); ++i) {
    bool isOn = std::find(front.begin(), front.end(), i) != front.end();
    bool isBeaten = false, isRepeated = false;
    for (size_t k = 0; k + 1 < points.size(); ++k) {
      isBeaten |= beats(points[k], points[i]);
      isRepeated |= k < i && points[k].x == points[i].x && points[k].y == points[i].y;
    }
    CHECK(isOn == (!isBeaten && !isRepeated));
  }
  CHECK(std::is_sorted(front.begin(), front.end(),
                       [&](size_t a, size_t b) { return points[a].x < points[b].x; }));
}

TEST_CASE("Plots draw points at zero, none, and one", "[cost]") {
  plot::Plot plot{"<title> & more", "x", "y", {"a"}, {"b"}, "", {}};
  CHECK(plot::svg(plot, true).find("&lt;title&gt; &amp; more") != std::string::npos);
  plot.points.push_back({0, 1, "name", "label"});
  CHECK(plot::svg(plot, false).find(">exact<") != std::string::npos);
  CHECK(plot::svg(plot, false).find("nan") == std::string::npos);
}

TEST_CASE("Changes that cost nothing come first, then those that buy the most", "[cost]") {
  std::vector<cost::Move> order = cost::greedyOrder({{"sin", "fast", 5, 100},
                                                     {"sin", "u10", 3, 1},
                                                     {"pow", "u10", 2, 0},
                                                     {"exp", "fast", 6, 3},
                                                     {"log", "u35", -1, 0}});
  std::vector<std::string> names;
  for (const cost::Move &move : order)
    names.push_back(move.subject + "=" + move.tier);
  CHECK(names == std::vector<std::string>{"pow=u10", "sin=u10", "exp=fast", "sin=fast"});
}

TEST_CASE("Functions that are IEEE's in every tier need no choice", "[cost]") {
  std::vector<std::string> functions = cost::functionsWithTiers({"sqrt", "pow", "divide", "sin"});
  CHECK(functions == std::vector<std::string>{"sin", "pow"});
}

TEST_CASE("Candidates are timed by turns, as often as asked", "[cost]") {
  std::vector<shade::Candidate> candidates;
  std::vector<int> runs(3);
  for (size_t i = 0; i < runs.size(); ++i)
    candidates.push_back({[&runs, i](unsigned times) {
      ++runs[i];
      return double(times) * double(i + 1);
    }});
  double last = 0;
  shade::measure(candidates, 5, 10, [&](double share) {
    CHECK(share > last);
    last = share;
  });
  CHECK(last == 1);
  for (size_t i = 0; i < runs.size(); ++i) {
    CHECK(candidates[i].samples == std::vector<double>(5, double(i + 1)));
    CHECK(candidates[i].quantile(0.25) == double(i + 1));
  }
}
