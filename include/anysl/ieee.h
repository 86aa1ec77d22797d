//===-- anysl/ieee.h - a real number that is float or double ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What a real's header promises (runtimes/real/README.md), for float and double. The header defines
// `anysl_number`, which is one of the two, and includes this file. Everything is free of branches,
// so that it widens into straight vector code; a selection is written `a < b ? x : y` such that NaN
// takes the arm named.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_IEEE_H
#define ANYSL_IEEE_H

#include <anysl/math.h>
#include <stdint.h>

namespace anysl {

template <typename Real>
struct IeeeFormat;

template <>
struct IeeeFormat<float> {
  using Bits = uint32_t;
  using Integer = int32_t;
  static constexpr int fractionBits = 23;
  static constexpr int bias = 127;
  static constexpr float smallestNormal = 0x1p-126f;
  static constexpr float largestFinite = 0x1.fffffep127f;
  static constexpr float largestInteger = 0x1.fffffep30f; // that converts to Integer
};

template <>
struct IeeeFormat<double> {
  using Bits = uint64_t;
  using Integer = int64_t;
  static constexpr int fractionBits = 52;
  static constexpr int bias = 1023;
  static constexpr double smallestNormal = 0x1p-1022;
  static constexpr double largestFinite = 0x1.fffffffffffffp1023;
  static constexpr double largestInteger = 0x1.fffffffffffffp62;
};

//===-- Bits ----------------------------------------------------------------------------------===//

template <typename Real>
using BitsOf = typename IeeeFormat<Real>::Bits;

template <typename Real>
inline BitsOf<Real> bitsOf(Real x) {
  return __builtin_bit_cast(BitsOf<Real>, x);
}
template <typename Real>
inline Real fromBits(BitsOf<Real> b) {
  return __builtin_bit_cast(Real, b);
}

/// A half (IEEE 754 binary16) as a float, exactly; written with operations that every processor
/// widens. The exponent moves from a half's place to a float's by a product, which makes denormal
/// halves normal floats, too.
inline float fromHalf(uint16_t half) {
  uint32_t magnitude = uint32_t(half & 0x7fff) << 13;
  bool isFinite = magnitude < 0x0f800000;
  uint32_t bits = bitsOf(fromBits<float>(magnitude) * 0x1p112f);
  bits = isFinite ? bits : magnitude | 0x7f800000;
  return fromBits<float>(bits | uint32_t(half & 0x8000) << 16);
}

/// The number before x > 0.
template <typename Real>
inline Real justBelow(Real x) {
  return fromBits<Real>(bitsOf(x) - 1);
}

/// x, a number or 0; where `isNothing`, which says that x is 0 or denormal, a number of its sign in
/// [1, 2): what to divide by in place of x, so that no flag is raised. Not `isNothing ? 1 : x`,
/// which the optimizer takes out of a quotient again, as it does with every constant. The result of
/// the division is for the caller to replace; in tiers that do not care for flags x stays as it is.
template <typename Real>
inline Real divisor(Real x, bool isNothing) {
  return fromBits<Real>(bitsOf(x) | ((isNothing & math::keepsFlags()) ? bitsOf(Real(1)) : 0));
}

/// -x where bit 0 of `sign` is set, else x. The other bits do not count.
template <typename Real>
inline Real negateIf(Real x, uint32_t sign) {
  return fromBits<Real>(bitsOf(x) ^ (BitsOf<Real>(sign) << (sizeof(Real) * 8 - 1)));
}

/// Sets `down` to a power of two that brings m >= 0 near 1, and `up` to its inverse. Both are
/// normal numbers; at the very ends of the range m * down stays a few binades away from 1.
template <typename Real>
inline void scaleFor(Real m, Real &down, Real &up) {
  using Format = IeeeFormat<Real>;
  using Bits = typename Format::Bits;
  constexpr Bits one = Bits(1) << Format::fractionBits;
  constexpr Bits last = (2 * Format::bias - 1) * one;
  Bits exponent = bitsOf(m) & (~Bits(0) << Format::fractionBits);
  exponent = __builtin_elementwise_max(exponent, one);
  exponent = __builtin_elementwise_min(exponent, last);
  down = fromBits<Real>(last + one - exponent);
  up = fromBits<Real>(exponent);
}

//===-- Selection and rounding ----------------------------------------------------------------===//

template <typename Real>
inline Real select(bool condition, Real a, Real b) {
  return condition ? a : b;
}
template <typename Real>
inline bool isNaN(Real x) {
  return x != x;
}
/// Whether x is a number and not infinite. Bits are compared, because arithmetic of derivatives may
/// suppose that there is no NaN.
template <typename Real>
inline bool isFinite(Real x) {
  constexpr BitsOf<Real> exponent = BitsOf<Real>(2 * IeeeFormat<Real>::bias + 1)
                                    << IeeeFormat<Real>::fractionBits;
  return (bitsOf(x) & exponent) != exponent;
}
/// Whether x is below 0, or -0.
template <typename Real>
inline bool hasSign(Real x) {
  return bitsOf(x) >> (sizeof(Real) * 8 - 1);
}

inline float absOf(float x) { return __builtin_fabsf(x); }
inline double absOf(double x) { return __builtin_fabs(x); }
inline float floorOf(float x) { return __builtin_floorf(x); }
inline double floorOf(double x) { return __builtin_floor(x); }
inline float ceilOf(float x) { return __builtin_ceilf(x); }
inline double ceilOf(double x) { return __builtin_ceil(x); }
inline float copySign(float magnitude, float sign) { return __builtin_copysignf(magnitude, sign); }
inline double copySign(double magnitude, double sign) {
  return __builtin_copysign(magnitude, sign);
}

/// a b + c with one rounding.
inline float fusedMultiplyAdd(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
inline double fusedMultiplyAdd(double a, double b, double c) { return __builtin_fma(a, b, c); }

//===-- Integers ------------------------------------------------------------------------------===//

/// The integer x (floored already) modulo 2^32. Beyond the integers of the format, and for NaN, one
/// fixed cell: conversion of such numbers is undefined, and differs between scalar and vector
/// instructions. (Limits written as choices would be converted arm by arm, and so without limit.)
template <typename Real>
inline uint32_t latticeCell(Real x) {
  constexpr Real high = IeeeFormat<Real>::largestInteger, low = -high;
  x = __builtin_elementwise_min(__builtin_elementwise_max(x, low), high);
  return uint32_t(typename IeeeFormat<Real>::Integer(x));
}

/// The integer x (floored already), limited to what fits; NaN gives 0.
template <typename Real>
inline int32_t toInteger(Real x) {
  constexpr Real high = IeeeFormat<float>::largestInteger, low = -high;
  x = isNaN(x) ? Real(0) : x;
  x = __builtin_elementwise_min(__builtin_elementwise_max(x, low), high);
  return int32_t(x);
}

/// A number in [0, 1) from the high 24 bits, the same for float and double.
inline anysl_number unitFromBits(uint32_t bits) {
  return anysl_number(int32_t(bits >> 8)) * anysl_number(0x1p-24);
}

/// A number in [-1, 1) from 32 bits, the same for float and double.
inline anysl_number signedUnitFromBits(uint32_t bits) {
  return anysl_number(int32_t(bits) >> 8) * anysl_number(0x1p-23);
}

/// The number that a host gets for x.
inline float numberOf(float x) { return x; }
inline double numberOf(double x) { return x; }

/// Whether code with such numbers shades one point at a time only.
template <typename Real>
inline constexpr bool isScalarOnly = false;

/// Whether two bounds are known of a number.
template <typename Real>
inline constexpr bool hasBounds = false;

/// The integer part of the least number that x may be.
template <typename Real>
inline Real lowestFloor(const Real &x) {
  return floorOf(x);
}

/// The smaller and the larger of two numbers; of equal ones, and if one is NaN, the first.
template <typename Real>
inline Real smallerOf(const Real &a, const Real &b) {
  return select(b < a, b, a);
}
template <typename Real>
inline Real largerOf(const Real &a, const Real &b) {
  return select(b > a, b, a);
}

//===-- Derivatives ---------------------------------------------------------------------------===//
// A plain number has none. <anysl/dual.h> has the same names for numbers that do.

template <typename Real>
inline Real valueOf(Real x) {
  return x;
}
template <typename Real>
inline Real derivativeU(Real) {
  return 0;
}
template <typename Real>
inline Real derivativeV(Real) {
  return 0;
}
/// How many times a real can be differentiated.
template <typename Real>
inline constexpr int derivativeOrder = 0;
template <typename Real>
inline constexpr bool hasDerivatives = (derivativeOrder<Real> > 0);

/// What a real is made of: itself, or the number that it adds derivatives to.
template <typename Real>
struct PlainNumber {
  using Type = Real;
};
template <typename Real>
using PlainOf = typename PlainNumber<Real>::Type;

/// A function of u and v at a point: its value and its derivatives of first and second order.
template <typename Plain>
struct Expansion {
  Plain value, u, v, uu, uv, vv;
};

/// The number with those derivatives, as far as a real carries any.
template <typename Real>
inline Real expand(const Expansion<PlainOf<Real>> &x) {
  if constexpr (derivativeOrder<Real> == 2)
    return {{x.value, x.u, x.v}, {x.u, x.uu, x.uv}, {x.v, x.uv, x.vv}};
  else if constexpr (hasDerivatives<Real>)
    return {x.value, x.u, x.v};
  else
    return x.value;
}
/// The same, whose derivatives change with neither u nor v.
template <typename Real>
inline Real withDerivatives(PlainOf<Real> value, PlainOf<Real> u, PlainOf<Real> v) {
  return expand<Real>({value, u, v, 0, 0, 0});
}
/// `value`, with the derivatives of `x`: for a value that was computed by better means than x.
template <typename Real>
inline Real withValue(Real value, Real) {
  return value;
}

} // namespace anysl

#endif // ANYSL_IEEE_H
