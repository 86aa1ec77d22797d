//===-- runtimes/math/Turns.h - float arguments of sin, cos and tan, reduced in double --------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_TURNS_H
#define ANYSL_RUNTIMES_MATH_TURNS_H

#include "runtimes/math/Coefficients.h"
#include "runtimes/math/DoubleCore.h"

namespace anysl::tier {

/// An argument as n·unit + r; only the low bits of n count. Where `low` is given, it is what r is
/// short of.
struct Turns {
  double r;
  UInt64 n;
  double low = 0;
};

/// From here on a float's product with 1/pi is computed modulo 2.
inline constexpr float HugeArgument = 0x1p22f;

/// r = x − n·unit for |x| < HugeArgument: high has so few bits that n·high is exact and so is its
/// difference from x (Cody and Waite). n is the integer nearest x/unit, or with `half` the nearest
/// odd multiple of a half.
template <class Unit, Fusion F, bool Half = false>
ANYSL_TIER Turns turnsNear(double x) {
  double t;
  if constexpr (Half)
    t = mulAdd<F>(x, Unit::inverse, -0.5) + RoundShift;
  else
    t = mulAdd<F>(x, Unit::inverse, RoundShift);
  double n = t - RoundShift;
  if constexpr (Half)
    n += 0.5;
  double r = mulAdd<F>(-n, Unit::high, x);
  r = mulAdd<F>(-n, Unit::middle, r);
  if constexpr (Unit::low != 0)
    r = mulAdd<F>(-n, Unit::low, r);
  return {r, bitsOf(t)};
}

/// scale·x/pi modulo 2, plus offset, as an integer and a remainder in [−1/2, 1/2] of it, for a
/// float |x| >= HugeArgument. Payne and Hanek's method in double: InversePi holds 1/pi by blocks of
/// the argument's exponent without the bits whose products are multiples of 2, cut so that the
/// first two products are exact. Infinity and NaN give NaN.
ANYSL_TIER Turns turnsHuge(double x, double scale, double offset) {
  UInt64 block = (((bitsOf(x) >> 52) + 1) >> 4) & 7;
  x *= scale;
  double a = x * InversePi0[block] + offset;
  double b = x * InversePi1[block];
  double c = x * InversePi2[block];
  double ta = a + RoundShift, tb = b + RoundShift;
  a -= ta - RoundShift;
  b -= tb - RoundShift;
  double ts = (a + b) + RoundShift;
  a -= ts - RoundShift;
  Pair s = twoSum(a, b);
  double r = s.high + c;
  return {r, bitsOf(ta) + bitsOf(tb) + bitsOf(ts), (c - (r - s.high)) + s.low};
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_TURNS_H
