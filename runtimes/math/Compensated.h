//===-- runtimes/math/Compensated.h - float functions within 1 ULP, evaluated in float --------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Exponentials and logarithms are sums in which one term is large and known exactly; the rest may
// then carry the few roundings that float evaluation brings. That takes half the time of double,
// and no fused multiply-add. Arguments that are denormal, infinite or NaN, or that lead there,
// branch off to InDouble.h, where they cost no more than others.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_COMPENSATED_H
#define ANYSL_RUNTIMES_MATH_COMPENSATED_H

#include "runtimes/math/InDouble.h"

namespace anysl::tier {

/// x without the lower half of its significand.
ANYSL_TIER float upperBits(float x) { return fromBits(bitsOf(x) & 0xfffff000u); }

ANYSL_TIER float expInFloatOnly(float x) {
  float t = x * 0x1.715476p+0f + RoundShiftF;
  float n = t - RoundShiftF;
  // x = n·log 2 + a − b. n·high is exact, since high has 15 bits, and so is a.
  float a = x - n * 0x1.62e4p-1f, b = n * 0x1.7f7d1cp-20f;
  float r = a - b;
  float tail = r * r * horner(ExpFloat, r) - b;
  float y = scaleBy(1 + (a + tail), bitsOf(t));
  if (__builtin_expect(!(magnitude(x) < 87), 0))
    y = expInDouble<ShortPolynomials>(x);
  return y;
}

ANYSL_TIER float exp2InFloatOnly(float x) {
  float t = x + RoundShiftF;
  float f = x - (t - RoundShiftF);
  // What rounding 1 + a has lost is added to the small terms.
  float a = f * 0x1.62e43p-1f, sum = 1 + a;
  float y = scaleBy(sum + (f * f * horner(Exp2Float, f) + (a - (sum - 1))), bitsOf(t));
  if (__builtin_expect(!(magnitude(x) < 125), 0))
    y = exp2InDouble<ShortPolynomials>(x);
  return y;
}

/// log(1+f) = f + this; only the rounding of f² counts.
ANYSL_TIER float logTail(float f) {
  float square = f * f;
  return square * (f * estrin(LogFloat, f)) - 0.5f * square;
}

ANYSL_TIER float logInFloatOnly(float x) {
  DecomposedF d = decomposeF(x);
  float n = float(d.n);
  float y = n * 0x1.62e4p-1f + (d.f + (logTail(d.f) + n * 0x1.7f7d1cp-20f));
  if (__builtin_expect(!isPositiveNormal(x), 0))
    y = logInDouble<ShortPolynomials>(x);
  return y;
}

/// n·unit + log(1+f)·(high + low). The logarithm is kept as a sum, of whose larger part the upper
/// 12 bits are multiplied exactly by the 12 bits of `high`.
template <class Base>
ANYSL_TIER float logScaled(float x, Base) {
  DecomposedF d = decomposeF(x);
  float n = float(d.n);
  float tail = logTail(d.f);
  float l = d.f + tail;
  tail = (d.f - l) + tail;
  float upper = upperBits(l), lower = (l - upper) + tail;
  float rest = lower * Base::high + l * Base::low;
  if constexpr (Base::unitLow != 0)
    rest += n * Base::unitLow;
  float a = n * Base::unitHigh, b = upper * Base::high, sum = a + b;
  float y = sum + (((a - sum) + b) + rest);
  if (__builtin_expect(!isPositiveNormal(x), 0))
    y = Base::inDouble(x);
  return y;
}
struct Base2 {
  static constexpr float high = 0x1.716p+0f, low = -0x1.7135a8p-13f, unitHigh = 1, unitLow = 0;
  static ANYSL_TIER float inDouble(float x) { return log2InDouble<ShortPolynomials>(x); }
};
struct Base10 {
  static constexpr float high = 0x1.bccp-2f, low = -0x1.09d5b2p-15f, unitHigh = 0x1.344p-2f,
                         unitLow = 0x1.3509f8p-18f;
  static ANYSL_TIER float inDouble(float x) { return log10InDouble<ShortPolynomials>(x); }
};

//===-- asin, acos ----------------------------------------------------------//

/// asin a = angle + low for a <= 1/2; above, that of sqrt((1−a)/2).
struct AngleF {
  float angle, low;
};
ANYSL_TIER AngleF asinReducedCompensated(float a) {
  bool upper = a > 0.5f;
  float z = upper ? 0.5f - 0.5f * a : a * a; // exact above
  float root = squareRoot(z);
  // What the root's rounding has left: z − root², with root split into two factors of 12 bits.
  float high = upperBits(root), low = root - high;
  float rest = (z - high * high) - low * (high + root);
  float rootLow = rest / (root + root + 0x1p-100f);
  float s = upper ? root : a;
  return {s, s * (z * horner(AsinFloat, z)) + (upper ? rootLow : 0)};
}

/// The float nearest pi/2, and the rest.
inline constexpr float HalfPiHigh = 0x1.921fb6p+0f, HalfPiLow = -0x1.777a5cp-25f;

ANYSL_TIER float asinInFloatOnly(float x) {
  float a = magnitude(x);
  AngleF h = asinReducedCompensated(a);
  float twice = 2 * h.angle, d = HalfPiHigh - twice;
  float upper = d + (((HalfPiHigh - d) - twice) + (HalfPiLow - 2 * h.low));
  return copySign(a > 0.5f ? upper : h.angle + h.low, x);
}

ANYSL_TIER float acosInFloatOnly(float x) {
  float a = magnitude(x);
  AngleF h = asinReducedCompensated(a);
  // pi/2 − asin x, or pi − twice the reduced angle, or twice that.
  bool outer = a > 0.5f, negative = x < 0;
  float factor = outer ? 2.0f : 1.0f;
  float angle = factor * copySign(h.angle, outer ? -x : x), low = factor * h.low;
  low = (angle < 0) == (h.angle < 0) ? low : -low;
  float base = outer ? (negative ? 2 * HalfPiHigh : 0) : HalfPiHigh;
  float baseLow = outer ? (negative ? 2 * HalfPiLow : 0) : HalfPiLow;
  float d = base - angle;
  return d + (((base - d) - angle) + (baseLow - low));
}

//===-- atan, atan2 ---------------------------------------------------------//

/// base + (t + low + t³·…), where base is 0 or the larger.
ANYSL_TIER float atanSum(float base, float baseLow, float t, float low, float z) {
  low += t * (z * horner(AtanFloat, z));
  float sum = base + t;
  return sum + (((base - sum) + t) + (low + baseLow));
}

ANYSL_TIER float atanInFloatOnly(float x) {
  // Smaller ones are their own arc tangents.
  constexpr float least = 0x1p-40f;
  float a = magnitude(x);
  float b = a < least ? least : a;
  // The angle itself, from pi/4 on, or from pi/2 back.
  bool turned = b > 0.65f, steep = b > 1.6f;
  float top = steep ? -1 : turned ? b - 1 : b;
  float bottom = steep ? b : turned ? b + 1 : 1;
  float t = top / bottom;
  float base = steep ? HalfPiHigh : turned ? HalfPiHigh / 2 : 0;
  float baseLow = steep ? HalfPiLow : turned ? HalfPiLow / 2 : 0;
  float y = atanSum(base, baseLow, t, 0, t * t);
  return copySign(a < least ? a : y, x);
}

ANYSL_TIER float atan2InFloatOnly(float y, float x) {
  UInt32 ay = bitsOf(magnitude(y)), ax = bitsOf(magnitude(x));
  bool steep = ay > ax, back = __builtin_signbit(x);
  UInt32 smallBits = ay < ax ? ay : ax, largeBits = ay > ax ? ay : ax;
  UInt32 least = bitsOf(0x1p-50f), most = bitsOf(0x1p50f);
  bool ordinary = int(largeBits - least < most - least) & int(smallBits - 1 >= least - 1);
  // Beyond these bounds other code counts, and here no flags shall be raised.
  largeBits = largeBits < least ? least : largeBits;
  largeBits = largeBits > most ? most : largeBits;
  float large = fromBits(largeBits);
  float small = fromBits(smallBits < largeBits ? smallBits : largeBits);
  bool turned = small > large * 0.65f;
  float top = turned ? small - large : small; // exact
  float bottom = turned ? small + large : large;
  float lost = turned ? small - (bottom - large) : 0;
  float inverse = 1 / bottom;
  float t = top * inverse;
  float tHigh = upperBits(t), tLow = t - tHigh;
  float high = upperBits(bottom), low = bottom - high;
  float rest = (((top - tHigh * high) - tHigh * low) - tLow * high) - (tLow * low + t * lost);
  float z = magnitude(t) < 0x1p-20f ? 0 : t * t;
  // The quotient is t + rest·inverse; the arc tangent's derivative there, 1/(1+z).
  float tail = rest * inverse * (1 - 0.75f * z);
  float base = 0, baseLow = 0;
  base = back ? 2 * HalfPiHigh : base, baseLow = back ? 2 * HalfPiLow : baseLow;
  base = steep ? HalfPiHigh : base, baseLow = steep ? HalfPiLow : baseLow;
  float diagonal = back ? 0x1.2d97c8p+1f : 0.5f * HalfPiHigh;
  float diagonalLow = back ? -0x1.99bc5cp-28f : 0.5f * HalfPiLow;
  base = turned ? diagonal : base, baseLow = turned ? diagonalLow : baseLow;
  UInt32 sign = steep != back ? 0x80000000u : 0;
  t = fromBits(bitsOf(t) ^ sign);
  tail = fromBits(bitsOf(tail) ^ sign);
  float angle = copySign(atanSum(base, baseLow, t, tail, z), y);
  if (__builtin_expect(!ordinary, 0))
    angle = atan2InDouble<ShortPolynomials>(y, x);
  return angle;
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_COMPENSATED_H
