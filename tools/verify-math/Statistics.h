//===-- tools/verify-math/Statistics.h - what a check has found so far ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_VERIFYMATH_STATISTICS_H
#define ANYSL_TOOLS_VERIFYMATH_STATISTICS_H

#include "tools/verify-math/Tiers.h"
#include "tools/verify-math/Truth.h"

#include <cmath>
#include <limits>

namespace anysl::verify {

/// The errors of one function of one tier over some arguments.
struct Statistics {
  uint64_t inputs = 0, misrounded = 0, wrong = 0;
  double maxUlp = 0, x = 0, y = 0;
  double maxRelative = 0;

  void add(Truth truth, float got, float atX, float atY) {
    ++inputs;
    if (got == truth.rounded && std::signbit(got) == std::signbit(truth.rounded)) {
      // Most results: at most half a unit off, and more than the maximum only rarely.
      if (maxUlp >= 0.5)
        return;
    } else if (!(std::isnan(got) && std::isnan(truth.rounded))) {
      ++misrounded;
    }
    note(errorInUlp(truth, got), atX, atY);
    // What counts as relative: beyond one step of the denormals.
    double off = std::fabs(got - truth.value) - 0x1p-149;
    if (off > maxRelative * std::fabs(truth.value) && std::isfinite(got))
      maxRelative = off / std::fabs(truth.value);
  }

  void addDouble(const Function &f, double atX, double atY, double got) {
    ++inputs;
    double ulp = errorInUlp(f, atX, atY, got);
    misrounded += ulp > 0.5;
    note(ulp, atX, atY);
  }

  /// Whether the errors are within the tier's bound for that function and type.
  bool holds(const Tier &tier, const Function &f, bool isDouble) const {
    double bound = isDouble ? tier.boundForDouble : tier.bound;
    if (wrong > 0)
      return false;
    if (bound == 0.5)
      return misrounded == 0;
    return bound > 0 ? maxUlp <= bound : maxRelative <= std::ldexp(1.0, -f.fastBits);
  }

private:
  void note(double ulp, double atX, double atY) {
    if (std::isinf(ulp))
      ++wrong;
    if (ulp > maxUlp) {
      maxUlp = ulp;
      x = atX;
      y = atY;
    }
  }
};

} // namespace anysl::verify

#endif // ANYSL_TOOLS_VERIFYMATH_STATISTICS_H
