//===-- runtimes/math/InDouble.h - float functions evaluated in double ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// For one rounding of a float, a polynomial of six to nine terms in double costs less than a
// shorter one in float with the compensations that 1 ULP asks for. The tiers u10 and cr are both
// made from this file; the parameter C, one of the two structures below, brings the polynomials and
// decides where cr takes an extra step.
//
// A float never overflows, underflows or is denormal as a double, so whole ranges of special cases
// fall away; the final conversion makes denormals and infinities.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_INDOUBLE_H
#define ANYSL_RUNTIMES_MATH_INDOUBLE_H

#include "runtimes/math/Coefficients.h"
#include "runtimes/math/Core.h"
#include "runtimes/math/DoubleTrig.h"
#include "runtimes/math/Special.h"
#include "runtimes/math/Turns.h"

namespace anysl::tier {

/// Polynomials to about 2^-28: results within 0.53 ULP.
struct ShortPolynomials {
  static constexpr bool exact = false;
  static constexpr Fusion fusion = Fusion::Never;
  static constexpr auto &sinPi = SinPiU10;
  static constexpr auto &sin = SinU10;
  static constexpr auto &cos = CosU10;
  static constexpr auto &exp2 = Exp2U10;
  static constexpr auto &expm1 = Expm1U10;
  static constexpr auto &atan = AtanU10;
  static constexpr auto &inverseCbrt = InverseCbrtU10;
  struct Pi {
    static constexpr double inverse = 0x1.45f306dc9c883p-2, high = 0x1.921fb54p+1,
                            middle = 0x1.10b4611a62633p-29, low = 0;
  };
  struct HalfPi {
    static constexpr double inverse = 0x1.45f306dc9c883p-1, high = 0x1.921fb54p+0,
                            middle = 0x1.10b4611a62633p-30, low = 0;
  };
};

/// Polynomials to about 2^-55.
struct LongPolynomials {
  static constexpr bool exact = true;
  static constexpr Fusion fusion = Fusion::AsFits;
  static constexpr auto &sinPi = SinPiCr;
  static constexpr auto &sin = SinCr;
  static constexpr auto &cos = CosCr;
  static constexpr auto &exp2 = ExpCr;
  static constexpr auto &expm1 = ExpCr;
  static constexpr auto &asin = AsinCr;
  static constexpr auto &atan = AtanCr;
  static constexpr auto &inverseCbrt = InverseCbrtCr;
  struct Pi {
    static constexpr double inverse = 0x1.45f306dc9c883p-2, high = 0x1.921fb54p+1,
                            middle = 0x1.10b46118p-29, low = 0x1.313198a2e037p-60;
  };
  struct HalfPi {
    static constexpr double inverse = 0x1.45f306dc9c883p-1, high = 0x1.921fb54p+0,
                            middle = 0x1.10b46118p-30, low = 0x1.313198a2e037p-61;
  };
};

inline constexpr double Pi = 0x1.921fb54442d18p+1, PiLow = 0x1.1a62633145c07p-53;
inline constexpr double Log2E = 0x1.71547652b82fep+0, Log10E = 0x1.bcb7b1526e50ep-2;
/// log 2 with 40 bits, and the rest; the same for log10 2.
inline constexpr double Ln2High = 0x1.62e42fefa2p-1, Ln2Low = 0x1.9ef35793c7673p-41;
inline constexpr double Log10TwoHigh = 0x1.34413509f6p-2, Log10TwoLow = 0x1.9fef311f12b36p-42;

//===-- sin, cos, tan -------------------------------------------------------//

/// sin r for |r| <= pi/2. The product form keeps −0 where the sum r + r·(…) would not.
template <class C>
ANYSL_TIER double sinNear(double r) {
  double z = r * r;
  if constexpr (C::exact)
    return mulAdd<C::fusion>(r * z, horner<C::fusion>(C::sinPi, z), r);
  return r * mulAdd<C::fusion>(z, horner<C::fusion>(C::sinPi, z), 1.0);
}

/// sin x or cos x for |x| >= HugeArgument.
template <class C, bool Cosine>
ANYSL_TIER double sinOrCosHuge(double x) {
  Turns t = turnsHuge(x, 1, Cosine ? -0.5 : 0);
  return fromBits(bitsOf(sinNear<C>(t.r * Pi)) ^ ((Cosine ? ~t.n : t.n) << 63));
}

/// Whether x is so near the middle between two normal floats that an error of `doubt` units in its
/// last place may have it rounded wrongly.
ANYSL_TIER bool isNearMiddle(double x, UInt64 doubt = 8) {
  constexpr UInt64 middle = 0x10000000;
  return (bitsOf(x) + (middle + doubt)) % (2 * middle) < 2 * doubt;
}

/// sin x or cos x there, from a remainder of two doubles.
template <bool Cosine>
ANYSL_TIER double sinOrCosNearMiddle(double x) {
  Turns t = turnsHuge(x, 2, 0);
  Quadrant huge = {product(Pair{t.r, t.low}, HalfPiPair), t.n}, near = quadrantNear(x);
  bool isHuge = magnitude(x) >= HugeArgument64;
  return sinOrCosForFloat({{isHuge ? huge.r.high : near.r.high, isHuge ? huge.r.low : near.r.low},
                           (isHuge ? huge.n : near.n) + Cosine});
}

/// sin x or cos x, given that of the remainder from turnsNear.
template <class C, bool Cosine>
ANYSL_TIER float sinOrCosFrom(double y, float x) {
  if (__builtin_expect(magnitude(x) >= HugeArgument, 0))
    y = sinOrCosHuge<C, Cosine>(x);
  if constexpr (C::exact)
    if (__builtin_expect(isNearMiddle(y), 0))
      y = sinOrCosNearMiddle<Cosine>(x);
  return float(y);
}

template <class C>
ANYSL_TIER float sinInDouble(float x) {
  Turns t = turnsNear<typename C::Pi, C::fusion>(x);
  double y = fromBits(bitsOf(sinNear<C>(t.r)) ^ (t.n << 63));
  float s = sinOrCosFrom<C, false>(y, x);
  return C::exact && x == 0 ? x : s;
}

template <class C>
ANYSL_TIER float cosInDouble(float x) {
  Turns t = turnsNear<typename C::Pi, C::fusion, true>(x);
  double y = fromBits(bitsOf(sinNear<C>(t.r)) ^ (~t.n << 63));
  return sinOrCosFrom<C, true>(y, x);
}

template <class C>
ANYSL_TIER float tanInDouble(float x) {
  Turns t = turnsNear<typename C::HalfPi, C::fusion>(x);
  if (__builtin_expect(magnitude(x) >= HugeArgument, 0)) {
    t = turnsHuge(x, 2, 0);
    t.r *= Pi / 2;
  }
  double z = t.r * t.r;
  double s = t.r * mulAdd<C::fusion>(z, horner<C::fusion>(C::sin, z), 1.0);
  double c = mulAdd<C::fusion>(z, mulAdd<C::fusion>(z, horner<C::fusion>(C::cos, z), -0.5), 1.0);
  bool odd = t.n & 1;
  return float((odd ? -c : s) / (odd ? s : c));
}

//===-- asin, acos, atan ----------------------------------------------------//

/// asin a for a = |x| <= 1/2; above, asin of sqrt((1−a)/2), from which asin a = pi/2 − 2·that.
struct HalfAngle {
  double angle;
  bool upper;
};
template <class C>
ANYSL_TIER HalfAngle asinReduced(double a) {
  bool upper = a > 0.5;
  double z = upper ? 0.5 - 0.5 * a : a * a;
  double s = upper ? squareRoot(z) : a;
  return {mulAdd<C::fusion>(s * z, horner<C::fusion>(C::asin, z), s), upper};
}

template <class C>
ANYSL_TIER float asinInDouble(float x) {
  HalfAngle h = asinReduced<C>(magnitude(x));
  double y = h.upper ? (Pi / 2 - 2 * h.angle) + PiLow / 2 : h.angle;
  return copySign(float(y), x);
}

template <class C>
ANYSL_TIER float acosInDouble(float x) {
  HalfAngle h = asinReduced<C>(magnitude(x));
  double signedAngle = copySign(h.angle, double(x));
  double middle = (Pi / 2 - signedAngle) + PiLow / 2;
  double outer = 2 * signedAngle;
  outer = x < 0 ? (Pi + outer) + PiLow : outer;
  return float(h.upper ? outer : middle);
}

/// The angle of (x, y) in the first octants: atan(y/x) for x, y >= 0, not both infinite.
/// Above tan(pi/8) of the smaller to the larger side the point is turned back by pi/4, which costs
/// no second division.
template <class C>
ANYSL_TIER double atanQuadrant(double y, double x) {
  bool steep = y > x;
  double small = steep ? x : y, large = steep ? y : x;
  bool turned = small > large * 0x1.a827999fcef32p-2;
  double top = turned ? small - large : small;
  double bottom = turned ? small + large : large;
  double t = top / nonZero(bottom);
  double z = t * t;
  if constexpr (!C::exact) {
    double a = t * (z * horner<C::fusion>(C::atan, z) + 1);
    double base = turned ? Pi / 4 : 0;
    return steep ? (Pi / 2 - base) - a : base + a;
  }
  double low = t * (z * horner<C::fusion>(C::atan, z));
  // The angle is base ± (t + low); the sums are exact enough when the large term comes last.
  double base = turned ? Pi / 4 : 0;
  double baseLow = turned ? PiLow / 4 : 0;
  base = steep ? Pi / 2 - base : base;
  baseLow = steep ? PiLow / 2 - baseLow : baseLow;
  t = steep ? -t : t;
  low = steep ? -low : low;
  return base + (t + (low + baseLow));
}

template <class C>
ANYSL_TIER float atanInDouble(float x) {
  // 1/large is 0 in float already where an infinite x would give inf/inf in the turned form.
  double a = clampKeepNaN(double(magnitude(x)), 0.0, 0x1p60);
  return copySign(float(atanQuadrant<C>(a, 1)), x);
}

/// The angle of (x, y), from 0 to pi.
template <class C>
ANYSL_TIER double angleOf(float y, float x) {
  double ay = magnitude(y), ax = magnitude(x);
  // Two infinities have the angle of (1, 1); one against a finite number that of 2^300.
  ay = ay == Infinity<double> ? 0x1p300 : ay;
  ax = ax == Infinity<double> ? 0x1p300 : ax;
  double angle = atanQuadrant<C>(ay, ax);
  return __builtin_signbit(x) ? (Pi - angle) + PiLow : angle;
}

/// An angle with y's sign, or the NaN that is among the arguments.
ANYSL_TIER float atan2Special(float y, float x, float angle) {
  angle = x != x ? x : angle;
  return y != y ? y : copySign(angle, y);
}

template <class C>
ANYSL_TIER float atan2InDouble(float y, float x) {
  return atan2Special(y, x, float(angleOf<C>(y, x)));
}

//===-- exp, exp2 and the hyperbolic functions ------------------------------//

/// x as n·log 2 + r, or in units of the base of C's polynomial. `bits` holds n in its low bits.
struct Exponent {
  double r;
  UInt64 bits;
};
template <class C>
ANYSL_TIER Exponent exponentOf(double x) {
  double y = x * Log2E;
  double t = y + RoundShift;
  double n = t - RoundShift;
  if constexpr (C::exact)
    return {mulAdd<C::fusion>(-n, Ln2Low, mulAdd<C::fusion>(-n, Ln2High, x)), bitsOf(t)};
  return {y - n, bitsOf(t)};
}

/// 2^n·(1 + r·P(r)); a NaN in r stays one.
template <class C>
ANYSL_TIER double expReduced(Exponent e) {
  double y = mulAdd<C::fusion>(e.r, horner<C::fusion>(C::exp2, e.r), 1.0);
  return fromBits(bitsOf(y) + (e.bits << 52));
}

template <class C>
ANYSL_TIER float expInDouble(float x) {
  return float(expReduced<C>(exponentOf<C>(clampKeepNaN(double(x), -120.0, 100.0))));
}

template <class C>
ANYSL_TIER float exp2InDouble(float x) {
  double d = clampKeepNaN(double(x), -160.0, 140.0);
  double t = d + RoundShift;
  double f = d - (t - RoundShift);
  if constexpr (C::exact)
    f *= 0x1.62e42fefa39efp-1;
  return float(expReduced<C>({f, bitsOf(t)}));
}

/// sinh and cosh of |x|, both halves of e^x = 2^n·(1 + r·P(r)) and e^−x = 2^−n·(1 − r·P(−r)) added
/// up so that nothing cancels: P(±r) = A(r²) ± r·B(r²).
struct Hyperbolic {
  double sinh, cosh;
};
template <class C>
ANYSL_TIER Hyperbolic hyperbolic(double a) {
  Exponent e = exponentOf<C>(a);
  double z = e.r * e.r;
  double even = horner<C::fusion, 0, 2>(C::expm1, z), odd = horner<C::fusion, 1, 2>(C::expm1, z);
  double up = fromBits((e.bits << 52) + 0x3fe0000000000000ull);
  double down = fromBits(0x3fe0000000000000ull - (e.bits << 52));
  double difference = up - down, sum = up + down;
  odd *= e.r;
  constexpr Fusion F = C::fusion;
  return {mulAdd<F>(e.r, mulAdd<F>(sum, even, difference * odd), difference),
          mulAdd<F>(e.r, mulAdd<F>(difference, even, sum * odd), sum)};
}

template <class C>
ANYSL_TIER float sinhInDouble(float x) {
  double y = hyperbolic<C>(clampKeepNaN(double(magnitude(x)), 0.0, 100.0)).sinh;
  return copySign(float(y), x);
}

template <class C>
ANYSL_TIER float coshInDouble(float x) {
  return float(hyperbolic<C>(clampKeepNaN(double(magnitude(x)), 0.0, 100.0)).cosh);
}

template <class C>
ANYSL_TIER float tanhInDouble(float x) {
  Hyperbolic h = hyperbolic<C>(clampKeepNaN(double(magnitude(x)), 0.0, 20.0));
  return copySign(float(h.sinh / h.cosh), x);
}

//===-- log, log2, log10 ----------------------------------------------------//

/// log m for m in [sqrt 1/2, sqrt 2).
template <class C>
ANYSL_TIER double logNear(double m) {
  double f = m - 1;
  if constexpr (C::exact) {
    // f − s·… with s = f/(2+f): log(1+f) = 2 atanh(s), and 2s = f − s·f. See fdlibm's e_log.c for
    // this form, in which the rounding of s counts little.
    double s = f / (2 + f);
    double z = s * s;
    double half = 0.5 * f * f;
    double tail = mulAdd<C::fusion>(2 * z, horner<C::fusion>(AtanhCr, z), half);
    return f - mulAdd<C::fusion>(-s, tail, half);
  }
  double g = f * f;
  return f + g * (f * horner(LogU10, f) - 0.5);
}

template <class C>
ANYSL_TIER float logInDouble(float x) {
  Decomposed d = decompose(x);
  double y = d.exponent * Ln2High + (logNear<C>(d.m) + d.exponent * Ln2Low);
  return isPositiveFinite(x) ? float(y) : logSpecial(x);
}

template <class C>
ANYSL_TIER float log2InDouble(float x) {
  Decomposed d = decompose(x);
  return isPositiveFinite(x) ? float(mulAdd<C::fusion>(logNear<C>(d.m), Log2E, d.exponent))
                             : logSpecial(x);
}

template <class C>
ANYSL_TIER float log10InDouble(float x) {
  Decomposed d = decompose(x);
  double y = d.exponent * Log10TwoHigh + (logNear<C>(d.m) * Log10E + d.exponent * Log10TwoLow);
  return isPositiveFinite(x) ? float(y) : logSpecial(x);
}

//===-- pow -----------------------------------------------------------------//

/// Polynomials for a power within 0.54 ULP: log2 to 2^-37, since up to 128 times its error counts.
struct ShortPower {
  static constexpr bool denormals = false; ///< whether denormal bases are ordinary
  static constexpr Fusion fusion = Fusion::Never;
  static constexpr auto &log2 = Log2Pow;
  static constexpr auto &exp2 = Exp2Pow;
};

template <class C>
ANYSL_TIER double log2ForPower(DecomposedF d) {
  double f = d.f;
  double s = f / (2 + f);
  return mulAdd<C::fusion>(s, estrin<C::fusion>(C::log2, s * s), double(d.n));
}

/// 2^e within the range of float, before it is rounded to that; NaN for NaN.
template <class C>
ANYSL_TIER double exp2ForPower(double e) {
  e = clampKeepNaN(e, -160.0, 140.0);
  double t = e + RoundShift;
  double y = estrin<C::fusion>(C::exp2, e - (t - RoundShift));
  return fromBits(bitsOf(y) + (bitsOf(t) << 52));
}

/// Stands for the infinite logarithms of 0 and infinity: times the least y it is still out of any
/// power's range, and times 0 it raises nothing in a lane that idles.
inline constexpr double EndlessLog2 = 0x1p+1000;

/// Any x^y.
ANYSL_TIER float powAny(float x, float y) {
  float a = magnitude(x);
  double l = log2ForPower<ShortPower>(decomposeAnyF(a));
  l = a == 0 ? -EndlessLog2 : l;
  l = a == Infinity<float> ? EndlessLog2 : l;
  l = a != a ? double(a) : l;
  return powSpecial(x, y, float(exp2ForPower<ShortPower>(l * double(y))));
}

/// x^y as a double, where `isOrdinary`.
struct OrdinaryPower {
  double power;
  bool isOrdinary;
};
template <class C>
ANYSL_TIER OrdinaryPower ordinaryPower(float x, float y) {
  // +0 is an ordinary base: highlights raise it wherever a light is behind the surface. Its
  // logarithm is as good as infinite for the exponents that are ordinary: those of magnitude 2^-20
  // to the largest number.
  bool zero = bitsOf(x) == 0;
  DecomposedF d = C::denormals ? decomposeAnyF(x) : decomposeF(x);
  d.n = zero ? -0x10000000 : d.n;
  constexpr UInt32 least = 0x35800000, infinite = 0x7f800000;
  bool ordinaryY = (bitsOf(y) << 1) - (least << 1) < ((infinite - least) << 1);
  bool ordinaryX = C::denormals ? bitsOf(x) < infinite : zero | isPositiveNormal(x);
  return {exp2ForPower<C>(log2ForPower<C>(d) * double(y)), bool(int(ordinaryX) & ordinaryY)};
}

template <class C>
ANYSL_TIER float powInDouble(float x, float y) {
  OrdinaryPower p = ordinaryPower<C>(x, y);
  float power = y == 2 ? x * x : float(p.power);
  if (__builtin_expect(!p.isOrdinary, 0))
    power = powAny(x, y);
  return power;
}

//===-- roots ---------------------------------------------------------------//

template <class C>
ANYSL_TIER float cbrtInDouble(float x) {
  double a = magnitude(x);
  UInt64 bits = bitsOf(a);
  double m = fromBits((bits & 0x000fffffffffffffull) | 0x3ff0000000000000ull);
  // The exponent of a float lies in [−149, 127]; e + 150 = 3q + j by a multiplication.
  UInt64 e = (bits >> 52) - 1023 + 150;
  UInt64 q = (e * 21846) >> 16;
  UInt64 j = e - 3 * q;
  double r = horner<C::fusion>(C::inverseCbrt, m);
  double h = 1 - m * r * r * r;
  if constexpr (C::exact)
    r += r * (h * ((h * (14.0 / 81) + 2.0 / 9) * h + 1.0 / 3));
  else
    r += r * (h * (h * (2.0 / 9) + 1.0 / 3));
  double root = m * r * r;
  double scale = j == 0 ? 1.0 : j == 1 ? 0x1.428a2f98d728bp+0 : 0x1.965fea53d6e3dp+0;
  root *= scale * powerOfTwo(q - 50);
  bool ordinary = a > 0 && a < Infinity<double>;
  return ordinary ? copySign(float(root), x) : x + x;
}

/// 1/sqrt(x)·2^-75 for denormal x, else 1/sqrt(x), in float, and the x to which that belongs. The
/// bits of a denormal number, taken as an integer, are a normal number 2^149 times as large:
/// arithmetic on denormal numbers takes the processor a hundred times as long.
struct InverseSqrt {
  float x, y, scale;
};
ANYSL_TIER InverseSqrt inverseSqrtStart(float x) {
  bool tiny = bitsOf(x) < 0x00800000u;
  float m = tiny ? float(Int32(bitsOf(x) << 1)) : x;
  return {m, 1 / squareRoot(m), tiny ? 0x1p75f : 1};
}

/// One step of Newton's iteration in double from a float quotient, to 2^-45.
ANYSL_TIER double inverseSqrtStep(InverseSqrt s) {
  double r = s.y;
  return r + r * (0.5 * (1 - double(s.x) * (r * r)));
}

ANYSL_TIER float inverseSqrtInDouble(float x) {
  InverseSqrt s = inverseSqrtStart(x);
  bool ordinary = s.x > 0 && s.x < Infinity<float>;
  return (ordinary ? float(inverseSqrtStep(s)) : s.y) * s.scale;
}

ANYSL_TIER float hypotInDouble(float x, float y) {
  double a = x, b = y;
  double r = squareRoot(a * a + b * b);
  bool infinite = magnitude(x) == Infinity<float> || magnitude(y) == Infinity<float>;
  return infinite ? Infinity<float> : float(r);
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_INDOUBLE_H
