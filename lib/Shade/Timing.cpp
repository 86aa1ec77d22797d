//===-- lib/Shade/Timing.cpp - measures several things by turns -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/Timing.h"
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <numeric>
#include <random>

namespace anysl::shade {

static double secondsOf(clockid_t clock) {
  timespec time;
  clock_gettime(clock, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double threadSeconds() { return secondsOf(CLOCK_THREAD_CPUTIME_ID); }
double processSeconds() { return secondsOf(CLOCK_PROCESS_CPUTIME_ID); }

double quantile(std::vector<double> values, double q) {
  if (values.empty())
    return 0;
  auto index = size_t(std::lround(q * double(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(index), values.end());
  return values[index];
}

double Candidate::quantile(double q) const { return shade::quantile(samples, q); }

void measure(std::vector<Candidate> &candidates, int rounds, double secondsPerSample,
             const std::function<void(double)> &progress) {
  size_t steps = candidates.size() * size_t(rounds + 1), done = 0;
  auto step = [&] {
    if (progress)
      progress(double(++done) / double(steps));
  };
  for (Candidate &candidate : candidates) {
    unsigned repetitions = 1;
    double seconds = candidate.run(1);
    while (seconds < secondsPerSample / 2 && repetitions < 1u << 24)
      seconds = candidate.run(repetitions *= 2);
    candidate.repetitions =
        std::max(1u, unsigned(double(repetitions) * secondsPerSample / std::max(seconds, 1e-9)));
    step();
  }
  std::vector<size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::minstd_rand random(1); // any order does, as long as it changes
  for (int round = 0; round < rounds; ++round) {
    std::shuffle(order.begin(), order.end(), random);
    for (size_t i : order) {
      Candidate &candidate = candidates[i];
      candidate.samples.push_back(candidate.run(candidate.repetitions) / candidate.repetitions);
      step();
    }
  }
}

} // namespace anysl::shade
