//===-- anysl/dual.h - a real number with its derivatives by u and v --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Dual<float> is what `float` is in a shader that asks for derivatives: the number itself and how
// it changes with the surface's two parameters. Each function computes its value by the function of
// the plain number, so values are bit for bit those of a shader without derivatives, and its
// derivatives by the chain rule. Comparisons look at values. docs/derivatives.md has the rules at
// kinks (the derivative from one side) and at singular points (0).
//
// Dual<Dual<float>> is a number whose derivatives have derivatives in turn: the rules below apply
// to any real, and so to numbers that carry derivatives themselves.
//
// The header of a real defines `anysl_number`, the plain number, and includes this file.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_DUAL_H
#define ANYSL_DUAL_H

#include <anysl/ieee.h>

// The domain's functions of plain numbers; <anysl/real.h>, which it includes, is being read.
#include <anysl/domain.h>

/// hasDerivatives<anysl_float>, for the preprocessor.
#define ANYSL_REAL_HAS_DERIVATIVES 1

namespace anysl {

//===-- Arithmetic of derivatives -------------------------------------------------------------===//
// Most derivatives in a shader are 0: those of constants, of parameters, of everything uniform. In
// IEEE arithmetic 0 x is not 0 for every x, so nothing of such a product would go away. The linker
// takes arithmetic that is free to reassociate, which nothing else in a runtime is, for arithmetic
// of derivatives, and lets 0 x be 0 and 0 + x be x in it.

#ifdef __clang__
#define ANYSL_OF_DERIVATIVES _Pragma("clang fp reassociate(on)")
#else
#define ANYSL_OF_DERIVATIVES
#endif

template <typename Real>
struct Dual;

namespace slopes {

template <typename Real>
Dual<Real> sum(const Dual<Real> &a, const Dual<Real> &b);
template <typename Real>
Dual<Real> difference(const Dual<Real> &a, const Dual<Real> &b);
template <typename Real>
Dual<Real> product(const Dual<Real> &a, const Dual<Real> &b);

template <typename Real>
inline Real sum(Real a, Real b) {
  ANYSL_OF_DERIVATIVES
  return a + b;
}
template <typename Real>
inline Real difference(Real a, Real b) {
  ANYSL_OF_DERIVATIVES
  return a - b;
}
template <typename Real>
inline Real product(Real a, Real b) {
  ANYSL_OF_DERIVATIVES
  return a * b;
}
/// a b + c d
template <typename Real>
inline Real combination(Real a, Real b, Real c, Real d) {
  return sum(product(a, b), product(c, d));
}

} // namespace slopes

//===-- The type ------------------------------------------------------------------------------===//

template <typename Real>
inline constexpr int derivativeOrder<Dual<Real>> = derivativeOrder<Real> + 1;

template <typename Real>
struct PlainNumber<Dual<Real>> : PlainNumber<Real> {};

/// A number and its derivatives. It has a copy constructor of its own for the same reason as Vec.
template <typename Real>
struct Dual {
  Real value, u, v;

  Dual() = default;
  /// A constant.
  template <typename Plain>
    requires(__is_arithmetic(Plain) || __is_same(Plain, Real))
  Dual(Plain x) : value(Real(x)), u(0), v(0) {}
  Dual(Real value, Real u, Real v) : value(value), u(u), v(v) {}
  Dual(const Dual &o) : value(o.value), u(o.u), v(o.v) {}
  Dual &operator=(const Dual &o) {
    value = o.value, u = o.u, v = o.v;
    return *this;
  }

  /// The value alone.
  explicit operator float() const { return float(value); }
  explicit operator double() const { return double(value); }

  friend Dual operator-(const Dual &a) { return {-a.value, -a.u, -a.v}; }
  friend Dual operator+(const Dual &a, const Dual &b) {
    return {a.value + b.value, slopes::sum(a.u, b.u), slopes::sum(a.v, b.v)};
  }
  friend Dual operator-(const Dual &a, const Dual &b) {
    return {a.value - b.value, slopes::difference(a.u, b.u), slopes::difference(a.v, b.v)};
  }
  friend Dual operator*(const Dual &a, const Dual &b) {
    return {a.value * b.value, slopes::combination(a.value, b.u, b.value, a.u),
            slopes::combination(a.value, b.v, b.value, a.v)};
  }

  friend bool operator==(const Dual &a, const Dual &b) { return a.value == b.value; }
  friend bool operator!=(const Dual &a, const Dual &b) { return a.value != b.value; }
  friend bool operator<(const Dual &a, const Dual &b) { return a.value < b.value; }
  friend bool operator<=(const Dual &a, const Dual &b) { return a.value <= b.value; }
  friend bool operator>(const Dual &a, const Dual &b) { return a.value > b.value; }
  friend bool operator>=(const Dual &a, const Dual &b) { return a.value >= b.value; }
};

template <typename Real>
inline PlainOf<Real> valueOf(const Dual<Real> &x) {
  return valueOf(x.value);
}
template <typename Real>
inline PlainOf<Real> derivativeU(const Dual<Real> &x) {
  return valueOf(x.u);
}
template <typename Real>
inline PlainOf<Real> derivativeV(const Dual<Real> &x) {
  return valueOf(x.v);
}
template <typename Real>
inline auto numberOf(const Dual<Real> &x) {
  return numberOf(x.value);
}
template <typename Real>
inline constexpr bool isScalarOnly<Dual<Real>> = isScalarOnly<Real>;
/// `value`, with the derivatives of `x`.
template <typename Real>
inline Dual<Real> withValue(PlainOf<Real> value, const Dual<Real> &x) {
  return {withValue(value, x.value), x.u, x.v};
}

namespace slopes {

template <typename Real>
inline Dual<Real> sum(const Dual<Real> &a, const Dual<Real> &b) {
  return {sum(a.value, b.value), sum(a.u, b.u), sum(a.v, b.v)};
}
template <typename Real>
inline Dual<Real> difference(const Dual<Real> &a, const Dual<Real> &b) {
  return {difference(a.value, b.value), difference(a.u, b.u), difference(a.v, b.v)};
}
template <typename Real>
inline Dual<Real> product(const Dual<Real> &a, const Dual<Real> &b) {
  return {product(a.value, b.value), combination(a.value, b.u, b.value, a.u),
          combination(a.value, b.v, b.value, a.v)};
}

} // namespace slopes

/// f(x), given its value and f'(x).
template <typename Real>
inline Dual<Real> chain(Real value, Real slope, const Dual<Real> &x) {
  return {value, slopes::product(slope, x.u), slopes::product(slope, x.v)};
}
/// f(x, y), given its value and its two partial derivatives.
template <typename Real>
inline Dual<Real> chain(Real value, Real slopeX, const Dual<Real> &x, Real slopeY,
                        const Dual<Real> &y) {
  return {value, slopes::combination(slopeX, x.u, slopeY, y.u),
          slopes::combination(slopeX, x.v, slopeY, y.v)};
}

/// f(x, y, z), likewise.
template <typename Real>
inline Dual<Real> chain(Real value, Real slopeX, const Dual<Real> &x, Real slopeY,
                        const Dual<Real> &y, Real slopeZ, const Dual<Real> &z) {
  return {value,
          slopes::sum(slopes::combination(slopeX, x.u, slopeY, y.u), slopes::product(slopeZ, z.u)),
          slopes::sum(slopes::combination(slopeX, x.v, slopeY, y.v), slopes::product(slopeZ, z.v))};
}

//===-- What a real promises ------------------------------------------------------------------===//

template <typename Real>
inline Dual<Real> select(bool condition, const Dual<Real> &a, const Dual<Real> &b) {
  return {select(condition, a.value, b.value), select(condition, a.u, b.u),
          select(condition, a.v, b.v)};
}
template <typename Real>
inline bool isNaN(const Dual<Real> &x) {
  return isNaN(x.value);
}
template <typename Real>
inline Dual<Real> negateIf(const Dual<Real> &x, uint32_t sign) {
  return {negateIf(x.value, sign), negateIf(x.u, sign), negateIf(x.v, sign)};
}
/// At 0 from the right.
template <typename Real>
inline Dual<Real> absOf(const Dual<Real> &x) {
  bool isNegative = x.value < 0;
  return {absOf(x.value), select(isNegative, -x.u, x.u), select(isNegative, -x.v, x.v)};
}
template <typename Real>
inline Dual<Real> floorOf(const Dual<Real> &x) {
  return floorOf(x.value);
}
template <typename Real>
inline Dual<Real> ceilOf(const Dual<Real> &x) {
  return ceilOf(x.value);
}
template <typename Real>
inline Dual<Real> copySign(const Dual<Real> &magnitude, const Dual<Real> &sign) {
  Dual<Real> x = absOf(magnitude);
  bool isNegative = hasSign(valueOf(sign.value));
  return {copySign(magnitude.value, sign.value), select(isNegative, -x.u, x.u),
          select(isNegative, -x.v, x.v)};
}
template <typename Real>
inline Dual<Real> justBelow(const Dual<Real> &x) {
  return {justBelow(x.value), x.u, x.v};
}
template <typename Real>
inline Dual<Real> divisor(const Dual<Real> &x, bool isNothing) {
  return {divisor(x.value, isNothing), x.u, x.v};
}
template <typename Real>
inline Dual<Real> fusedMultiplyAdd(const Dual<Real> &a, const Dual<Real> &b, const Dual<Real> &c) {
  Dual<Real> product = a * b, sum = product + c;
  return {fusedMultiplyAdd(a.value, b.value, c.value), sum.u, sum.v};
}
/// The powers of two are constants.
template <typename Real>
inline void scaleFor(const Dual<Real> &m, Dual<Real> &down, Dual<Real> &up) {
  Real d, u;
  scaleFor(m.value, d, u);
  down = d, up = u;
}
template <typename Real>
inline uint32_t latticeCell(const Dual<Real> &x) {
  return latticeCell(x.value);
}
template <typename Real>
inline int32_t toInteger(const Dual<Real> &x) {
  return toInteger(x.value);
}

//===-- Elementary functions ------------------------------------------------------------------===//

// The domain's functions, further below, of which the rules make use.
template <typename Real>
Dual<Real> divide(const Dual<Real> &a, const Dual<Real> &b);
template <typename Real>
Dual<Real> inverseSquareRoot(const Dual<Real> &x);
template <typename Real>
Dual<Real> logarithm(const Dual<Real> &x);

namespace math {

// A rule may need functions whose rules come later.
#define MATH_UNARY(name, ...)                                                                      \
  template <typename Real>                                                                         \
  Dual<Real> name(const Dual<Real> &x);
#define MATH_BINARY(name, ...)                                                                     \
  template <typename Real>                                                                         \
  Dual<Real> name(const Dual<Real> &x, const Dual<Real> &y);
#include <anysl/MathFunctions.def>

// Where a function has a vertical tangent, the quotients below are 0 by the domain's rules.

template <typename Real>
inline Dual<Real> sin(const Dual<Real> &x) {
  return chain(sin(x.value), cos(x.value), x);
}
template <typename Real>
inline Dual<Real> cos(const Dual<Real> &x) {
  return chain(cos(x.value), -sin(x.value), x);
}
template <typename Real>
inline Dual<Real> tan(const Dual<Real> &x) {
  Real value = tan(x.value);
  return chain(value, 1 + value * value, x);
}
template <typename Real>
inline Dual<Real> asin(const Dual<Real> &x) {
  return chain(asin(x.value), inverseSquareRoot((1 - x.value) * (1 + x.value)), x);
}
template <typename Real>
inline Dual<Real> acos(const Dual<Real> &x) {
  return chain(acos(x.value), -inverseSquareRoot((1 - x.value) * (1 + x.value)), x);
}
template <typename Real>
inline Dual<Real> atan(const Dual<Real> &x) {
  return chain(atan(x.value), reciprocal(1 + x.value * x.value), x);
}
/// y' x / (x^2 + y^2) - x' y / (x^2 + y^2), after both were brought near 1; 0 at the origin. Beside
/// it slopes are limited to 2^120: beyond what a real holds they would be NaN where y' or x' is 0.
template <typename Real>
inline Dual<Real> atan2(const Dual<Real> &y, const Dual<Real> &x) {
  Real a0 = absOf(x.value), b0 = absOf(y.value), down, up;
  scaleFor(select(a0 > b0, a0, b0), down, up);
  Real a = x.value * down, b = y.value * down, steepest(0x1p120);
  Real scale = anysl::divide(down, a * a + b * b);
  scale = select(scale > steepest, steepest, scale);
  return chain(atan2(y.value, x.value), a * scale, y, -b * scale, x);
}
template <typename Real>
inline Dual<Real> sinh(const Dual<Real> &x) {
  return chain(sinh(x.value), cosh(x.value), x);
}
template <typename Real>
inline Dual<Real> cosh(const Dual<Real> &x) {
  return chain(cosh(x.value), sinh(x.value), x);
}
template <typename Real>
inline Dual<Real> tanh(const Dual<Real> &x) {
  Real value = tanh(x.value);
  return chain(value, (1 - value) * (1 + value), x);
}
template <typename Real>
inline Dual<Real> exp(const Dual<Real> &x) {
  Real value = exp(x.value);
  return chain(value, value, x);
}
template <typename Real>
inline Dual<Real> exp2(const Dual<Real> &x) {
  Real value = exp2(x.value);
  return chain(value, value * Real(0.69314718055994531), x);
}
template <typename Real>
inline Dual<Real> log(const Dual<Real> &x) {
  return chain(log(x.value), anysl::divide(Real(1), x.value), x);
}
template <typename Real>
inline Dual<Real> log2(const Dual<Real> &x) {
  return chain(log2(x.value), anysl::divide(Real(1.4426950408889634), x.value), x);
}
template <typename Real>
inline Dual<Real> log10(const Dual<Real> &x) {
  return chain(log10(x.value), anysl::divide(Real(0.43429448190325183), x.value), x);
}
template <typename Real>
inline Dual<Real> sqrt(const Dual<Real> &x) {
  Real value = sqrt(x.value);
  return chain(value, anysl::divide(Real(0.5), value), x);
}
template <typename Real>
inline Dual<Real> inversesqrt(const Dual<Real> &x) {
  Real value = inversesqrt(x.value);
  return chain(value, Real(-0.5) * value * anysl::divide(Real(1), x.value), x);
}
template <typename Real>
inline Dual<Real> cbrt(const Dual<Real> &x) {
  Real value = cbrt(x.value);
  return chain(value, anysl::divide(value, 3 * x.value), x);
}
template <typename Real>
inline Dual<Real> reciprocal(const Dual<Real> &x) {
  Real value = reciprocal(x.value);
  return chain(value, -value * value, x);
}
template <typename Real>
inline Dual<Real> divide(const Dual<Real> &a, const Dual<Real> &b) {
  Real value = math::divide(a.value, b.value), inverse = reciprocal(b.value);
  return chain(value, inverse, a, -value * inverse, b);
}
template <typename Real>
inline Dual<Real> hypot(const Dual<Real> &x, const Dual<Real> &y) {
  Real value = hypot(x.value, y.value);
  return chain(value, anysl::divide(x.value, value), x, anysl::divide(y.value, value), y);
}
/// x^y (y/x x' + log(x) y'). Where x <= 0 only x counts, and at 0 only powers of 1 have a slope.
template <typename Real>
inline Dual<Real> powerRule(Real value, const Dual<Real> &x, const Dual<Real> &y) {
  Real slope = y.value * anysl::divide(value, x.value);
  return chain(value, select(y.value == 1, Real(1), slope), x, value * logarithm(x.value), y);
}
template <typename Real>
inline Dual<Real> pow(const Dual<Real> &x, const Dual<Real> &y) {
  return powerRule(pow(x.value, y.value), x, y);
}

} // namespace math

//===-- The domain's functions ----------------------------------------------------------------===//

template <typename Real>
inline Dual<Real> divide(const Dual<Real> &a, const Dual<Real> &b) {
  Real value = divide(a.value, b.value), inverse = divide(Real(1), b.value);
  return chain(value, inverse, a, -value * inverse, b);
}
template <typename Real>
inline Dual<Real> squareRoot(const Dual<Real> &x) {
  Real value = squareRoot(x.value);
  return chain(value, divide(Real(0.5), value), x);
}
template <typename Real>
inline Dual<Real> inverseSquareRoot(const Dual<Real> &x) {
  Real value = inverseSquareRoot(x.value);
  return chain(value, Real(-0.5) * value * divide(Real(1), x.value), x);
}
/// Beyond the largest number it is constant.
template <typename Real>
inline Dual<Real> exponential(const Dual<Real> &x) {
  Real value = exponential(x.value);
  bool isFinite = valueOf(value) < IeeeFormat<PlainOf<Real>>::largestFinite;
  return chain(value, select(isFinite, value, Real(0)), x);
}
template <typename Real>
inline Dual<Real> logarithm(const Dual<Real> &x) {
  Real slope = select(x.value > 0, divide(Real(1), x.value), Real(0));
  return chain(logarithm(x.value), slope, x);
}
/// Within the interval, its ends included, x itself.
template <typename Real>
inline Dual<Real> limitToUnit(const Dual<Real> &x) {
  Dual<Real> y = select(x > 1, Dual<Real>(1), x);
  return select(y < -1, Dual<Real>(-1), y);
}
/// Beyond the largest number it is constant.
template <typename Real>
inline Dual<Real> power(const Dual<Real> &x, const Dual<Real> &y) {
  Real value = power(x.value, y.value);
  bool isFinite = absOf(valueOf(value)) < IeeeFormat<PlainOf<Real>>::largestFinite;
  Dual<Real> result = math::powerRule(select(isFinite, value, Real(0)), x, y);
  result.value = value;
  return result;
}
/// a' - b' floor(a/b), at a jump from the right; 0 for b = 0.
template <typename Real>
inline Dual<Real> modulo(const Dual<Real> &a, const Dual<Real> &b) {
  Real value = modulo(a.value, b.value);
  Real quotient = floorOf(divide(a.value - value, b.value) + Real(0.5));
  return chain(value, select(b.value == 0, Real(0), Real(1)), a, -quotient, b);
}
/// (x, y, z) . (x', y', z') / |(x, y, z)|; 0 for the zero vector.
template <typename Real>
inline Dual<Real> lengthOf(const Dual<Real> &x, const Dual<Real> &y, const Dual<Real> &z) {
  Real value = lengthOf(x.value, y.value, z.value), inverse = divide(Real(1), value);
  Dual<Real> xy = chain(value, x.value * inverse, x, y.value * inverse, y);
  Real nz = z.value * inverse;
  return {value, slopes::sum(xy.u, slopes::product(nz, z.u)),
          slopes::sum(xy.v, slopes::product(nz, z.v))};
}

} // namespace anysl

#undef ANYSL_OF_DERIVATIVES

#endif // ANYSL_DUAL_H
