//===-- runtimes/math/Correct.h - correct rounding where one double is not enough -------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Functions of two floats have 2^64 arguments, too many to prove by trying that an error of 2^-53
// never meets the middle between two floats, and of inverse square roots it is known that it does.
// So these are computed as the sum of two doubles: hypot always, the others where one double is too
// near such a middle.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_CORRECT_H
#define ANYSL_RUNTIMES_MATH_CORRECT_H

#include "runtimes/math/DoubleExpLog.h"
#include "runtimes/math/InDouble.h"

namespace anysl::tier {

/// The sum of two doubles has an error of about 2^-57: one result in 2^31 may be rounded wrongly.
ANYSL_TIER float powNearMiddle(float x, float y) {
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

/// Polynomials for a power to 2^-43.
struct LongPower {
  static constexpr bool denormals = true;
  static constexpr Fusion fusion = Fusion::AsFits;
  static constexpr auto &log2 = Log2PowCr;
  static constexpr auto &exp2 = Exp2PowCr;
};

ANYSL_TIER float powCorrect(float x, float y) {
  OrdinaryPower p = ordinaryPower<LongPower>(x, y);
  float power = y == 2 ? x * x : float(p.power);
  // Denormal floats have the middles of the numbers that are 2^-126 more; 2^-42 is 1024 units of a
  // double.
  double shifted = p.power + (p.power < 0x1p-126 ? 0x1p-126 : 0);
  if (__builtin_expect(int(!p.isOrdinary) | isNearMiddle(shifted, 1024), 0))
    power = powNearMiddle(x, y);
  return power;
}

/// The angle of (x, y) as the sum of two doubles, for finite floats of which one is not 0: from the
/// nearest arc tangent of a sixteenth, with an error of about 2^-64. One result in 2^39 may be
/// rounded wrongly.
ANYSL_TIER float angleNearMiddle(float y, float x) {
  double ay = magnitude(y), ax = magnitude(x);
  bool steep = ay > ax, back = __builtin_signbit(x);
  double small = steep ? ax : ay, large = steep ? ay : ax;
  // Of specials nobody wants the result.
  bool finite = large > 0 && large < Infinity<double>;
  large = finite ? large : 1;
  small = finite ? small : 0;
  Int32 k = Int32(small / large * 16 + 0.5);
  double c = k * 0.0625;
  // Both are exact: c is 0 where small and large are far apart.
  double top = small - c * large, bottom = large + c * small;
  double u = top / bottom;
  Pair p = product(u, bottom);
  double low = ((top - p.high) - p.low) / bottom;
  double z = u * u;
  double tail = u * (z * horner<Fusion::AsFits>(AtanSeries, z));
  Pair angle = twoSum(AtanSixteenthsHigh[k], u);
  angle.low += AtanSixteenthsLow[k] + (low + tail);
  auto from = [](double high, double low, Pair angle) {
    Pair rest = twoSum(high, -angle.high);
    return Pair{rest.high, rest.low + (low - angle.low)};
  };
  angle = steep ? from(Pi / 2, PiLow / 2, angle) : angle;
  angle = back ? from(Pi, PiLow, angle) : angle;
  return float(roundToOdd(fastSum(angle.high, angle.low), 0));
}

ANYSL_TIER float atan2Correct(float y, float x) {
  double angle = angleOf<LongPolynomials>(y, x);
  float rounded = float(angle);
  // Denormal floats have the middles of the numbers that are 2^-126 more; the angle is within 8
  // units of a double.
  if (__builtin_expect(isNearMiddle(angle + (angle < 0x1p-126 ? 0x1p-126 : 0)), 0))
    rounded = angleNearMiddle(y, x);
  return atan2Special(y, x, rounded);
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
ANYSL_TIER float inverseSqrtNearMiddle(InverseSqrt s) {
  double m = s.x, y = inverseSqrtStep(s);
  Pair p = product(product(y, y), m);
  Pair root = fastSum(y, y * (0.5 * ((1 - p.high) - p.low)));
  bool ordinary = m > 0 && m < Infinity<double>;
  return ordinary ? float(roundToOdd(root, 0x1p-90)) : s.y;
}

ANYSL_TIER float inverseSqrtCorrect(float x) {
  InverseSqrt s = inverseSqrtStart(x);
  double y = inverseSqrtStep(s);
  float root = float(y);
  // 2^-44 is 256 units of a double.
  bool special = !(s.x > 0 && s.x < Infinity<float>);
  if (__builtin_expect(int(special) | isNearMiddle(y, 256), 0))
    root = inverseSqrtNearMiddle(s);
  return root * s.scale;
}

//===-- Where the full check found a double on the wrong side of a middle ---//
// The value there is within 2^-53 of the middle between two floats. Of all floats these are the
// only ones for which a double decides wrongly (scripts/verify-math).

ANYSL_TIER float asinCorrect(float x) {
  float y = asinInDouble<LongPolynomials>(x);
  y = magnitude(x) == 0x1.107434p-1f ? copySign(0x1.1f4b64p-1f, x) : y;
  return y;
}

ANYSL_TIER float acosCorrect(float x) {
  float y = acosInDouble<LongPolynomials>(x);
  y = x == 0x1.110b46p-26f ? 0x1.921fb6p+0f : y;
  y = x == 0x1.04c444p-12f ? 0x1.920f6ap+0f : y;
  return y;
}

ANYSL_TIER float atanCorrect(float x) {
  float y = atanInDouble<LongPolynomials>(x);
  y = magnitude(x) == 0x1.1ad646p-4f ? copySign(0x1.1a6386p-4f, x) : y;
  return y;
}

ANYSL_TIER float exp2Correct(float x) {
  float y = exp2InDouble<LongPolynomials>(x);
  y = x == 0x1.853a6ep-9f ? 0x1.00870ap+0f : y;
  y = x == -0x1.e7526ep-6f ? 0x1.f58d62p-1f : y;
  return y;
}

ANYSL_TIER float logCorrect(float x) {
  float y = logInDouble<LongPolynomials>(x);
  y = x == 0x1.827a74p-7f ? -0x1.1c2b1ep+2f : y;
  y = x == 0x1.2f1fd6p+3f ? 0x1.1fcbcep+1f : y;
  y = x == 0x1.bacb4ap+25f ? 0x1.1e0696p+4f : y;
  y = x == 0x1.b121a6p+76f ? 0x1.a9a3f2p+5f : y;
  y = x == 0x1.6351d8p+95f ? 0x1.08b512p+6f : y;
  return y;
}

ANYSL_TIER float log10Correct(float x) {
  float y = log10InDouble<LongPolynomials>(x);
  y = x == 0x1.fddcf4p-98f ? -0x1.d33a46p+4f : y;
  return y;
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_CORRECT_H
