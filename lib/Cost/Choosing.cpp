//===-- lib/Cost/Choosing.cpp - the cheapest that is exact enough -----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Choosing.h"
#include "lib/Cost/Mixtures.h"
#include <algorithm>
#include <cmath>

using namespace llvm;

namespace anysl::cost {
namespace {

double largestError(const std::vector<Bench *> &benches, const std::string &real,
                    const Choice &choice, unsigned width) {
  double result = 0;
  for (Bench *bench : benches)
    result = std::max(result, bench->error(bench->load(real, choice), width).max);
  return result;
}

} // namespace

std::optional<Chosen> chooseWithin(std::vector<Bench *> benches,
                                   const std::vector<std::string> &reals, unsigned wantedWidth,
                                   double error, const Timing &timing, double &best) {
  best = HUGE_VAL;
  std::optional<Chosen> result;
  for (const std::string &real : reals) {
    Choice exact{tiers()[0].str()};
    unsigned width = wantedWidth ? wantedWidth : benches.front()->load(real, exact).widths().back();
    double exactError = largestError(benches, real, exact, width);
    best = std::min(best, exactError);
    if (!(exactError <= error))
      continue;
    Sites sites(benches, real, width, timing);
    std::vector<Choice> choices = {exact};
    for (StringRef tier : tiers().drop_front())
      if (Choice uniform{tier.str()}; largestError(benches, real, uniform, width) <= error)
        choices.push_back(uniform);
    Choice mixture = sites.choose(sites.study(), [&](Bench &bench, Bench::Loaded &loaded) {
      return bench.error(loaded, width).max <= error;
    });
    if (!mixture.sites.empty())
      choices.push_back(mixture);
    std::vector<double> times = sites.time(choices);
    // Of choices as fast as each other, the more exact one.
    size_t fastest = size_t(std::min_element(times.begin(), times.end()) - times.begin());
    if (!result) {
      result.emplace();
      result->exactReal = real;
      result->exactTime = times[0];
      result->time = HUGE_VAL;
    }
    if (times[fastest] >= result->time)
      continue;
    result->real = real;
    result->choice = choices[fastest];
    result->time = times[fastest];
    result->error = largestError(benches, real, choices[fastest], width);
  }
  return result;
}

} // namespace anysl::cost
