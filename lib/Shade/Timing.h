//===-- lib/Shade/Timing.h - measures several things by turns ---------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// All candidates take turns, in another order each round, so that a machine that slows down does so
// for all alike; the thread's own processor time is measured, so that other programs do not count;
// and medians are compared, so that a disturbed round does not matter.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SHADE_TIMING_H
#define ANYSL_LIB_SHADE_TIMING_H

#include <functional>
#include <vector>

namespace anysl::shade {

/// Seconds of processor time that this thread, or all threads together, have had.
double threadSeconds();
double processSeconds();

/// Something to be timed.
struct Candidate {
  /// Does it \p times times and gives the seconds that took; what it needs beforehand is not
  /// counted.
  std::function<double(unsigned times)> run;
  unsigned repetitions = 1;      ///< in a sample
  std::vector<double> samples{}; ///< seconds for doing it once, one a round

  /// The share q of the samples is below it: 0.5 gives the median, 0.25 and 0.75 the quartiles.
  double quantile(double q) const;
};

/// The same of any numbers; 0 if there are none.
double quantile(std::vector<double> values, double q);

/// Repeats each candidate often enough for the clock (this also warms up), then times all of them,
/// round after round. \p progress hears the share that is done.
void measure(std::vector<Candidate> &candidates, int rounds, double secondsPerSample,
             const std::function<void(double)> &progress = {});

} // namespace anysl::shade

#endif
