//===-- lib/Cost/Errors.h - how far results are from others -----------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_ERRORS_H
#define ANYSL_LIB_COST_ERRORS_H

#include "lib/Shade/Grid.h"

namespace anysl::cost {

/// The distances of a shader's results from others, over all numbers of all points. Two NaNs, and
/// two infinities alike, are no distance apart.
struct ErrorStats {
  size_t numbers = 0; ///< compared
  /// In the results' units: the largest distance, the one that a thousandth of them exceed, and the
  /// root of the mean square.
  double max = 0, p999 = 0, rms = 0;
  /// In units in the last place of a float of the true value's size (docs/numerics.md).
  double maxUlps = 0, rmsUlps = 0;
  /// The share of numbers that differ once they are pixels: limited to [0, 1] and rounded to 8 or
  /// 16 bits, without a gamma.
  double changed8 = 0, changed16 = 0;
  /// How many are NaN or infinite where the others are not, or the other way round. They count in
  /// `max` as infinity, and not in the means.
  size_t notNumbers = 0;
};

/// Compares what two runs of one shader gave at the same points. Texts are left out.
ErrorStats compare(const std::vector<shade::Result> &results,
                   const std::vector<shade::Result> &truth);

/// The distance from one float to the next in the binade of `value`; of the smallest denormal below
/// the normal numbers.
double floatUlp(double value);

} // namespace anysl::cost

#endif
