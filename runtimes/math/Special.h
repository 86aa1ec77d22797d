//===-- runtimes/math/Special.h - arguments for which a function has no ordinary value --------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_SPECIAL_H
#define ANYSL_RUNTIMES_MATH_SPECIAL_H

#include "runtimes/math/Core.h"

namespace anysl::tier {

/// Whether x is positive, normal and finite: one comparison of integers.
ANYSL_TIER bool isPositiveNormal(float x) { return bitsOf(x) - 0x00800000u < 0x7f000000u; }

/// What log, log2 and log10 give for an x that is not positive and finite.
ANYSL_TIER float logSpecial(float x) {
  float y = x < 0 ? NotANumber<float> : x + x;
  return x == 0 ? -Infinity<float> : y;
}
ANYSL_TIER bool isPositiveFinite(float x) { return x > 0 && x < Infinity<float>; }

/// C's special cases of x^y, given the power of |x| for finite arguments; and x·x for y = 2, which
/// shaders count on.
ANYSL_TIER float powSpecial(float x, float y, float power) {
  double n = double(y) + RoundShift;
  bool integer = n - RoundShift == double(y);
  bool odd = integer && magnitude(y) < 0x1p24f && (bitsOf(n) & 1);
  bool negative = __builtin_signbit(x);
  float a = magnitude(x);
  power = negative && odd ? -power : power;
  power = x < 0 && a < Infinity<float> && !integer ? NotANumber<float> : power;
  power = y == 2 ? x * x : power;
  bool one = y == 0 || x == 1 || (a == 1 && magnitude(y) == Infinity<float>);
  return one ? 1.0f : power;
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_SPECIAL_H
