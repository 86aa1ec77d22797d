//===-- anysl/domain.h - what operators give outside their mathematical domain ----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The one place for such rules. From finite operands no function here gives NaN or infinity, so
// that one bad pixel never spreads; NaN operands still give NaN. Sums, products and quotients may
// overflow, as IEEE arithmetic has it. What is no operand of a function is replaced before it is
// called, not after: then no finite operand raises the flags of an invalid operation or a division
// by zero, not even in a lane that idles. Here are the functions for float and double;
// <anysl/dual.h> has those of numbers with derivatives, whose values are the same.
//
//===------------------------------------------------------------------------------------------===//

// Outside the guard: a real of numbers with derivatives includes this file itself.
#include <anysl/real.h>

#ifndef ANYSL_DOMAIN_H
#define ANYSL_DOMAIN_H

namespace anysl {

/// a / b; 0 where |b| is below the smallest normal number (and so for b = 0).
template <typename Real>
inline Real divide(Real a, Real b) {
  bool isNothing = absOf(b) < IeeeFormat<Real>::smallestNormal;
  return select(isNothing, Real(0), math::divide(a, divisor(b, isNothing)));
}

/// The square root; 0 for x < 0.
template <typename Real>
inline Real squareRoot(Real x) {
  return math::sqrt(select(x < 0, Real(0), x));
}

/// 1 / sqrt(x); 0 for x <= 0.
template <typename Real>
inline Real inverseSquareRoot(Real x) {
  return select(x <= 0, Real(0), math::inversesqrt(divisor(absOf(x), x == 0)));
}

/// e to the x, at most the largest finite number.
template <typename Real>
inline Real exponential(Real x) {
  Real y = math::exp(x);
  return select(y > IeeeFormat<Real>::largestFinite, IeeeFormat<Real>::largestFinite, y);
}

/// The natural logarithm; 0 for x <= 0.
template <typename Real>
inline Real logarithm(Real x) {
  return select(x <= 0, Real(0), math::log(x));
}

/// x limited to [-1, 1], where arc sine and arc cosine live.
template <typename Real>
inline Real limitToUnit(Real x) {
  x = select(x > 1, Real(1), x);
  return select(x < -1, Real(-1), x);
}

/// x to the y. Exact for y = 0 (1, whatever x is), 1 and 2. A negative x has powers for integers y
/// only; others, and 0 to a negative power, give 0. At most the largest finite number in magnitude.
template <typename Real>
inline Real power(Real x, Real y) {
  Real half = y * Real(0.5);
  bool isInteger = floorOf(y) == y;
  bool isOdd = isInteger & (floorOf(half) != half);
  bool isUndefined = ((x < 0) & !isInteger) | ((x == 0) & (y < 0));
  Real magnitude = math::pow(divisor(absOf(x), (x == 0) & (y <= 0)), y);
  magnitude = select(magnitude > IeeeFormat<Real>::largestFinite, IeeeFormat<Real>::largestFinite,
                     magnitude);
  Real result = negateIf(magnitude, isOdd & (x < 0));
  result = select(isUndefined & (y == y), Real(0), result);
  result = select(y == 2, x * x, result);
  result = select(y == 1, x, result);
  return select(y == 0, Real(1), result);
}

/// a - b floor(a/b): in [0, b) for b > 0, in (b, 0] for b < 0, 0 for b = 0. Exact while a/b has no
/// more digits than a real; the result stays in range beyond.
template <typename Real>
inline Real modulo(Real a, Real b) {
  uint32_t sign = b < 0;
  Real x = negateIf(a, sign), period = divisor(absOf(b), b == 0);
  Real quotient = floorOf(math::divide(x, period));
  Real r = fusedMultiplyAdd(-quotient, period, x);
  // A quotient just below an integer rounds to it, and is then one too large.
  r = select(r < 0, r + period, r);
  // What is left are sums that rounded to the period itself, and quotients beyond a real's digits.
  r = select(r < period, r, justBelow(period));
  r = select(r < 0, Real(0), r);
  bool isEndless = absOf(quotient) > IeeeFormat<Real>::largestFinite;
  r = select((b == 0) | isEndless, Real(0), r);
  // NaN operands fail every comparison above.
  Real sum = a + b;
  r = select(isNaN(sum), sum, r);
  return negateIf(r, sign);
}

/// The length of (x, y, z), exact to a few units in the last place wherever the length itself is a
/// normal number: the squares are taken of components brought near 1 by a power of two.
template <typename Real>
inline Real lengthOf(Real x, Real y, Real z) {
  Real largest = absOf(x);
  largest = select(absOf(y) > largest, absOf(y), largest);
  largest = select(absOf(z) > largest, absOf(z), largest);
  Real down, up;
  scaleFor(largest, down, up);
  x = x * down, y = y * down, z = z * down;
  return math::sqrt(x * x + y * y + z * z) * up;
}

} // namespace anysl

#endif // ANYSL_DOMAIN_H
