//===-- runtimes/math/InFloat.h - float functions evaluated in float --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The tiers u35 and fast: one short polynomial each, fused multiply-adds, and no compensation.
// Where an argument needs more than that (huge angles, denormal results) a branch leads to code
// that a widened version enters only if a lane needs it.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_INFLOAT_H
#define ANYSL_RUNTIMES_MATH_INFLOAT_H

#include "runtimes/math/InDouble.h"

namespace anysl::tier {

/// Polynomials to about 2^-24: results within 3.5 ULP.
struct MediumPolynomials {
  static constexpr auto &sinPi = SinPiU35;
  static constexpr auto &tan = TanU35;
  static constexpr auto &exp = ExpU35;
  static constexpr auto &exp2 = Exp2U35;
  static constexpr auto &expm1 = Expm1U35;
  static constexpr auto &log = LogU35;
  static constexpr auto &asin = AsinU35;
  static constexpr auto &atan = AtanU35;
  static constexpr auto &inverseCbrt = InverseCbrtU35;
  static constexpr bool coarse = false;
};

/// Polynomials to about 2^-13: results to about 2^-12.
struct CoarsePolynomials {
  static constexpr auto &sinPi = SinPiFast;
  static constexpr auto &tan = TanFast;
  static constexpr auto &exp = ExpFast;
  static constexpr auto &exp2 = Exp2Fast;
  static constexpr auto &expm1 = Expm1Fast;
  static constexpr auto &log = LogFast;
  static constexpr auto &asin = AsinFast;
  static constexpr auto &atan = AtanFast;
  static constexpr auto &inverseCbrt = InverseCbrtFast;
  static constexpr bool coarse = true;
};

ANYSL_TIER float fma(float a, float b, float c) { return mulAdd<Fusion::Always>(a, b, c); }
template <class T, int N>
ANYSL_TIER T hornerFused(const T (&c)[N], T x) {
  return horner<Fusion::Always>(c, x);
}

//===-- sin, cos, tan -------------------------------------------------------//

/// As Turns, for float.
struct TurnsF {
  float r;
  UInt32 n;
};

/// Up to here the integer nearest x/pi comes out right in float, but for a neighbour's half step.
inline constexpr float LargeArgument = 0x1p17f;

/// n·unit with unit in three floats of 24 bits: the first product and its difference from x are
/// exact.
template <class Unit>
ANYSL_TIER float remainderOf(float x, float n) {
  float r = fma(-n, Unit::high, x);
  r = fma(-n, Unit::middle, r);
  return fma(-n, Unit::low, r);
}
struct PiF {
  static constexpr float inverse = 0x1.45f306p-2f, high = 0x1.921fb4p+1f, middle = 0x1.4442dp-23f,
                         low = 0x1.84698ap-47f;
};
struct HalfPiF {
  static constexpr float inverse = 0x1.45f306p-1f, high = 0x1.921fb4p+0f, middle = 0x1.4442dp-24f,
                         low = 0x1.84698ap-48f;
};

ANYSL_TIER TurnsF turnsLarge(float x, double scale, double offset, double unit) {
  Turns t = turnsHuge(x, scale, offset);
  return {float(t.r * unit), UInt32(t.n)};
}

template <class C>
ANYSL_TIER float sinInFloat(float x) {
  float t = fma(x, PiF::inverse, RoundShiftF);
  TurnsF a = {remainderOf<PiF>(x, t - RoundShiftF), bitsOf(t)};
  if (__builtin_expect(!(magnitude(x) < LargeArgument), 0))
    a = turnsLarge(x, 1, 0, 0x1.921fb54442d18p+1);
  float z = a.r * a.r;
  float y = a.r * fma(z, hornerFused(C::sinPi, z), 1);
  return fromBits(bitsOf(y) ^ (a.n << 31));
}

template <class C>
ANYSL_TIER float cosInFloat(float x) {
  // cos x = ∓sin(x − (n + 1/2)·pi)
  float t = fma(x, PiF::inverse, -0.5f) + RoundShiftF;
  TurnsF a = {remainderOf<PiF>(x, (t - RoundShiftF) + 0.5f), bitsOf(t)};
  if (__builtin_expect(!(magnitude(x) < LargeArgument), 0))
    a = turnsLarge(x, 1, -0.5, 0x1.921fb54442d18p+1);
  float z = a.r * a.r;
  float y = a.r * fma(z, hornerFused(C::sinPi, z), 1);
  y = fromBits(bitsOf(y) ^ (~a.n << 31));
  return x == 0 ? 1 : y;
}

template <class C>
ANYSL_TIER float tanInFloat(float x) {
  float t = fma(x, HalfPiF::inverse, RoundShiftF);
  TurnsF a = {remainderOf<HalfPiF>(x, t - RoundShiftF), bitsOf(t)};
  if (__builtin_expect(!(magnitude(x) < LargeArgument), 0))
    a = turnsLarge(x, 2, 0, 0x1.921fb54442d18p+0);
  float z = a.r * a.r;
  float y = fma(a.r * z, hornerFused(C::tan, z), a.r);
  return a.n & 1 ? -1 / y : y;
}

//===-- asin, acos, atan ----------------------------------------------------//

/// asin a for a <= 1/2, else asin sqrt((1−a)/2).
template <class C>
ANYSL_TIER float asinReducedF(float a) {
  bool upper = a > 0.5f;
  float z = upper ? fma(-0.5f, a, 0.5f) : a * a;
  float s = upper ? squareRoot(z) : a;
  return fma(s * z, hornerFused(C::asin, z), s);
}

template <class C>
ANYSL_TIER float asinInFloat(float x) {
  float a = magnitude(x);
  float s = asinReducedF<C>(a);
  float upper = fma(-2, s, 0x1.921fb6p+0f);
  if constexpr (!C::coarse)
    upper -= 0x1.777a5cp-25f;
  return copySign(a > 0.5f ? upper : s, x);
}

template <class C>
ANYSL_TIER float acosInFloat(float x) {
  float a = magnitude(x);
  float s = copySign(asinReducedF<C>(a), x);
  float outer = fma(2, s, x < 0 ? 0x1.921fb6p+1f : 0);
  return a > 0.5f ? outer : 0x1.921fb6p+0f - s;
}

template <class C>
ANYSL_TIER float atanUnit(float t) {
  float z = t * t;
  return fma(t * z, hornerFused(C::atan, z), t);
}

template <class C>
ANYSL_TIER float atanInFloat(float x) {
  float a = magnitude(x);
  bool steep = a > 1;
  float y = atanUnit<C>(steep ? -1 / a : a);
  return copySign(steep ? y + 0x1.921fb6p+0f : y, x);
}

template <class C>
ANYSL_TIER float atan2InFloat(float y, float x) {
  float ay = magnitude(y), ax = magnitude(x);
  bool steep = ay > ax;
  float small = steep ? ax : ay, large = steep ? ay : ax;
  float t = small / nonZero(large);
  t = small == large ? 1 : t; // infinite both
  t = large == 0 ? 0 : t;
  float a = atanUnit<C>(t);
  a = steep ? 0x1.921fb6p+0f - a : a;
  a = __builtin_signbit(x) ? 0x1.921fb6p+1f - a : a;
  a = x != x || y != y ? x + y : a;
  return copySign(a, y);
}

//===-- exp, exp2 and the hyperbolic functions ------------------------------//

template <class C>
ANYSL_TIER float expInFloat(float x) {
  if (__builtin_expect(!(magnitude(x) < 87), 0))
    return expInDouble<ShortPolynomials>(x);
  float t = fma(x, 0x1.715476p+0f, RoundShiftF);
  float n = t - RoundShiftF;
  if constexpr (C::coarse) {
    float f = fma(x, 0x1.715476p+0f, -n);
    return scaleBy(fma(f, hornerFused(C::exp2, f), 1), bitsOf(t));
  }
  float r = fma(-n, 0x1.62e43p-1f, x);
  r = fma(-n, -0x1.05c61p-29f, r);
  float y = fma(r * r, hornerFused(C::exp, r), r) + 1;
  return scaleBy(y, bitsOf(t));
}

template <class C>
ANYSL_TIER float exp2InFloat(float x) {
  if (__builtin_expect(!(magnitude(x) < 125), 0))
    return exp2InDouble<ShortPolynomials>(x);
  float t = x + RoundShiftF;
  float f = x - (t - RoundShiftF);
  return scaleBy(fma(f, hornerFused(C::exp2, f), 1), bitsOf(t));
}

/// sinh a and cosh a for 0 <= a <= 87; see Hyperbolic.
struct HyperbolicF {
  float sinh, cosh;
};
template <class C>
ANYSL_TIER HyperbolicF hyperbolicF(float a) {
  float t = fma(a, 0x1.715476p+0f, RoundShiftF);
  float n = t - RoundShiftF;
  float r = fma(-n, 0x1.62e43p-1f, a);
  r = fma(-n, -0x1.05c61p-29f, r);
  float z = r * r;
  constexpr Fusion F = Fusion::Always;
  float even = horner<F, 0, 2>(C::expm1, z), odd = r * horner<F, 1, 2>(C::expm1, z);
  float up = fromBits((bitsOf(t) << 23) + 0x3f000000u),
        down = fromBits(0x3f000000u - (bitsOf(t) << 23));
  float difference = up - down, sum = up + down;
  return {fma(r, fma(sum, even, difference * odd), difference),
          fma(r, fma(difference, even, sum * odd), sum)};
}

template <class C>
ANYSL_TIER float sinhInFloat(float x) {
  float a = magnitude(x);
  if (__builtin_expect(!(a < 87), 0))
    return sinhInDouble<ShortPolynomials>(x);
  HyperbolicF h = hyperbolicF<C>(a);
  return copySign(h.sinh, x);
}

template <class C>
ANYSL_TIER float coshInFloat(float x) {
  float a = magnitude(x);
  if (__builtin_expect(!(a < 87), 0))
    return coshInDouble<ShortPolynomials>(x);
  HyperbolicF h = hyperbolicF<C>(a);
  return h.cosh;
}

template <class C>
ANYSL_TIER float tanhInFloat(float x) {
  HyperbolicF h = hyperbolicF<C>(clampKeepNaN(magnitude(x), 0.0f, 15.0f));
  return copySign(h.sinh / h.cosh, x);
}

//===-- log, log2, log10 ----------------------------------------------------//

/// log x, given C's polynomial.
template <class C>
ANYSL_TIER float logInFloat(float x) {
  if (__builtin_expect(!isPositiveNormal(x), 0))
    return logInDouble<ShortPolynomials>(x);
  DecomposedF d = decomposeF(x);
  float l = fma(d.f, hornerFused(C::log, d.f), d.n * -0x1.05c61p-29f);
  return fma(d.n, 0x1.62e43p-1f, l);
}

template <class C>
ANYSL_TIER float log2InFloat(float x) {
  if (__builtin_expect(!isPositiveNormal(x), 0))
    return log2InDouble<ShortPolynomials>(x);
  DecomposedF d = decomposeF(x);
  return fma(d.f * hornerFused(C::log, d.f), 0x1.715476p+0f, d.n);
}

template <class C>
ANYSL_TIER float log10InFloat(float x) {
  if (__builtin_expect(!isPositiveNormal(x), 0))
    return log10InDouble<ShortPolynomials>(x);
  DecomposedF d = decomposeF(x);
  float l = d.f * hornerFused(C::log, d.f);
  return fma(d.n, 0x1.344136p-2f, fma(l, 0x1.bcb7b2p-2f, d.n * -0x1.ec10cp-27f));
}

//===-- pow -----------------------------------------------------------------//

/// The error of log2 x is multiplied by up to 125: it is computed in double, and for `fast` with
/// the polynomial of u35.
template <class C>
ANYSL_TIER float powInFloat(float x, float y) {
  float whole, part; // of the power's exponent
  bool special;
  if constexpr (C::coarse) {
    DecomposedF d = decomposeF(x);
    float l = fma(d.f * hornerFused(LogU35, d.f), 0x1.715476p+0f, d.n);
    float e = l * y;
    special = isSpecialPower(x, e);
    whole = e + RoundShiftF;
    part = e - (whole - RoundShiftF);
  } else {
    double e = log2ForPower<Fusion::Always>(x, AtanhPow) * double(y);
    special = isSpecialPower(x, e);
    whole = float(e) + RoundShiftF;
    part = float(e - double(whole - RoundShiftF));
  }
  if (__builtin_expect(special, 0))
    return powAny(x, y);
  float power = scaleBy(fma(part, hornerFused(C::exp2, part), 1), bitsOf(whole));
  power = y == 1 ? x : power;
  return y == 2 ? x * x : power;
}

//===-- roots ---------------------------------------------------------------//

template <class C>
ANYSL_TIER float cbrtInFloat(float x) {
  float a = magnitude(x);
  if (__builtin_expect(!isPositiveNormal(a), 0))
    return cbrtInDouble<ShortPolynomials>(x);
  UInt32 bits = bitsOf(a);
  float m = fromBits((bits & 0x007fffffu) | 0x3f800000u);
  UInt32 e = (bits >> 23) - 127 + 150;
  UInt32 q = (e * 21846) >> 16;
  UInt32 j = e - 3 * q;
  float r = hornerFused(C::inverseCbrt, m);
  float h = fma(-m * r, r * r, 1);
  r = fma(r * h, C::coarse ? 1.0f / 3 : fma(h, 2.0f / 9, 1.0f / 3), r);
  float y = m * (r * r);
  if constexpr (!C::coarse) // once more by Newton, since r·r has doubled r's error
    y = fma(fma(-y * y, y, m), r * r * (1.0f / 3), y);
  y *= j == 0 ? 1.0f : j == 1 ? 0x1.428a3p+0f : 0x1.965feap+0f;
  y *= fromBits((q + 127 - 50) << 23);
  return copySign(y, x);
}

ANYSL_TIER float inverseSqrtInFloat(float x) {
  InverseSqrt s = inverseSqrtStart(x);
  return s.y * s.scale;
}

/// The sides are scaled by the larger one's exponent, so that squares neither overflow nor vanish.
ANYSL_TIER float hypotInFloat(float x, float y) {
  float a = magnitude(x), b = magnitude(y);
  float large = a > b ? a : b, small = a > b ? b : a;
  UInt32 exponent = bitsOf(large) & 0x7f800000u;
  exponent = exponent < 0x00800000u ? 0x00800000u : exponent;
  exponent = exponent > 0x7e000000u ? 0x7e000000u : exponent;
  float down = fromBits(0x7f000000u - exponent), up = fromBits(exponent);
  large *= down;
  small *= down;
  float r = squareRoot(fma(small, small, large * large)) * up;
  r = x != x || y != y ? x + y : r;
  return a == Infinity<float> || b == Infinity<float> ? Infinity<float> : r;
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_INFLOAT_H
