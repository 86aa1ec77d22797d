//===-- runtimes/math/DoubleCore.h - sums and products of doubles with their errors -----------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A value as the unevaluated sum of two doubles, after Dekker, "A floating-point technique for
// extending the available precision" (1971). Products are split by masking instead of fused
// multiply-adds, for the reason in Core.h; the arguments here are in no danger of overflow.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_DOUBLECORE_H
#define ANYSL_RUNTIMES_MATH_DOUBLECORE_H

#include "runtimes/math/Core.h"

namespace anysl::tier {

struct Pair {
  double high, low;
};

/// a + b exactly.
ANYSL_TIER Pair twoSum(double a, double b) {
  double s = a + b;
  double t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// a + b exactly where |a| >= |b| or a is 0.
ANYSL_TIER Pair fastSum(double a, double b) {
  double s = a + b;
  return {s, b - (s - a)};
}

/// x with the lower 27 bits of the significand cleared.
ANYSL_TIER double upperHalf(double x) { return fromBits(bitsOf(x) & 0xfffffffff8000000ull); }

/// a · b exactly, up to an error of 2^-106 of it (the lower halves may have 27 bits).
ANYSL_TIER Pair product(double a, double b) {
  double ah = upperHalf(a), al = a - ah, bh = upperHalf(b), bl = b - bh;
  double p = a * b;
  return {p, (((ah * bh - p) + ah * bl) + al * bh) + al * bl};
}
ANYSL_TIER Pair product(Pair a, double b) {
  Pair p = product(a.high, b);
  return fastSum(p.high, p.low + a.low * b);
}
ANYSL_TIER Pair product(Pair a, Pair b) {
  Pair p = product(a.high, b.high);
  return fastSum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

ANYSL_TIER Pair sum(Pair a, Pair b) {
  Pair s = twoSum(a.high, b.high);
  return fastSum(s.high, s.low + (a.low + b.low));
}
/// a + b where |a| >= |b|.
ANYSL_TIER Pair sumOrdered(Pair a, Pair b) {
  Pair s = fastSum(a.high, b.high);
  return fastSum(s.high, s.low + (a.low + b.low));
}

/// a / b to about 2^-100.
ANYSL_TIER Pair quotient(Pair a, Pair b) {
  double q = a.high / b.high;
  Pair p = product(q, b.high);
  double rest = (a.high - p.high) - p.low + a.low - q * b.low;
  return fastSum(q, rest / b.high);
}

/// A pair as a double that rounds to the same float: where the pair lies beside its higher half,
/// the last bit is made odd, so that it is never taken for an exact middle (Boldo and Melquiond,
/// "Emulation of a FMA and correctly rounded sums", 2008). Lower halves below `nothing` times the
/// higher count as none: the exact cases.
ANYSL_TIER double roundToOdd(Pair x, double nothing) {
  bool exact = magnitude(x.low) <= magnitude(x.high) * nothing;
  UInt64 bits = bitsOf(x.high);
  UInt64 isNearer0 = (bits ^ bitsOf(x.low)) >> 63;
  UInt64 odd = (bits - isNearer0) | 1;
  return fromBits(exact ? bits : odd);
}

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_DOUBLECORE_H
