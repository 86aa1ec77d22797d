//===-- runtimes/math/DoubleExpLog.h - exponentials, logarithms and roots of a double ---------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Within 1 ULP, in the manner of DoubleTrig.h.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_DOUBLEEXPLOG_H
#define ANYSL_RUNTIMES_MATH_DOUBLEEXPLOG_H

#include "runtimes/math/Coefficients.h"
#include "runtimes/math/DoubleCore.h"

namespace anysl::tier {

inline constexpr Pair Ln2Pair = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
inline constexpr Pair Log2EPair = {0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};
inline constexpr Pair Log10EPair = {0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};

//===-- exp, exp2 -----------------------------------------------------------//

/// y·2^n for |n| <= 2000: two factors, so that a denormal result is rounded once.
ANYSL_TIER double scaleBy(double y, Int32 n) {
  Int32 half = n >> 1;
  return y * powerOfTwo(UInt64(Int64(half))) * powerOfTwo(UInt64(Int64(n - half)));
}

/// x = n·log 2 + r.
struct Exponent64 {
  Pair r;
  Int32 n;
};
ANYSL_TIER Exponent64 exponentOf64(double x) {
  double t = x * Log2EPair.high + RoundShift;
  double n = t - RoundShift;
  return {fastSum(x - n * 0x1.62e42fefa2p-1, -(n * 0x1.9ef35793c7673p-41)), Int32(bitsOf(t))};
}

/// e^r = 1 + r.high + this.
ANYSL_TIER double expTail(Pair r) { return r.low + r.high * (r.high * horner(Exp64, r.high)); }

ANYSL_TIER double expOf(double x) {
  Exponent64 e = exponentOf64(clampKeepNaN(x, -800.0, 800.0));
  return scaleBy(1 + (e.r.high + expTail(e.r)), e.n);
}

/// 2^(x.high + x.low) for |x| <= 1200.
ANYSL_TIER double exp2Pair(Pair x) {
  double t = x.high + RoundShift;
  double f = x.high - (t - RoundShift);
  Pair r = product(f, Ln2Pair.high);
  r = fastSum(r.high, r.low + (f * Ln2Pair.low + x.low * Ln2Pair.high));
  return scaleBy(1 + (r.high + expTail(r)), Int32(bitsOf(t)));
}

ANYSL_TIER double exp2Of(double x) { return exp2Pair({clampKeepNaN(x, -1200.0, 1200.0), 0}); }

//===-- sinh, cosh, tanh ----------------------------------------------------//

/// sinh a = s·2^n and cosh a = c·2^n, a >= 0.
struct Hyperbolic64 {
  Pair s, c;
  Int32 n;
};
ANYSL_TIER Hyperbolic64 hyperbolic64(double a) {
  Exponent64 e = exponentOf64(a);
  Pair minus = {-e.r.high, -e.r.low};
  Pair up = fastSum(1, e.r.high), down = fastSum(1, minus.high);
  up.low += expTail(e.r);
  down.low += expTail(minus);
  // e^−a = down·2^−n; beside up·2^n it is nothing from n = 64 on.
  Int32 n = e.n > 64 ? 64 : e.n;
  n = n < 0 ? 0 : n; // NaN
  double factor = powerOfTwo(UInt64(Int64(-2 * n)));
  down = {down.high * factor, down.low * factor};
  Pair s = sumOrdered(up, {-down.high, -down.low}), c = sumOrdered(up, down);
  double z = a * a;
  Pair direct = fastSum(a, a * (z * horner(Sinh64, z)));
  bool small = a < 0.34375; // n is 0 below
  s = {small ? direct.high : 0.5 * s.high, small ? direct.low : 0.5 * s.low};
  return {s, {0.5 * c.high, 0.5 * c.low}, e.n};
}

ANYSL_TIER double sinhOf(double x) {
  Hyperbolic64 h = hyperbolic64(clampKeepNaN(magnitude(x), 0.0, 800.0));
  return copySign(scaleBy(h.s.high + h.s.low, h.n), x);
}

ANYSL_TIER double coshOf(double x) {
  Hyperbolic64 h = hyperbolic64(clampKeepNaN(magnitude(x), 0.0, 800.0));
  return scaleBy(h.c.high + h.c.low, h.n);
}

ANYSL_TIER double tanhOf(double x) {
  double a = magnitude(x);
  Hyperbolic64 h = hyperbolic64(clampKeepNaN(a, 0.0, 20.0));
  Pair y = quotient(h.s, h.c);
  return copySign(a < 0x1p-100 ? a : y.high + y.low, x);
}

//===-- log, log2, log10 ----------------------------------------------------//

/// A positive finite x as m·2^k, m in [sqrt 1/2, sqrt 2); denormal ones too.
ANYSL_TIER Decomposed decompose64(double x) {
  bool tiny = x < 0x1p-1022;
  Decomposed d = decompose(tiny ? x * 0x1p54 : x);
  d.exponent -= tiny ? 54 : 0;
  return d;
}

/// log m to about 2^-57: f − f²/2 with its rounding, and the rest after fdlibm's e_log.c.
ANYSL_TIER Pair logPair(double m) {
  double f = m - 1;
  double s = f / (2 + f);
  double z = s * s;
  Pair square = product(f, f);
  double half = 0.5 * square.high;
  Pair l = fastSum(f, -half);
  l.low += s * (half + 2 * (z * horner(AtanhCr, z))) - 0.5 * square.low;
  return fastSum(l.high, l.low);
}

ANYSL_TIER double logResult(double x, double y) {
  double special = x < 0 ? NotANumber<double> : x + x;
  special = x == 0 ? -Infinity<double> : special;
  return x > 0 && x < Infinity<double> ? y : special;
}

ANYSL_TIER double logOf(double x) {
  Decomposed d = decompose64(x);
  Pair l = logPair(d.m);
  Pair y = twoSum(d.exponent * 0x1.62e42fefa2p-1, l.high);
  return logResult(x, y.high + (y.low + (l.low + d.exponent * 0x1.9ef35793c7673p-41)));
}

ANYSL_TIER double log2Of(double x) {
  Decomposed d = decompose64(x);
  Pair l = product(logPair(d.m), Log2EPair);
  Pair y = twoSum(d.exponent, l.high);
  return logResult(x, y.high + (y.low + l.low));
}

ANYSL_TIER double log10Of(double x) {
  Decomposed d = decompose64(x);
  Pair l = product(logPair(d.m), Log10EPair);
  Pair y = twoSum(d.exponent * 0x1.34413509f6p-2, l.high);
  return logResult(x, y.high + (y.low + (l.low + d.exponent * 0x1.9fef311f12b36p-42)));
}

//===-- pow -----------------------------------------------------------------//

/// log2 of a positive finite x, relative to about 2^-66: the exponent of pow may be 1024, and its
/// absolute error is the relative error of the power. atanh's first two terms are pairs.
ANYSL_TIER Pair log2Accurate(double x) {
  Decomposed d = decompose64(x);
  double f = d.m - 1;
  Pair s = quotient({f, 0}, fastSum(2, f));
  Pair z = product(s, s);
  double tail = z.high * horner(AtanhTail64, z.high);
  Pair p = fastSum(0x1.999999999999ap-3, tail - 0x1.999999999999ap-57);
  p = product(p, z);
  p = sumOrdered({0x1.5555555555555p-2, 0x1.5555555555555p-56}, p);
  p = product(p, z);
  p = sumOrdered({1, 0}, p);
  p = product(product(s, p), Pair{2 * Log2EPair.high, 2 * Log2EPair.low});
  return sum({d.exponent, 0}, p);
}

ANYSL_TIER double powOf(double x, double y) {
  double a = magnitude(x);
  bool finite = a > 0 && a < Infinity<double>;
  Pair l = log2Accurate(finite ? a : 1);
  // Beyond these bounds only the sign of the exponent counts, and the product stays in range.
  double scaled = clampKeepNaN(y, -0x1p70, 0x1p70);
  Pair e = product(l, scaled);
  bool extreme = !(magnitude(e.high) < 1200);
  double high = clampKeepNaN(e.high, -1200.0, 1200.0);
  double power = exp2Pair({high, extreme ? 0 : e.low});
  double limit = (a == 0) == (y < 0) ? Infinity<double> : 0.0; // 0^−, inf^+ against 0^+, inf^−
  power = finite ? power : limit;
  power = a != a || y != y ? a + y : power;

  double ay = magnitude(y);
  double t = ay + 0x1p52;
  bool integer = ay >= 0x1p52 || t - 0x1p52 == ay;
  bool odd = integer && ay < 0x1p53 && (bitsOf(ay >= 0x1p52 ? ay : t) & 1);
  power = __builtin_signbit(x) && odd ? -power : power;
  power = x < 0 && a < Infinity<double> && !integer ? NotANumber<double> : power;
  power = y == 2 ? x * x : power;
  bool one = y == 0 || x == 1 || (a == 1 && ay == Infinity<double>);
  return one ? 1.0 : power;
}

//===-- roots ---------------------------------------------------------------//

ANYSL_TIER double cbrtOf(double x) {
  double a = magnitude(x);
  bool tiny = a < 0x1p-1022;
  UInt64 bits = bitsOf(tiny ? a * 0x1p54 : a);
  double m = fromBits((bits & 0x000fffffffffffffull) | 0x3ff0000000000000ull);
  // e + 1077 + 54 = 3q + j; 21846/65536 is close enough to 1/3 for these.
  UInt64 e = (bits >> 52) - 1023 + 1131 - (tiny ? 54 : 0);
  UInt64 q = (e * 21846) >> 16;
  UInt64 j = e - 3 * q;
  double r = horner(InverseCbrtCr, m);
  double h = 1 - m * r * r * r;
  r += r * (h * ((h * (14.0 / 81) + 2.0 / 9) * h + 1.0 / 3));
  double scale = j == 0 ? 1.0 : j == 1 ? 0x1.428a2f98d728bp+0 : 0x1.965fea53d6e3dp+0;
  double back = j == 0 ? 1.0 : j == 1 ? 0x1.965fea53d6e3dp-1 : 0x1.428a2f98d728bp-1;
  double slope = r * back;
  double y = m * r * r * scale;
  Pair cube = product(product(y, y), y);
  double rest = (m * (j == 0 ? 1.0 : j == 1 ? 2.0 : 4.0) - cube.high) - cube.low;
  y += rest * (slope * slope) * (1.0 / 3);
  y *= powerOfTwo(q - 377);
  return a > 0 && a < Infinity<double> ? copySign(y, x) : x + x;
}

ANYSL_TIER double inverseSqrtOf(double x) {
  double y = 1 / squareRoot(x);
  Pair p = product(product(x, y), y);
  double better = y + y * (0.5 * ((1 - p.high) - p.low));
  return x > 0 && x < Infinity<double> ? better : y;
}

ANYSL_TIER double hypotOf(double x, double y) {
  double a = magnitude(x), b = magnitude(y);
  double large = a > b ? a : b, small = a > b ? b : a;
  // Squares neither overflow nor lose their lower halves after scaling.
  double scale = large > 0x1p450 ? 0x1p-600 : large < 0x1p-400 ? 0x1p600 : 1.0;
  double back = large > 0x1p450 ? 0x1p600 : large < 0x1p-400 ? 0x1p-600 : 1.0;
  large *= scale;
  small *= scale;
  Pair s = sumOrdered(product(large, large), product(small, small));
  double r = squareRoot(s.high);
  Pair square = product(r, r);
  double rest = ((s.high - square.high) - square.low) + s.low;
  r = (r + rest / (r == 0 ? 1 : 2 * r)) * back;
  // NaN in x or y has lost to the other in the comparisons above.
  r = x != x || y != y ? x + y : r;
  return a == Infinity<double> || b == Infinity<double> ? Infinity<double> : r;
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_DOUBLEEXPLOG_H
