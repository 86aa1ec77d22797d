//===-- benchmarks/math/bench-math.cpp - the tiers beside other libraries ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Nanoseconds per element of every function, in every tier and beside glibc, libmvec, SLEEF and
// OpenImageIO: 4096 elements in the second-level cache, each figure the median of rounds in which
// the contestants take turns, so that a change of the processor's clock meets all of them alike.
//
// usage: bench-math [--rounds N] [--csv] [function…]
//
//===------------------------------------------------------------------------------------------===//

#include "benchmarks/math/Contestants.h"
#include "tools/verify-math/Truth.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

using namespace anysl;

namespace {

constexpr size_t Count = 4096;

/// Arguments from one part of a function's domain.
struct Range {
  const char *name;
  double low[2], high[2];
  bool logarithmic;
};

std::vector<Range> rangesOf(const verify::Function &f) {
  std::vector<Range> ranges = {{"core", {f.low[0], f.low[1]}, {f.high[0], f.high[1]}, false}};
  std::string_view name = f.name;
  if (name == "sin" || name == "cos" || name == "tan")
    ranges.push_back({"huge", {1e7, 0}, {1e38, 0}, true});
  if (name == "log" || name == "log2" || name == "log10" || name == "cbrt" || name == "inversesqrt")
    ranges.push_back({"denormal", {1e-44, 0}, {1e-38, 0}, true});
  if (name == "exp")
    ranges.push_back({"denormal result", {-103, 0}, {-88, 0}, false});
  if (name == "pow")
    ranges.push_back({"denormal", {1e-44, 0.5}, {1e-38, 1}, true});
  return ranges;
}

struct alignas(64) Buffer {
  float x[Count], y[Count], result[Count];
};

void fill(Buffer &b, const Range &range) {
  std::mt19937 random(1);
  auto draw = [&](int i) {
    double low = range.low[i], high = range.high[i];
    bool logarithmic = range.logarithmic && low > 0;
    std::uniform_real_distribution<double> d(logarithmic ? std::log(low) : low,
                                             logarithmic ? std::log(high) : high);
    return float(logarithmic ? std::exp(d(random)) : d(random));
  };
  for (size_t i = 0; i < Count; ++i) {
    b.x[i] = draw(0);
    b.y[i] = range.high[1] > range.low[1] ? draw(1) : 0;
  }
}

double nanoseconds(const bench::Contestant &c, Buffer &b, int repeat) {
  auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < repeat; ++i) {
    c.kernel(b.x, b.y, b.result, Count);
    asm volatile("" : : "r"(b.result) : "memory");
  }
  auto end = std::chrono::steady_clock::now();
  return std::chrono::duration<double, std::nano>(end - begin).count() / double(repeat * Count);
}

double median(std::vector<double> v) {
  std::nth_element(v.begin(), v.begin() + v.size() / 2, v.end());
  return v[v.size() / 2];
}

void measure(const verify::Function &f, const Range &range, int rounds, bool csv) {
  static Buffer buffer;
  fill(buffer, range);
  auto contestants = bench::contestantsFor(f.name, &f - verify::functions().data());
  std::vector<std::vector<double>> times(contestants.size());
  std::vector<int> repeats;
  for (const auto &c : contestants)
    repeats.push_back(std::clamp(int(200e3 / (nanoseconds(c, buffer, 2) * Count)), 1, 400));
  for (int round = 0; round < rounds; ++round)
    for (size_t i = 0; i < contestants.size(); ++i)
      times[i].push_back(nanoseconds(contestants[i], buffer, repeats[i]));
  if (!csv)
    printf("%s, %s\n", std::string(f.name).c_str(), range.name);
  for (size_t i = 0; i < contestants.size(); ++i)
    printf(csv ? "%s,%s,%s,%d,%.3f\n" : "%.0s%.0s  %-12s x%-2d %8.3f ns\n",
           std::string(f.name).c_str(), range.name, contestants[i].name.c_str(),
           contestants[i].width, median(times[i]));
}

} // namespace

int main(int argc, char **argv) {
  int rounds = 15;
  bool csv = false;
  std::vector<std::string_view> names;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--csv") == 0)
      csv = true;
    else if (std::strcmp(argv[i], "--rounds") == 0 && i + 1 < argc)
      rounds = std::max(1, std::atoi(argv[++i]));
    else if (verify::findFunction(argv[i]))
      names.push_back(argv[i]);
    else {
      fprintf(stderr, "bench-math: '%s' is neither a function nor an option\n", argv[i]);
      return 1;
    }
  }
  if (csv)
    printf("function,range,library,width,nanoseconds\n");
  for (const verify::Function &f : verify::functions())
    if (names.empty() || std::find(names.begin(), names.end(), f.name) != names.end())
      for (const Range &range : rangesOf(f))
        measure(f, range, rounds, csv);
}
