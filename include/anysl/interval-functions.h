//===-- anysl/interval-functions.h - elementary functions of intervals ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The second half of <anysl/interval.h>.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_INTERVAL_FUNCTIONS_H
#define ANYSL_INTERVAL_FUNCTIONS_H

namespace anysl {

namespace bounds {

/// The bounds of a function of double that grows, or falls, all along x.
template <typename F>
inline Interval growing(const Interval &x, F &&f) {
  return {belowFunction(f(double(x.low))), aboveFunction(f(double(x.high)))};
}
template <typename F>
inline Interval falling(const Interval &x, F &&f) {
  return {belowFunction(f(double(x.high))), aboveFunction(f(double(x.low)))};
}

/// The bounds of a function of two numbers whose extremes over a rectangle are at its corners.
template <typename F>
inline Interval atCorners(const Interval &x, const Interval &y, F &&f) {
  return around(
      f(double(x.low), double(y.low)), f(double(x.low), double(y.high)),
      f(double(x.high), double(y.low)), f(double(x.high), double(y.high)),
      [](double low, double high) { return Interval(belowFunction(low), aboveFunction(high)); });
}

inline constexpr double pi = 3.14159265358979323846;

/// Whether a number `offset + k period` with an integer k may be within x. It is said to be so
/// already where it is only next to x.
inline bool mayMeet(const Interval &x, double offset, double period) {
  double low = (x.low - offset) / period, high = (x.high - offset) / period;
  double slack = 0x1p-48 * (1 + (absOf(low) > absOf(high) ? absOf(low) : absOf(high)));
  return !(slack < 0.25) || floorOf(high + slack) > floorOf(low - slack);
}

/// The bounds of a sine or cosine, whose maxima are at `peak` and every full turn from there.
template <typename F>
inline Interval wave(const Interval &x, double peak, F &&f) {
  if (isNaN(x) || !isFinite(x))
    return isNaN(x) || x.isPoint() ? notANumber() : Interval(-1, 1);
  double a = f(double(x.low)), b = f(double(x.high));
  Interval result(belowFunction(a < b ? a : b), aboveFunction(a > b ? a : b));
  if (!x.isPoint() && mayMeet(x, peak, 2 * pi))
    result.high = 1;
  if (!x.isPoint() && mayMeet(x, peak + pi, 2 * pi))
    result.low = -1;
  return within(result, -1, 1);
}

} // namespace bounds

//===-- Elementary functions ------------------------------------------------------------------===//

namespace math {

#define ANYSL_MONOTONIC(name, direction)                                                           \
  inline Interval name(const Interval &x) {                                                        \
    return bounds::direction(x, [](double a) { return name(a); });                                 \
  }

ANYSL_MONOTONIC(asin, growing)
ANYSL_MONOTONIC(acos, falling)
ANYSL_MONOTONIC(atan, growing)
ANYSL_MONOTONIC(sinh, growing)
ANYSL_MONOTONIC(tanh, growing)
ANYSL_MONOTONIC(exp, growing)
ANYSL_MONOTONIC(exp2, growing)
ANYSL_MONOTONIC(log, growing)
ANYSL_MONOTONIC(log2, growing)
ANYSL_MONOTONIC(log10, growing)
ANYSL_MONOTONIC(cbrt, growing)
ANYSL_MONOTONIC(inversesqrt, falling)
#undef ANYSL_MONOTONIC

inline Interval sin(const Interval &x) {
  return bounds::wave(x, bounds::pi / 2, [](double a) { return sin(a); });
}
inline Interval cos(const Interval &x) {
  return bounds::wave(x, 0, [](double a) { return cos(a); });
}
inline Interval tan(const Interval &x) {
  if (!x.isPoint() && !isNaN(x) && (!isFinite(x) || bounds::mayMeet(x, bounds::pi / 2, bounds::pi)))
    return everything();
  return bounds::growing(x, [](double a) { return tan(a); });
}
inline Interval cosh(const Interval &x) {
  return bounds::growing(absOf(x), [](double a) { return cosh(a); });
}
/// Squares of floats say on which side of a root its double is.
inline Interval sqrt(const Interval &x) {
  double low = sqrt(double(x.low)), high = sqrt(double(x.high));
  return {bounds::below(low, fusedMultiplyAdd(-low, low, double(x.low))),
          bounds::above(high, fusedMultiplyAdd(-high, high, double(x.high)))};
}
inline Interval hypot(const Interval &x, const Interval &y) {
  return bounds::atCorners(absOf(x), absOf(y), [](double a, double b) { return hypot(a, b); });
}
inline Interval divide(const Interval &a, const Interval &b) {
  using namespace bounds;
  if (isNaN(a) || isNaN(b))
    return notANumber();
  if (b.contains(0))
    return everything();
  // The quotients that bound the result, with what they round away.
  bool isDownward = b.high < 0, lowIsNegative = (isDownward ? -a.high : a.low) < 0,
       highIsNegative = (isDownward ? -a.low : a.high) < 0;
  double numeratorLow = isDownward ? -double(a.high) : a.low;
  double numeratorHigh = isDownward ? -double(a.low) : a.high;
  double nearest = isDownward ? -double(b.high) : b.low,
         farthest = isDownward ? -double(b.low) : b.high;
  double denominatorLow = lowIsNegative ? nearest : farthest;
  double denominatorHigh = highIsNegative ? farthest : nearest;
  auto quotient = [](double x, double y) { return x == 0 ? 0 : x / y; };
  double low = quotient(numeratorLow, denominatorLow);
  double high = quotient(numeratorHigh, denominatorHigh);
  return {below(low, lostOfQuotient(numeratorLow, denominatorLow, low)),
          above(high, lostOfQuotient(numeratorHigh, denominatorHigh, high))};
}
inline Interval reciprocal(const Interval &x) { return divide(Interval(1), x); }

/// The cut along the negative x axis lies between pi and -pi.
inline Interval atan2(const Interval &y, const Interval &x) {
  using namespace bounds;
  if (isNaN(y) || isNaN(x))
    return notANumber();
  bool isOnAxis = y.isPoint() && hasSign(y.low) == hasSign(y.high) && y.low == 0;
  bool meetsCut =
      x.low <= 0 && y.contains(0) && !(isOnAxis && !x.contains(0)) && !(isOnAxis && x.isPoint());
  if (meetsCut)
    return {belowFunction(-pi), aboveFunction(pi)};
  return atCorners(y, x, [](double b, double a) { return atan2(b, a); });
}

/// x^y for x >= 0.
inline Interval powOfPositive(const Interval &x, const Interval &y) {
  Interval result = bounds::atCorners(x, y, [](double a, double b) { return pow(a, b); });
  if (x.low <= 0 && !isNaN(result)) { // where the power jumps from 0 to 1, or to infinity
    result = hull(result, Interval(0));
    if (y.low <= 0)
      result = hull(result, Interval(1, y.low < 0 && x.high > 0 ? bounds::infinity : 1.0f));
  }
  return result;
}
inline Interval pow(const Interval &x, const Interval &y) {
  if (isNaN(x) || isNaN(y))
    return notANumber();
  if (x.low >= 0)
    return powOfPositive(x, y);
  // A negative base: the magnitude's power, with either sign unless the exponent decides.
  Interval magnitude = powOfPositive(absOf(x), y);
  bool isInteger = y.isPoint() && floorOf(y.low) == y.low,
       isEven = isInteger && floorOf(y.low / 2) * 2 == y.low;
  if (isEven)
    return magnitude;
  if (isInteger && x.high < 0)
    return -magnitude;
  return hull(-magnitude, magnitude);
}

} // namespace math

//===-- The domain's functions ----------------------------------------------------------------===//
// Where a rule of the domain jumps, there is room for both sides.

/// A quotient by what may be 0 or next to it can be anything; by 0 itself it is 0.
inline Interval divide(const Interval &a, const Interval &b) {
  if (b.isPoint() && b.low == 0)
    return isNaN(a) ? a : Interval(0);
  return math::divide(a, b);
}
inline Interval squareRoot(const Interval &x) { return math::sqrt(within(x, 0, bounds::infinity)); }
inline Interval inverseSquareRoot(const Interval &x) {
  if (x.high <= 0)
    return Interval(0);
  Interval result = math::inversesqrt(within(x, 0, bounds::infinity));
  return x.low <= 0 ? hull(result, Interval(0)) : result;
}
inline Interval exponential(const Interval &x) { return math::exp(x); }
inline Interval logarithm(const Interval &x) {
  if (x.high <= 0)
    return Interval(0);
  Interval result = math::log(within(x, 0, bounds::infinity));
  return x.low <= 0 ? hull(result, Interval(0)) : result;
}
inline Interval limitToUnit(const Interval &x) { return within(x, -1, 1); }

/// Powers with a negative base are 0 for exponents that are no integers.
inline Interval power(const Interval &x, const Interval &y) {
  bool isInteger = y.isPoint() && floorOf(y.low) == y.low;
  if (isInteger && y.low == 0)
    return Interval(1);
  if (isInteger && y.low == 1)
    return x;
  if (isInteger && y.low == 2) {
    Interval magnitude = absOf(x);
    return magnitude * magnitude;
  }
  Interval result = math::pow(x, y);
  bool mayBeUndefined = (x.low < 0 && !isInteger) || (x.low <= 0 && y.low < 0);
  return mayBeUndefined && !isNaN(result) ? hull(result, Interval(0)) : result;
}

inline Interval modulo(const Interval &a, const Interval &b) {
  if (isNaN(a) || isNaN(b))
    return notANumber();
  if (b.isPoint() && b.low == 0)
    return Interval(0);
  Interval range(b.low < 0 ? b.low : 0.0f, b.high > 0 ? b.high : 0.0f);
  if (b.contains(0))
    return range;
  Interval quotient = floorOf(math::divide(a, b));
  // One period is left, or it can be any number within one.
  Interval result = quotient.isPoint() && isFinite(quotient) ? a - b * quotient : range;
  return within(result, range.low, range.high);
}

inline Interval lengthOf(const Interval &x, const Interval &y, const Interval &z) {
  Interval a = absOf(x), b = absOf(y), c = absOf(z), down, up;
  scaleFor(largerOf(largerOf(a, b), c), down, up);
  a = a * down, b = b * down, c = c * down;
  return math::sqrt(a * a + b * b + c * c) * up;
}

} // namespace anysl

#endif // ANYSL_INTERVAL_FUNCTIONS_H
