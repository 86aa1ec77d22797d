//===-- anysl/interval.h - a real number of which two bounds are known ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Interval is what `float` is where a shader is computed to find out how far float may be off: the
// bounds are floats, rounded outwards, and the number that exact arithmetic gives (which the real
// mp approximates) lies between them, whatever was rounded on the way. As everywhere in interval
// arithmetic, bounds may be farther apart than need be where one number occurs several times in an
// expression (Moore, "Interval Analysis", 1966; IEEE 1788-2015).
//
// The processor's rounding mode stays as it is: bounds are computed in double, with the sign of
// what the double rounds away, and then rounded to the float on their side. Elementary functions
// are the math tier's of double, widened by more than their error.
//
// A comparison that the bounds do not decide is Unknown. Where it selects a value, the result has
// room for both; where it decides a branch, the middles are compared, and what follows holds for
// that branch only. The linker notes such branches (docs/numerics.md).
//
// The header of a real defines `anysl_number` as float and includes this file.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_INTERVAL_H
#define ANYSL_INTERVAL_H

#include <anysl/ieee.h>

// The domain's functions of plain numbers, which are other templates than those below;
// <anysl/real.h>, which it includes, is being read.
#include <anysl/domain.h>

namespace anysl {

//===-- Rounding outwards ---------------------------------------------------------------------===//

namespace bounds {

inline constexpr float infinity = __builtin_inff();

/// The float before or after x; infinity ends there.
inline float nextBelow(float x) {
  if (x == 0)
    return -0x1p-149f;
  if (x == -infinity || x != x)
    return x;
  return fromBits<float>(bitsOf(x) + (x > 0 ? -1u : 1u));
}
inline float nextAbove(float x) { return -nextBelow(-x); }

/// The largest float that is not above x + rest, where `rest` is too small to move x to the next
/// double.
inline float below(double x, double rest = 0) {
  float nearest = float(x);
  bool isAbove = nearest > x || (nearest == x && rest < 0);
  return isAbove ? nextBelow(nearest) : nearest;
}
inline float above(double x, double rest = 0) { return -below(-x, -rest); }

/// What the sum of a and b rounds away (Knuth); 0 where the sum is not finite.
inline double lostOfSum(double a, double b) {
  double sum = a + b, part = sum - a, lost = (a - (sum - part)) + (b - part);
  return isFinite(lost) ? lost : 0;
}

/// Of numbers that bound something, 0 times infinity is 0: infinity stands for any large number.
inline double product(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

/// What the quotient rounds away has the sign of this.
inline double lostOfQuotient(double a, double b, double quotient) {
  double rest = fusedMultiplyAdd(-quotient, b, a);
  return isFinite(rest) ? b < 0 ? -rest : rest : 0;
}

/// How far a tier's double function may be off: it is within 1 ULP.
inline double margin(double y) { return absOf(y) * 0x1p-51 + 0x1p-1070; }
/// Where a double overflows, all floats are below.
inline float belowFunction(double y) {
  if (!isFinite(y))
    return y > 0 ? IeeeFormat<float>::largestFinite : float(y);
  return below(y - margin(y));
}
inline float aboveFunction(double y) { return -belowFunction(-y); }

} // namespace bounds

//===-- The type ------------------------------------------------------------------------------===//

struct Interval {
  float low, high;

  Interval() = default;
  Interval(float x) : low(x), high(x) {}
  Interval(double x) : low(bounds::below(x)), high(bounds::above(x)) {}
  Interval(int x) : Interval(double(x)) {}
  Interval(float low, float high) : low(low), high(high) {}

  bool isPoint() const { return low == high; }
  bool contains(double x) const { return low <= x && x <= high; }
  double middle() const {
    if (low == -bounds::infinity || high == bounds::infinity)
      return low == high                ? low
             : low != -bounds::infinity ? low
             : high != bounds::infinity ? high
                                        : 0;
    return 0.5 * (double(low) + high);
  }
  explicit operator double() const { return middle(); }
  explicit operator float() const { return float(middle()); }
  /// How far the number can be from the middle.
  double halfWidth() const { return isPoint() ? 0 : 0.5 * (double(high) - low); }
};

/// What a comparison of intervals gives.
struct Truth {
  bool canBeTrue, canBeFalse;
  bool guess; ///< for where a decision is needed

  Truth(bool known) : canBeTrue(known), canBeFalse(!known), guess(known) {}
  Truth(bool canBeTrue, bool canBeFalse, bool guess)
      : canBeTrue(canBeTrue), canBeFalse(canBeFalse), guess(guess) {}

  bool isKnown() const { return canBeTrue != canBeFalse; }
  operator bool() const { return guess; }

  friend Truth operator!(const Truth &a) { return {a.canBeFalse, a.canBeTrue, !a.guess}; }
  friend Truth operator&(const Truth &a, const Truth &b) {
    return {a.canBeTrue && b.canBeTrue, a.canBeFalse || b.canBeFalse, a.guess && b.guess};
  }
  friend Truth operator|(const Truth &a, const Truth &b) { return !(!a & !b); }
};

template <>
inline constexpr bool isScalarOnly<Interval> = true;
template <>
inline constexpr bool hasBounds<Interval> = true;

template <>
struct IeeeFormat<Interval> : IeeeFormat<float> {};

//===-- Comparison ----------------------------------------------------------------------------===//

inline bool isNaN(const Interval &x) { return x.low != x.low || x.high != x.high; }
inline Interval notANumber() { return __builtin_nanf(""); }

inline Truth operator<(const Interval &a, const Interval &b) {
  if (isNaN(a) || isNaN(b))
    return false;
  return {a.low < b.high, !(a.high < b.low), a.middle() < b.middle()};
}
inline Truth operator<=(const Interval &a, const Interval &b) {
  if (isNaN(a) || isNaN(b))
    return false;
  return {a.low <= b.high, !(a.high <= b.low), a.middle() <= b.middle()};
}
inline Truth operator>(const Interval &a, const Interval &b) { return b < a; }
inline Truth operator>=(const Interval &a, const Interval &b) { return b <= a; }
inline Truth operator==(const Interval &a, const Interval &b) {
  if (isNaN(a) || isNaN(b))
    return false;
  return {a.low <= b.high && b.low <= a.high, !(a.isPoint() && b.isPoint() && a.low == b.low),
          a.middle() == b.middle()};
}
inline Truth operator!=(const Interval &a, const Interval &b) { return !(a == b); }

/// The least interval that has room for both.
inline Interval hull(const Interval &a, const Interval &b) {
  if (isNaN(a) || isNaN(b))
    return notANumber();
  return {a.low < b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
}
/// a without what lies outside of [low, high], where the number is known to be.
inline Interval within(const Interval &a, float low, float high) {
  if (isNaN(a))
    return a;
  return {a.low > low ? a.low < high ? a.low : high : low,
          a.high < high ? a.high > low ? a.high : low : high};
}
inline Interval everything() { return {-bounds::infinity, bounds::infinity}; }

inline Interval select(const Truth &condition, const Interval &a, const Interval &b) {
  if (!condition.isKnown())
    return hull(a, b);
  return condition.canBeTrue ? a : b;
}
inline Interval select(bool condition, const Interval &a, const Interval &b) {
  return condition ? a : b;
}

//===-- Arithmetic ----------------------------------------------------------------------------===//

inline Interval operator-(const Interval &x) { return {-x.high, -x.low}; }
inline Interval operator+(const Interval &a, const Interval &b) {
  using namespace bounds;
  return {below(double(a.low) + b.low, lostOfSum(a.low, b.low)),
          above(double(a.high) + b.high, lostOfSum(a.high, b.high))};
}
inline Interval operator-(const Interval &a, const Interval &b) { return a + -b; }

namespace bounds {

/// The least interval around four numbers; NaN if one is.
inline Interval around(double a, double b, double c, double d, Interval (*round)(double, double)) {
  if (!(a + b + c + d == a + b + c + d) && (isNaN(a) || isNaN(b) || isNaN(c) || isNaN(d)))
    return notANumber();
  auto less = [](double x, double y) { return x < y ? x : y; };
  auto more = [](double x, double y) { return x > y ? x : y; };
  return round(less(less(a, b), less(c, d)), more(more(a, b), more(c, d)));
}

} // namespace bounds

/// Products of floats are exact in double.
inline Interval operator*(const Interval &a, const Interval &b) {
  using namespace bounds;
  if (isNaN(a) || isNaN(b))
    return notANumber();
  return around(product(a.low, b.low), product(a.low, b.high), product(a.high, b.low),
                product(a.high, b.high),
                [](double low, double high) { return Interval(below(low), above(high)); });
}

//===-- What a real promises ------------------------------------------------------------------===//

inline float numberOf(const Interval &x) { return float(x.middle()); }
inline bool isFinite(const Interval &x) { return isFinite(x.low) && isFinite(x.high); }
inline bool hasSign(const Interval &x) { return hasSign(float(x.middle())); }
/// There are no flags to keep.
inline Interval divisor(const Interval &x, const Truth &) { return x; }
inline Interval negateIf(const Interval &x, uint32_t sign) { return sign & 1 ? -x : x; }
inline Interval absOf(const Interval &x) {
  if (x.low >= 0)
    return x;
  if (x.high <= 0)
    return -x;
  return isNaN(x) ? x : Interval(0, x.high > -x.low ? x.high : -x.low);
}
inline Interval copySign(const Interval &magnitude, const Interval &sign) {
  Interval x = absOf(magnitude);
  return select(sign < Interval(0), -x, x);
}
inline Interval floorOf(const Interval &x) { return {floorOf(x.low), floorOf(x.high)}; }
inline Interval lowestFloor(const Interval &x) { return floorOf(x.low); }
inline Interval ceilOf(const Interval &x) { return {ceilOf(x.low), ceilOf(x.high)}; }
inline Interval smallerOf(const Interval &a, const Interval &b) {
  if (isNaN(a) || isNaN(b))
    return select(b < a, b, a);
  return {a.low < b.low ? a.low : b.low, a.high < b.high ? a.high : b.high};
}
inline Interval largerOf(const Interval &a, const Interval &b) {
  if (isNaN(a) || isNaN(b))
    return select(b > a, b, a);
  return {a.low > b.low ? a.low : b.low, a.high > b.high ? a.high : b.high};
}
inline Interval justBelow(const Interval &x) { return {bounds::nextBelow(x.low), x.high}; }
inline Interval fusedMultiplyAdd(const Interval &a, const Interval &b, const Interval &c) {
  return a * b + c;
}
/// Any power of two does.
inline void scaleFor(const Interval &m, Interval &down, Interval &up) {
  float d, u;
  scaleFor(absOf(m).high, d, u);
  down = d, up = u;
}
/// Of the middle; noise asks for one cell after the other.
inline uint32_t latticeCell(const Interval &x) { return latticeCell(floorOf(x.middle())); }
inline int32_t toInteger(const Interval &x) { return toInteger(x.middle()); }

} // namespace anysl

#include <anysl/interval-functions.h>

#endif // ANYSL_INTERVAL_H
