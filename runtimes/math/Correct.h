//===-- runtimes/math/Correct.h - correct rounding where one double is not enough -------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Functions of two floats have 2^64 arguments, too many to prove by trying that an error of 2^-53
// never meets the middle between two floats, and of inverse square roots it is known that it does.
// So these are computed as the sum of two doubles.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_CORRECT_H
#define ANYSL_RUNTIMES_MATH_CORRECT_H

#include "runtimes/math/DoubleExpLog.h"
#include "runtimes/math/InDouble.h"

namespace anysl::tier {

/// The sum of two doubles has an error of about 2^-57: one result in 2^31 may be rounded wrongly.
ANYSL_TIER float powCorrect(float x, float y) {
  double a = magnitude(x);
  bool finite = a > 0 && a < Infinity<double>;
  Pair l = log2Accurate(finite ? a : 1);
  Pair e = product(l, double(clampKeepNaN(y, -0x1p60f, 0x1p60f)));
  // Beyond these bounds the power is 0 or infinite.
  double high = clampKeepNaN(e.high, -160.0, 140.0);
  double low = high == e.high ? e.low : 0;
  double t = high + RoundShift;
  double f = high - (t - RoundShift);
  Pair r = product(f, Ln2Pair.high);
  r = fastSum(r.high, r.low + (f * Ln2Pair.low + low * Ln2Pair.high));
  Pair s = fastSum(1, r.high);
  s = fastSum(s.high, s.low + expTail(r));
  double power = fromBits(bitsOf(roundToOdd(s, 0x1p-56)) + (bitsOf(t) << 52));
  double limit = (a == 0) == (y < 0) ? Infinity<double> : 0.0;
  power = finite ? power : limit;
  power = a != a || y != y ? a + y : power;
  return powSpecial(x, y, float(power));
}

ANYSL_TIER float hypotCorrect(float x, float y) {
  double a = x, b = y;
  Pair s = twoSum(a * a, b * b);
  double r = squareRoot(s.high);
  Pair square = product(r, r);
  double rest = ((s.high - square.high) - square.low) + s.low;
  Pair root = fastSum(r, rest / (r == 0 ? 1 : 2 * r));
  bool infinite = magnitude(x) == Infinity<float> || magnitude(y) == Infinity<float>;
  bool nan = x != x || y != y;
  float length = nan ? x + y : float(roundToOdd(root, 0x1p-80));
  return infinite ? Infinity<float> : length;
}

/// Some arguments have an inverse root within 2^-53 of the middle between two floats.
ANYSL_TIER float inverseSqrtCorrect(float x) {
  InverseSqrt s = inverseSqrtStart(x);
  double m = s.x, y = s.y;
  y += y * (0.5 * (1 - m * (y * y)));
  Pair p = product(product(y, y), m);
  Pair root = fastSum(y, y * (0.5 * ((1 - p.high) - p.low)));
  bool ordinary = m > 0 && m < Infinity<double>;
  return (ordinary ? float(roundToOdd(root, 0x1p-90)) : s.y) * s.scale;
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_CORRECT_H
