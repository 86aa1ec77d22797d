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
  if (__builtin_expect(!(magnitude(x) < 87), 0))
    return expInDouble<ShortPolynomials>(x);
  float t = x * 0x1.715476p+0f + RoundShiftF;
  float n = t - RoundShiftF;
  // x = n·log 2 + a − b. n·high is exact, since high has 15 bits, and so is a.
  float a = x - n * 0x1.62e4p-1f, b = n * 0x1.7f7d1cp-20f;
  float r = a - b;
  float tail = r * r * horner(ExpFloat, r) - b;
  return scaleBy(1 + (a + tail), bitsOf(t));
}

ANYSL_TIER float exp2InFloatOnly(float x) {
  if (__builtin_expect(!(magnitude(x) < 125), 0))
    return exp2InDouble<ShortPolynomials>(x);
  float t = x + RoundShiftF;
  float f = x - (t - RoundShiftF);
  // f·log 2 = a + b, of which a is an exact product of factors of 12 bits.
  float upper = upperBits(f), lower = f - upper;
  float a = upper * 0x1.62ep-1f, b = lower * 0x1.62ep-1f + f * 0x1.0bfbe8p-15f;
  float tail = f * f * horner(Exp2Float, f) + b;
  return scaleBy(1 + (a + tail), bitsOf(t));
}

/// log(1+f) = f + this; only the rounding of f² counts.
ANYSL_TIER float logTail(float f) {
  float square = f * f;
  return square * (f * horner(LogFloat, f)) - 0.5f * square;
}

ANYSL_TIER float logInFloatOnly(float x) {
  if (__builtin_expect(!isPositiveNormal(x), 0))
    return logInDouble<ShortPolynomials>(x);
  DecomposedF d = decomposeF(x);
  return d.n * 0x1.62e4p-1f + (d.f + (logTail(d.f) + d.n * 0x1.7f7d1cp-20f));
}

/// n·unit + log(1+f)·(high + low). The logarithm is kept as a sum, of whose larger part the upper
/// 12 bits are multiplied exactly by the 12 bits of `high`.
template <class Base>
ANYSL_TIER float logScaled(float x, Base) {
  if (__builtin_expect(!isPositiveNormal(x), 0))
    return Base::inDouble(x);
  DecomposedF d = decomposeF(x);
  float tail = logTail(d.f);
  float l = d.f + tail;
  tail = (d.f - l) + tail;
  float upper = upperBits(l), lower = (l - upper) + tail;
  float rest = lower * Base::high + l * Base::low + d.n * Base::unitLow;
  float a = d.n * Base::unitHigh, b = upper * Base::high, sum = a + b;
  return sum + (((a - sum) + b) + rest);
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

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_COMPENSATED_H
