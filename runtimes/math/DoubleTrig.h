//===-- runtimes/math/DoubleTrig.h - trigonometric functions of a double ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Within 1 ULP: each result is a sum of which the larger term is exact or corrected, and the
// smaller one carries its own roundings only.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_DOUBLETRIG_H
#define ANYSL_RUNTIMES_MATH_DOUBLETRIG_H

#include "runtimes/math/Coefficients.h"
#include "runtimes/math/DoubleCore.h"

namespace anysl::tier {

inline constexpr Pair HalfPiPair = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// An argument as n·pi/2 + r with |r| <= pi/4; only the low two bits of n count.
struct Quadrant {
  Pair r;
  UInt64 n;
};

/// For |x| < HugeArgument64: three parts of pi/2 have so few bits that their products with n are
/// exact.
inline constexpr double HugeArgument64 = 0x1p20;
ANYSL_TIER Quadrant quadrantNear(double x) {
  double t = x * 0x1.45f306dc9c883p-1 + RoundShift;
  double n = t - RoundShift;
  double r = x - n * 0x1.921fb544p+0;
  Pair a = twoSum(r, -(n * 0x1.0b4611a6p-34));
  Pair b = twoSum(a.high, -(n * 0x1.3198a2e0p-69));
  return {fastSum(b.high, (a.low + b.low) - n * 0x1.b839a252049c1p-104), bitsOf(t)};
}

/// A 32-bit word as a double, without a conversion that AVX2 has not got.
ANYSL_TIER double wordToDouble(UInt64 word) {
  return fromBits(word | 0x4330000000000000ull) - 0x1p52;
}

/// For any other finite x: x·2/pi modulo 4 in 192-bit fixed point (Payne and Hanek). With x =
/// m·2^e, the bits of 2/pi that count begin with the one whose product has weight 2.
ANYSL_TIER Quadrant quadrantHuge(double x) {
  UInt64 bits = bitsOf(x) & 0x7fffffffffffffffull;
  UInt64 m = (bits & 0x000fffffffffffffull) | 0x0010000000000000ull;
  UInt64 first = (bits >> 52) - 1075 + 62; // e − 2 bits of 2/pi to skip, after 64 zeros
  UInt64 word = first >> 5, shift = 32 - (first & 31);
  word = word > 34 ? 34 : word; // infinity and NaN
  constexpr UInt64 low32 = 0xffffffffull;
  UInt64 m0 = m & low32, m1 = m >> 32;
  auto limb = [&](UInt64 i) __attribute__((always_inline)) {
    UInt64 two = UInt64(TwoOverPiBits[word + i]) << 32 | TwoOverPiBits[word + i + 1];
    return (two >> shift) & low32;
  };
  // Limb i of the product's lowest 192 bits from m0·v[i], m0·v[i−1], m1·v[i−1] and m1·v[i−2], of
  // which the lowest limb of the window is v[0].
  UInt64 v0 = limb(5), v1 = limb(4), v2 = limb(3), v3 = limb(2), v4 = limb(1), v5 = limb(0);
  UInt64 p0 = m0 * v0;
  UInt64 p1 = (p0 >> 32) + (m0 * v1 & low32) + (m1 * v0 & low32);
  UInt64 p2 =
      (p1 >> 32) + (m0 * v1 >> 32) + (m1 * v0 >> 32) + (m0 * v2 & low32) + (m1 * v1 & low32);
  UInt64 p3 =
      (p2 >> 32) + (m0 * v2 >> 32) + (m1 * v1 >> 32) + (m0 * v3 & low32) + (m1 * v2 & low32);
  UInt64 p4 =
      (p3 >> 32) + (m0 * v3 >> 32) + (m1 * v2 >> 32) + (m0 * v4 & low32) + (m1 * v3 & low32);
  UInt64 p5 =
      (p4 >> 32) + (m0 * v4 >> 32) + (m1 * v3 >> 32) + (m0 * v5 & low32) + (m1 * v4 & low32);
  p2 &= low32;
  p3 &= low32;
  p4 &= low32;
  p5 &= low32;
  UInt64 n = (p5 + 0x20000000ull) >> 30;
  // The top word less n quadrants lies in [−2^29, 2^29).
  double top = (wordToDouble((p5 - (n << 30) + 0x40000000ull) & low32) - 0x1p30) * 0x1p-30;
  Pair a = fastSum(top, wordToDouble(p4) * 0x1p-62);
  Pair b = twoSum(a.low, wordToDouble(p3) * 0x1p-94);
  Pair c = twoSum(a.high, b.high);
  Pair f = fastSum(c.high, c.low + (b.low + wordToDouble(p2) * 0x1p-126));
  Pair r = product(f, HalfPiPair);
  bool finite = magnitude(x) < Infinity<double>;
  r.high = finite ? r.high : NotANumber<double>;
  bool negative = __builtin_signbit(x);
  return {{negative ? -r.high : r.high, negative ? -r.low : r.low}, negative ? 0 - n : n};
}

ANYSL_TIER Quadrant quadrantOf(double x) {
  if (__builtin_expect(!(magnitude(x) < HugeArgument64), 0))
    return quadrantHuge(x);
  return quadrantNear(x);
}

/// What is added to r.high for sin r, and to 1 − z/2 for cos r.
ANYSL_TIER double sinTail(Pair r, double z) {
  return r.low * (1 - 0.5 * z) + r.high * (z * horner(SinCr, z));
}
ANYSL_TIER Pair cosPair(Pair r, double z) {
  double half = 0.5 * z;
  double w = 1 - half;
  return {w, ((1 - w) - half) + (z * (z * horner(CosCr, z)) - r.high * r.low)};
}

ANYSL_TIER double sinOrCos(Quadrant q) {
  double z = q.r.high * q.r.high;
  double s = q.r.high + sinTail(q.r, z);
  Pair c = cosPair(q.r, z);
  double y = q.n & 1 ? c.high + c.low : s;
  return fromBits(bitsOf(y) ^ ((q.n & 2) << 62));
}

/// The same to about 2^-57, as a double that rounds to the right float.
ANYSL_TIER double sinOrCosForFloat(Quadrant q) {
  double z = q.r.high * q.r.high;
  Pair s = fastSum(q.r.high, sinTail(q.r, z));
  Pair c = cosPair(q.r, z);
  c = fastSum(c.high, c.low - 0.5 * product(q.r.high, q.r.high).low);
  bool odd = q.n & 1;
  double y = roundToOdd({odd ? c.high : s.high, odd ? c.low : s.low}, 0);
  return fromBits(bitsOf(y) ^ ((q.n & 2) << 62));
}

ANYSL_TIER double sinOf(double x) {
  double y = sinOrCos(quadrantOf(x));
  return x == 0 ? x : y;
}

ANYSL_TIER double cosOf(double x) {
  Quadrant q = quadrantOf(x);
  q.n += 1;
  return sinOrCos(q);
}

ANYSL_TIER double tanOf(double x) {
  Quadrant q = quadrantOf(x);
  double z = q.r.high * q.r.high;
  Pair s = fastSum(q.r.high, sinTail(q.r, z));
  Pair c = cosPair(q.r, z);
  // The quotient adds up the errors of both sides, so here the rounding of z counts too.
  c = fastSum(c.high, c.low - 0.5 * product(q.r.high, q.r.high).low);
  bool odd = q.n & 1;
  Pair top = {odd ? -c.high : s.high, odd ? -c.low : s.low};
  Pair bottom = {odd ? s.high : c.high, odd ? s.low : c.low};
  Pair y = quotient(top, bottom);
  return magnitude(x) < 0x1p-300 ? x : y.high + y.low;
}

//===-- asin, acos, atan ----------------------------------------------------//

/// As asinReduced for float: the angle as s + tail.
struct HalfAngle64 {
  double s, tail;
  bool upper;
};
ANYSL_TIER HalfAngle64 asinReduced64(double a) {
  bool upper = a > 0.5;
  double z = upper ? 0.5 - 0.5 * a : a * a;
  double root = squareRoot(z);
  Pair square = product(root, root);
  double rootLow = ((z - square.high) - square.low) / (2 * nonZero(root));
  double s = upper ? root : a;
  return {s, (upper ? rootLow : 0) + s * (z * horner(AsinCr, z)), upper};
}

ANYSL_TIER double asinOf(double x) {
  HalfAngle64 h = asinReduced64(magnitude(x));
  Pair d = fastSum(HalfPiPair.high, -2 * h.s);
  double y = h.upper ? d.high + (d.low + (HalfPiPair.low - 2 * h.tail)) : h.s + h.tail;
  return copySign(y, x);
}

ANYSL_TIER double acosOf(double x) {
  HalfAngle64 h = asinReduced64(magnitude(x));
  bool negative = x < 0;
  double s = negative ? -h.s : h.s, tail = negative ? -h.tail : h.tail;
  Pair m = fastSum(HalfPiPair.high, -s);
  double middle = m.high + (m.low + (HalfPiPair.low - tail));
  Pair o = fastSum(2 * HalfPiPair.high, 2 * s);
  double outer = negative ? o.high + (o.low + (2 * HalfPiPair.low + 2 * tail)) : 2 * (s + tail);
  return h.upper ? outer : middle;
}

/// atan(y/x) for x, y in {0} and [2^-1000, 2^1000], in the first quadrant; see atanQuadrant for
/// float.
ANYSL_TIER Pair atanQuadrant64(double y, double x) {
  bool steep = y > x;
  double small = steep ? x : y, large = steep ? y : x;
  bool turned = small > large * 0x1.a827999fcef32p-2;
  Pair difference = fastSum(-large, small), total = fastSum(large, small);
  Pair top = {turned ? difference.high : small, turned ? difference.low : 0};
  Pair bottom = {turned ? total.high : large, turned ? total.low : 0};
  bottom.high = nonZero(bottom.high);
  Pair t = quotient(top, bottom);
  double z = t.high * t.high;
  t.low += t.high * (z * horner(AtanCr, z));
  double base = turned ? HalfPiPair.high / 2 : 0;
  double baseLow = turned ? HalfPiPair.low / 2 : 0;
  base = steep ? HalfPiPair.high - base : base;
  baseLow = steep ? HalfPiPair.low - baseLow : baseLow;
  t.high = steep ? -t.high : t.high;
  t.low = steep ? -t.low : t.low;
  Pair r = twoSum(base, t.high);
  return fastSum(r.high, r.low + (t.low + baseLow));
}

ANYSL_TIER double atanOf(double x) {
  Pair y = atanQuadrant64(clampKeepNaN(magnitude(x), 0.0, 0x1p100), 1);
  double a = magnitude(x) < 0x1p-100 ? magnitude(x) : y.high + y.low;
  return copySign(a, x);
}

ANYSL_TIER double atan2Of(double y, double x) {
  double ay = magnitude(y), ax = magnitude(x);
  // Bring the larger side to about 2^900, in two steps since one factor may not suffice; a smaller
  // side that falls off has a quotient below every double. Two infinities have the angle of (1, 1).
  bool bothInfinite = ay == Infinity<double> && ax == Infinity<double>;
  ay = bothInfinite ? 1 : ay;
  ax = bothInfinite ? 1 : ax;
  double large = ay > ax ? ay : ax;
  UInt64 biased = bitsOf(large) >> 52;
  biased = biased > 2046 ? 2046 : biased;
  UInt64 up = 1923 - biased + 1024; // the factor's exponent is up − 1024
  double first = powerOfTwo((up >> 1) - 512), second = powerOfTwo(up - (up >> 1) - 512);
  Pair a = atanQuadrant64(ay * first * second, ax * first * second);
  Pair d = fastSum(2 * HalfPiPair.high, -a.high);
  double angle = a.high + a.low;
  angle = __builtin_signbit(x) ? d.high + (d.low + (2 * HalfPiPair.low - a.low)) : angle;
  // One infinite side: quotient has met inf/inf or inf·0.
  double right = __builtin_signbit(x) ? 2 * HalfPiPair.high : 0;
  angle = ax == Infinity<double> ? right : angle;
  angle = ay == Infinity<double> ? HalfPiPair.high : angle;
  angle = x != x ? x : angle;
  return y != y ? y : copySign(angle, y);
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_DOUBLETRIG_H
