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

#include <bit>
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
    bool equal = got == truth.rounded && std::signbit(got) == std::signbit(truth.rounded);
    misrounded += !equal && !(std::isnan(got) && std::isnan(truth.rounded));
    double magnitude = std::fabs(truth.value), off = std::fabs(got - truth.value);
    // What counts as relative error is beyond one step of the denormals.
    if (off - 0x1p-149 > maxRelative * magnitude && std::isfinite(off))
      maxRelative = (off - 0x1p-149) / magnitude;
    // Nearly all results are ordinary and no worse than what has been met: a quick way out.
    if (magnitude > 0x1p-125 && magnitude < 0x1p127 && off < 0x1p127) {
      uint64_t exponent = std::bit_cast<uint64_t>(magnitude) & 0x7ff0000000000000u;
      double inverseUlp = std::bit_cast<double>(((uint64_t(2046) + 23) << 52) - exponent);
      if (off * inverseUlp <= maxUlp)
        return;
    }
    note(errorInUlp(truth, got), atX, atY);
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
