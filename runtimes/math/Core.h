//===-- runtimes/math/Core.h - what the math tiers are written with ---------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Small helpers. All code of the tiers is meant to be inlined and widened: it computes every case
// and selects, a branch stands only where a rare and long path can be jumped over by all lanes, and
// nothing but IEEE +, −, ·, /, sqrt, comparisons, conversions and integer operations is used. There
// is no fused multiply-add: an instruction set without one would have to call a function for each,
// and the results could not be the same there. docs/numerics.md has the reasons and figures.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_CORE_H
#define ANYSL_RUNTIMES_MATH_CORE_H

#define ANYSL_TIER inline __attribute__((always_inline, nothrow))

namespace anysl::tier {

using Int32 = int;
using UInt32 = unsigned;
using Int64 = long long;
using UInt64 = unsigned long long;

ANYSL_TIER UInt32 bitsOf(float x) { return __builtin_bit_cast(UInt32, x); }
ANYSL_TIER UInt64 bitsOf(double x) { return __builtin_bit_cast(UInt64, x); }
ANYSL_TIER float fromBits(UInt32 x) { return __builtin_bit_cast(float, x); }
ANYSL_TIER double fromBits(UInt64 x) { return __builtin_bit_cast(double, x); }

ANYSL_TIER float magnitude(float x) { return __builtin_fabsf(x); }
ANYSL_TIER double magnitude(double x) { return __builtin_fabs(x); }
ANYSL_TIER float squareRoot(float x) { return __builtin_sqrtf(x); }
ANYSL_TIER double squareRoot(double x) { return __builtin_sqrt(x); }
ANYSL_TIER float copySign(float x, float s) { return __builtin_copysignf(x, s); }
ANYSL_TIER double copySign(double x, double s) { return __builtin_copysign(x, s); }

/// x; where it is 0, ±1: what to divide by so that no flag is raised. In bits, because the
/// optimizer takes `x == 0 ? 1 : x` out of a quotient again.
ANYSL_TIER float nonZero(float x) { return fromBits(bitsOf(x) | (x == 0 ? bitsOf(1.0f) : 0)); }
ANYSL_TIER double nonZero(double x) { return fromBits(bitsOf(x) | (x == 0 ? bitsOf(1.0) : 0)); }

template <class T>
inline constexpr T Infinity = T(__builtin_inf());
template <class T>
inline constexpr T NotANumber = T(__builtin_nan(""));

/// Keeps x within [low, high]; NaN stays NaN.
template <class T>
ANYSL_TIER T clampKeepNaN(T x, T low, T high) {
  x = x < low ? low : x;
  return x > high ? high : x;
}

/// How a kernel multiplies and adds.
enum class Fusion {
  Never,  ///< two roundings, on every instruction set
  AsFits, ///< one rounding where the processor has the instruction: only where the bits of the
          ///< result do not depend on it, as they do not when a result is correctly rounded
  Always, ///< one rounding; a call of the C library on a processor without the instruction
};

/// a·b + c
template <Fusion F, class T>
ANYSL_TIER T mulAdd(T a, T b, T c) {
  if constexpr (F == Fusion::Never) {
    return a * b + c;
  } else if constexpr (F == Fusion::AsFits) {
#pragma clang fp contract(on)
    return a * b + c;
  } else if constexpr (sizeof(T) == 4) {
    return __builtin_fmaf(a, b, c);
  } else {
    return __builtin_fma(a, b, c);
  }
}

/// The polynomial with coefficients C (lowest degree first) at x, by Horner's rule, taking every
/// `Step`th coefficient from `First` on. A recursion, not a loop, so that nothing has to be
/// unrolled before widening.
template <Fusion F = Fusion::Never, int First = 0, int Step = 1, class T, int N>
ANYSL_TIER T horner(const T (&c)[N], T x) {
  if constexpr (First + Step >= N)
    return c[First];
  else
    return mulAdd<F>(horner<F, First + Step, Step>(c, x), x, c[First]);
}

/// Coefficients First to Last of `estrin`'s polynomial; squares[i] is x^(2^i).
template <Fusion F, int First, int Last, class T, int N>
ANYSL_TIER T estrinPart(const T (&c)[N], const T (&squares)[4]) {
  if constexpr (First == Last) {
    return c[First];
  } else {
    constexpr int level = 31 - __builtin_clz(unsigned(Last - First));
    constexpr int middle = First + (1 << level);
    return mulAdd<F>(estrinPart<F, middle, Last>(c, squares), squares[level],
                     estrinPart<F, First, middle - 1>(c, squares));
  }
}

/// The polynomial as a tree instead of `horner`'s chain (Estrin's scheme): a few more operations,
/// of which more run at once. Sums of the leading coefficients are rounded more often.
template <Fusion F = Fusion::Never, class T, int N>
ANYSL_TIER T estrin(const T (&c)[N], T x) {
  static_assert(N <= 16);
  T x2 = x * x, x4 = x2 * x2;
  const T squares[4] = {x, x2, x4, x4 * x4};
  return estrinPart<F, 0, N - 1>(c, squares);
}

/// x + RoundShift has the integer nearest to x (ties to even) in its low bits, |x| <= 2^51.
inline constexpr double RoundShift = 0x1.8p52;
/// The same for float, |x| <= 2^22.
inline constexpr float RoundShiftF = 0x1.8p23f;

/// 2^n for −1022 <= n <= 1023.
ANYSL_TIER double powerOfTwo(UInt64 n) { return fromBits((n + 1023) << 52); }

/// y·2^n where that is normal; n in the low bits of `bits`.
ANYSL_TIER float scaleBy(float y, UInt32 bits) { return fromBits(bitsOf(y) + (bits << 23)); }

/// A float as (1 + f)·2^n, 1 + f in [sqrt 1/2, sqrt 2), where it is positive, normal and finite; f
/// is in that range for all others too.
struct DecomposedF {
  float f;
  Int32 n;
};
ANYSL_TIER DecomposedF decomposeF(float x) {
  constexpr UInt32 rootHalf = 0x3f3504f3;
  Int32 n = Int32(bitsOf(x) - rootHalf) >> 23;
  return {fromBits(bitsOf(x) - (UInt32(n) << 23)) - 1, n};
}
/// The same for denormal numbers as well: the bits of one, taken as an integer, are a normal number
/// 2^149 times as large, and no arithmetic on denormal numbers is needed, which takes processors a
/// hundred times as long.
ANYSL_TIER DecomposedF decomposeAnyF(float x) {
  bool tiny = bitsOf(x) < 0x00800000u;
  DecomposedF d = decomposeF(tiny ? float(Int32(bitsOf(x))) : x);
  return {d.f, d.n - (tiny ? 149 : 0)};
}

/// A finite positive normal x as m · 2^exponent with m in [sqrt 1/2, sqrt 2).
struct Decomposed {
  double m, exponent;
};
ANYSL_TIER Decomposed decompose(double x) {
  constexpr UInt64 rootHalf = 0x3fe6a09e667f3bcdull, one = 0x3ff0000000000000ull;
  UInt64 shifted = bitsOf(x) - rootHalf + one;
  double m = fromBits(bitsOf(x) - (shifted & 0xfff0000000000000ull) + one);
  // The biased exponent in the low bits of 2^52 is a conversion that every instruction set has.
  double exponent = fromBits((shifted >> 52) | 0x4330000000000000ull) - (0x1p52 + 1023);
  return {m, exponent};
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_CORE_H
