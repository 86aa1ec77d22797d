//===-- anysl/domain.h - what operators give outside their mathematical domain ----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The one place for such rules. From finite operands no function here gives NaN or infinity, so
// that one bad pixel never spreads; NaN operands still give NaN. Sums and products may overflow, as
// IEEE arithmetic has it.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_DOMAIN_H
#define ANYSL_DOMAIN_H

#include <anysl/real.h>

namespace anysl {

/// a / b; 0 where |b| is below the smallest normal number (and so for b = 0).
inline anysl_float divide(anysl_float a, anysl_float b) {
  return select(absOf(b) < smallestNormal, anysl_float(0), math::divide(a, b));
}

/// The square root; 0 for x < 0.
inline anysl_float squareRoot(anysl_float x) {
  return math::sqrt(select(x < 0, anysl_float(0), x));
}

/// 1 / sqrt(x); 0 for x <= 0.
inline anysl_float inverseSquareRoot(anysl_float x) {
  return select(x <= 0, anysl_float(0), math::inversesqrt(x));
}

/// e to the x, at most the largest finite number.
inline anysl_float exponential(anysl_float x) {
  anysl_float y = math::exp(x);
  return select(y > largestFinite, largestFinite, y);
}

/// The natural logarithm; 0 for x <= 0.
inline anysl_float logarithm(anysl_float x) { return select(x <= 0, anysl_float(0), math::log(x)); }

/// x limited to [-1, 1], where arc sine and arc cosine live.
inline anysl_float limitToUnit(anysl_float x) {
  x = select(x > 1, anysl_float(1), x);
  return select(x < -1, anysl_float(-1), x);
}

/// x to the y. Exact for y = 0 (1, whatever x is), 1 and 2. A negative x has powers for integers y
/// only; others, and 0 to a negative power, give 0. At most the largest finite number in magnitude.
inline anysl_float power(anysl_float x, anysl_float y) {
  anysl_float half = y * anysl_float(0.5);
  bool isInteger = floorOf(y) == y;
  bool isOdd = isInteger & (floorOf(half) != half);
  anysl_float magnitude = math::pow(absOf(x), y);
  magnitude = select(magnitude > largestFinite, largestFinite, magnitude);
  anysl_float result = negateIf(magnitude, isOdd & (x < 0));
  bool isUndefined = ((x < 0) & !isInteger) | ((x == 0) & (y < 0));
  result = select(isUndefined & (y == y), anysl_float(0), result);
  result = select(y == 2, x * x, result);
  result = select(y == 1, x, result);
  return select(y == 0, anysl_float(1), result);
}

/// a - b floor(a/b): in [0, b) for b > 0, in (b, 0] for b < 0, 0 for b = 0. Exact while a/b has no
/// more digits than a real; the result stays in range beyond.
inline anysl_float modulo(anysl_float a, anysl_float b) {
  uint32_t sign = b < 0;
  anysl_float x = negateIf(a, sign), period = absOf(b);
  anysl_float quotient = floorOf(math::divide(x, period));
  anysl_float r = fusedMultiplyAdd(-quotient, period, x);
  // A quotient just below an integer rounds to it, and is then one too large.
  r = select(r < 0, r + period, r);
  // What is left are sums that rounded to the period itself, and quotients beyond a real's digits.
  r = select(r < period, r, justBelow(period));
  r = select(r < 0, anysl_float(0), r);
  bool isEndless = absOf(quotient) > largestFinite;
  r = select((period == 0) | isEndless, anysl_float(0), r);
  // NaN operands fail every comparison above.
  anysl_float sum = a + b;
  r = select(isNaN(sum), sum, r);
  return negateIf(r, sign);
}

/// The length of (x, y, z), exact to a few units in the last place wherever the length itself is a
/// normal number: the squares are taken of components brought near 1 by a power of two.
inline anysl_float lengthOf(anysl_float x, anysl_float y, anysl_float z) {
  anysl_float largest = absOf(x);
  largest = select(absOf(y) > largest, absOf(y), largest);
  largest = select(absOf(z) > largest, absOf(z), largest);
  anysl_float down, up;
  scaleFor(largest, down, up);
  x = x * down, y = y * down, z = z * down;
  return math::sqrt(x * x + y * y + z * z) * up;
}

} // namespace anysl

#endif // ANYSL_DOMAIN_H
