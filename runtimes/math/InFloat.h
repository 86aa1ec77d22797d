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
  static constexpr auto &expm1Twice = Expm1TwiceU35;
  static constexpr auto &log = LogU35;
  static constexpr auto &log2 = Log2U35;
  static constexpr auto &log10 = Log10U35;
  static constexpr auto &asin = AsinU35;
  static constexpr auto &atan = AtanU35;
  static constexpr bool coarse = false;
};

/// Polynomials to about 2^-13: results to about 2^-12.
struct CoarsePolynomials {
  static constexpr auto &sinPi = SinPiFast;
  static constexpr auto &tan = TanFast;
  static constexpr auto &exp = ExpFast;
  static constexpr auto &exp2 = Exp2Fast;
  static constexpr auto &expm1 = Expm1Fast;
  static constexpr auto &expm1Twice = Expm1TwiceFast;
  static constexpr auto &log = LogFast;
  static constexpr auto &log2 = Log2Fast;
  static constexpr auto &log10 = Log10Fast;
  static constexpr auto &asin = AsinFast;
  static constexpr auto &atan = AtanFast;
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

/// Turns of |x| >= LargeArgument in units of pi/Scale, r in radians; offset is 0 or 1/2. The
/// remainder is that of Payne and Hanek: its error is 2^-56 turns, and no float is within 2^-31
/// turns of a multiple of pi/2.
template <int Scale>
ANYSL_TIER TurnsF turnsLarge(float x, double offset) {
  UInt32 block = (bitsOf(x) >> 24) & 63;
  double scaled = double(x) * Scale;
  double a = scaled * InversePiHigh[block], b = scaled * InversePiLow[block];
  double t = ((a + b) - offset) + RoundShift;
  double r = (a - ((t - RoundShift) + offset)) + b;
  return {float(r * (0x1.921fb54442d18p+1 / Scale)), UInt32(bitsOf(t))};
}

/// The same to 2^-29 turns, and near 0 as above: loads take most of the time, and this is half of
/// them.
template <int Scale>
ANYSL_TIER TurnsF turnsLargeCoarse(float x, double offset) {
  double scaled = double(x) * Scale, inverse = InversePiRounded[(bitsOf(x) >> 23) & 127];
  double a = scaled * inverse, b = mulAdd<Fusion::Always>(scaled, inverse, -a);
  double t = (a - offset) + RoundShift;
  double r = (a - ((t - RoundShift) + offset)) + b;
  TurnsF turns = {float(r) * float(0x1.921fb54442d18p+1 / Scale), UInt32(bitsOf(t))};
  if (__builtin_expect(magnitude(turns.r) < 0x1p-12f, 0))
    turns = turnsLarge<Scale>(x, offset);
  return turns;
}

template <class C, int Scale>
ANYSL_TIER TurnsF turnsBeyond(float x, double offset) {
  return C::coarse ? turnsLargeCoarse<Scale>(x, offset) : turnsLarge<Scale>(x, offset);
}

template <class C>
ANYSL_TIER float sinInFloat(float x) {
  float t = fma(x, PiF::inverse, RoundShiftF);
  TurnsF a = {remainderOf<PiF>(x, t - RoundShiftF), bitsOf(t)};
  if (__builtin_expect(!(magnitude(x) < LargeArgument), 0))
    a = turnsBeyond<C, 1>(x, 0);
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
    a = turnsBeyond<C, 1>(x, 0.5);
  float z = a.r * a.r;
  float y = a.r * fma(z, hornerFused(C::sinPi, z), 1);
  y = fromBits(bitsOf(y) ^ (~a.n << 31));
  // The polynomial of u35 gives 1 there by itself.
  return C::coarse && x == 0 ? 1 : y;
}

template <class C>
ANYSL_TIER float tanInFloat(float x) {
  float t = fma(x, HalfPiF::inverse, RoundShiftF);
  TurnsF a = {remainderOf<HalfPiF>(x, t - RoundShiftF), bitsOf(t)};
  if (__builtin_expect(!(magnitude(x) < LargeArgument), 0))
    a = turnsBeyond<C, 2>(x, 0);
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

/// atan2 y x, given the quotient t of the smaller side and the larger one.
template <class C>
ANYSL_TIER float atan2FromQuotient(float t, bool steep, float y, float x) {
  float a = atanUnit<C>(t);
  a = steep ? 0x1.921fb6p+0f - a : a;
  a = __builtin_signbit(x) ? 0x1.921fb6p+1f - a : a;
  return copySign(a, y);
}

template <class C>
ANYSL_TIER float atan2InFloat(float y, float x) {
  // Magnitudes compare as their bits do.
  UInt32 ay = bitsOf(magnitude(y)), ax = bitsOf(magnitude(x));
  bool steep = ay > ax;
  UInt32 small = ay < ax ? ay : ax, large = ay > ax ? ay : ax;
  UInt32 least = 0x00800000, infinite = bitsOf(Infinity<float>);
  float bottom = fromBits(large > least ? large : least);
  float a = atan2FromQuotient<C>(fromBits(small) / bottom, steep, y, x);
  if (__builtin_expect(!(large - least < infinite - least), 0)) {
    // Denormal sides are taken as the integers that their bits are; two infinite ones are like two
    // ones, and one like 1 beside 0. Beside (0, 0) a maximum of integers keeps the divisor from 0,
    // since a choice would be taken out of the quotient.
    bool isInfinite = large >= infinite;
    UInt32 top = isInfinite ? small == infinite : small, finite = isInfinite ? 1 : large;
    bottom = float(Int32(finite > 1 ? finite : 1));
    a = atan2FromQuotient<C>(float(Int32(top)) / bottom, steep, y, x);
    a = large > infinite ? x + y : a;
  }
  return a;
}

//===-- exp, exp2 and the hyperbolic functions ------------------------------//

/// e^x = y·2^n, n in the low bits of t = n + RoundShiftF.
struct ScaledF {
  float y, t;
};
template <class C>
ANYSL_TIER ScaledF expScaled(float x) {
  float t = fma(x, 0x1.715476p+0f, RoundShiftF);
  float n = t - RoundShiftF;
  if constexpr (C::coarse) {
    float f = fma(x, 0x1.715476p+0f, -n);
    return {fma(f, hornerFused(C::exp2, f), 1), t};
  }
  float r = fma(-n, 0x1.62e43p-1f, x);
  r = fma(-n, -0x1.05c61p-29f, r);
  return {fma(r * r, hornerFused(C::exp, r), r) + 1, t};
}
template <class C>
ANYSL_TIER ScaledF exp2Scaled(float x) {
  float t = x + RoundShiftF;
  float f = x - (t - RoundShiftF);
  return {fma(f, hornerFused(C::exp2, f), 1), t};
}

/// y·2^n where that may be denormal or infinite, |n| <= 255.
ANYSL_TIER float scaleByAny(ScaledF s) {
  UInt32 n = bitsOf(s.t), bits = bitsOf(s.y) + (n << 23), infinite = bitsOf(Infinity<float>);
  // A denormal result counts steps of 2^-149 in its bits; the sum rounds it to a whole number of
  // them.
  float steps = scaleBy(s.y, n + 149);
  UInt32 tiny = bitsOf(steps + 0x1p23f) - bitsOf(0x1p23f);
  bool isTiny = int(s.t < RoundShiftF - 125) & int(steps < 0x1p23f);
  return fromBits(isTiny ? tiny : bits > infinite ? infinite : bits);
}

template <class C>
ANYSL_TIER float expInFloat(float x) {
  ScaledF s = expScaled<C>(x);
  float y = scaleBy(s.y, bitsOf(s.t));
  if (__builtin_expect(!(magnitude(x) < 87), 0)) {
    y = scaleByAny(expScaled<C>(clampKeepNaN(x, -110.0f, 95.0f)));
    y = x != x ? x : y;
  }
  return y;
}

template <class C>
ANYSL_TIER float exp2InFloat(float x) {
  ScaledF s = exp2Scaled<C>(x);
  float y = scaleBy(s.y, bitsOf(s.t));
  if (__builtin_expect(!(magnitude(x) < 125), 0)) {
    y = scaleByAny(exp2Scaled<C>(clampKeepNaN(x, -160.0f, 140.0f)));
    y = x != x ? x : y;
  }
  return y;
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

/// tanh a = u/(u + 2) with u = e^2a − 1
template <class C>
ANYSL_TIER float tanhInFloat(float x) {
  float a = magnitude(x);
  a = a > 15 ? 15 : a;
  float t = fma(a, 0x1.715476p+1f, RoundShiftF);
  // Half of log 2 in one float: where n is large, the result is 1 anyway.
  float r = fma(-(t - RoundShiftF), 0x1.62e43p-2f, a);
  float up = fromBits((bitsOf(t) << 23) + 0x3f800000u);
  float u = fma(up * r, hornerFused(C::expm1Twice, r), up - 1);
  return copySign(u / (u + 2), x);
}

//===-- log, log2, log10 ----------------------------------------------------//

/// log, log2 and log10 of (1 + f)·2^n, given C's polynomial.
template <class C>
struct LogF {
  static ANYSL_TIER float of(DecomposedF d) {
    return fma(float(d.n), 0x1.62e43p-1f, d.f * hornerFused(C::log, d.f));
  }
};
template <class C>
struct Log2F {
  static ANYSL_TIER float of(DecomposedF d) {
    return fma(d.f, hornerFused(C::log2, d.f), float(d.n));
  }
};
template <class C>
struct Log10F {
  static ANYSL_TIER float of(DecomposedF d) {
    return fma(float(d.n), 0x1.344136p-2f, d.f * hornerFused(C::log10, d.f));
  }
};

/// A logarithm of any x.
template <class Log>
ANYSL_TIER float logarithmInFloat(float x) {
  float y = Log::of(decomposeF(x));
  if (__builtin_expect(!isPositiveNormal(x), 0))
    y = isPositiveFinite(x) ? Log::of(decomposeAnyF(x)) : logSpecial(x);
  return y;
}

//===-- pow -----------------------------------------------------------------//

/// The error of log2 x is multiplied by up to 125: `fast` takes the polynomial of u35.
using Log2ForPower = Log2F<MediumPolynomials>;

/// Any x^y.
ANYSL_TIER float powAnyCoarse(float x, float y) {
  float a = magnitude(x);
  float l = Log2ForPower::of(decomposeAnyF(a));
  l = a == 0 ? -Infinity<float> : l;
  l = a < Infinity<float> ? l : a;
  float e = clampKeepNaN(l * y, -160.0f, 140.0f);
  float power = scaleByAny(exp2Scaled<CoarsePolynomials>(e));
  power = powSpecial(x, y, e != e ? e : power);
  return y == 1 ? x : power;
}

/// In double, to 2^-24.
struct MediumPower {
  static constexpr bool denormals = false;
  static constexpr Fusion fusion = Fusion::Always;
  static constexpr auto &log2 = Log2PowU35;
  static constexpr auto &exp2 = Exp2PowU35;
};

template <class C>
ANYSL_TIER float powInFloat(float x, float y) {
  if constexpr (!C::coarse)
    return y == 1 ? x : powInDouble<MediumPower>(x, y);
  float e = Log2ForPower::of(decomposeF(x)) * y;
  ScaledF s = exp2Scaled<CoarsePolynomials>(e);
  float power = scaleBy(s.y, bitsOf(s.t));
  power = y == 1 ? x : power;
  power = y == 2 ? x * x : power;
  if (__builtin_expect(int(!isPositiveNormal(x)) | !(magnitude(e) < 125), 0))
    power = powAnyCoarse(x, y);
  return power;
}

//===-- roots ---------------------------------------------------------------//

/// The cube root of a positive normal a.
template <class C>
ANYSL_TIER float cbrtNormalF(float a) {
  // Bits are a logarithm, more or less: from a third of them comes 1/cbrt a, within 4 %.
  Int32 start = Int32(fma(float(Int32(bitsOf(a))), -1.0f / 3, 0x1.5288p+30f));
  float r = fromBits(UInt32(start));
  float h = fma(-(a * r), r * r, 1);
  r = fma(r * h, horner<Fusion::Always, 1>(CbrtStep, h), r);
  float y = (a * r) * r;
  if constexpr (!C::coarse) // once more by Newton
    y = fma(fma(-y * y, y, a), r * r * (1.0f / 3), y);
  return y;
}

template <class C>
ANYSL_TIER float cbrtInFloat(float x) {
  // Below, denormal numbers would come up, which take long.
  UInt32 least = bitsOf(0x1p-100f), bits = bitsOf(magnitude(x));
  float y = copySign(cbrtNormalF<C>(fromBits(bits > least ? bits : least)), x);
  if (__builtin_expect(!(bits - least < bitsOf(Infinity<float>) - least), 0)) {
    // The number times 2^150.
    float large = bits < 0x00800000u ? float(Int32(bits << 1)) : fromBits(bits + (150 << 23));
    float root = copySign(cbrtNormalF<C>(large) * 0x1p-50f, x);
    y = bits - 1 < least ? root : x + x;
  }
  return y;
}

ANYSL_TIER float inverseSqrtInFloat(float x) {
  InverseSqrt s = inverseSqrtStart(x);
  return s.y * s.scale;
}

/// Where squares overflow or vanish, the sides are scaled by the larger one's exponent.
ANYSL_TIER float hypotScaled(float x, float y) {
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

ANYSL_TIER float hypotInFloat(float x, float y) {
  float square = fma(x, x, y * y);
  float r = squareRoot(square);
  UInt32 least = bitsOf(0x1p-100f), infinite = bitsOf(Infinity<float>);
  if (__builtin_expect(!(bitsOf(square) - least < infinite - least), 0))
    r = hypotScaled(x, y);
  return r;
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_INFLOAT_H
