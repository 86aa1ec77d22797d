//===-- anysl/mp.h - a real number of hundreds of bits ----------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Mp is what `float` is where a shader is computed to find out how exact the other reals are. Its
// digits lie in the number itself, so that it is copied like any other number and nothing has to be
// freed; how many of them count is decided when a shader is linked (anysl_real_precision). Sums and
// products, roots and elementary functions are GNU MPFR's, each rounded once, to nearest.
//
// It has more digits than double, and double's range where the rules of <anysl/domain.h> ask for
// one. The header of a real defines `anysl_number` as double and includes this file.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_MP_H
#define ANYSL_MP_H

#include <anysl/ieee.h>

namespace anysl {

/// A number. All bytes zero is 0, as variables are at first.
struct Mp {
  /// Room for 512 bits.
  static constexpr int limbCount = 8;
  enum Kind : int32_t { Zero, Finite, Infinite, NotANumber };

  Kind kind;
  int32_t isNegative; ///< 1: below 0, or -0
  int64_t exponent;   ///< of a finite number: its magnitude is in [2^(exponent-1), 2^exponent)
  uint64_t limbs[limbCount];

  Mp() = default;
  Mp(double x);
  Mp(float x) : Mp(double(x)) {}
  Mp(int x) : Mp(double(x)) {}

  /// The nearest one.
  explicit operator double() const;
  explicit operator float() const { return float(double(*this)); }
};

} // namespace anysl

//===-- MPFR's part ---------------------------------------------------------------------------===//
// runtimes/real/mp/functions.cpp defines these. A result is never an operand as well.

extern "C" {

/// How many bits of a number count: at least 53, at most what Mp has room for. The linker may
/// change it.
extern const uint32_t anysl_real_precision;
/// The most that it may be.
extern const uint32_t anysl_real_precision_limit;

void anysl_mp_from_double(anysl::Mp *result, double x);
double anysl_mp_to_double(const anysl::Mp *x);
/// Towards zero; limited to what fits, and 0 for NaN.
int64_t anysl_mp_to_integer(const anysl::Mp *x);
/// -1, 0 or 1 for a < b, a = b, a > b; 2 if one is NaN.
int32_t anysl_mp_compare(const anysl::Mp *a, const anysl::Mp *b);
void anysl_mp_add(anysl::Mp *result, const anysl::Mp *a, const anysl::Mp *b);
void anysl_mp_sub(anysl::Mp *result, const anysl::Mp *a, const anysl::Mp *b);
void anysl_mp_mul(anysl::Mp *result, const anysl::Mp *a, const anysl::Mp *b);
void anysl_mp_fma(anysl::Mp *result, const anysl::Mp *a, const anysl::Mp *b, const anysl::Mp *c);
void anysl_mp_floor(anysl::Mp *result, const anysl::Mp *x);
void anysl_mp_ceil(anysl::Mp *result, const anysl::Mp *x);
void anysl_mp_next_below(anysl::Mp *result, const anysl::Mp *x);

#define MATH_UNARY(name, ...) void anysl_mp_##name(anysl::Mp *result, const anysl::Mp *x);
#define MATH_BINARY(name, ...)                                                                     \
  void anysl_mp_##name(anysl::Mp *result, const anysl::Mp *x, const anysl::Mp *y);
#include <anysl/MathFunctions.def>

} // extern "C"

namespace anysl {

//===-- Arithmetic ----------------------------------------------------------------------------===//

inline Mp::Mp(double x) { anysl_mp_from_double(this, x); }
inline Mp::operator double() const { return anysl_mp_to_double(this); }

#define ANYSL_MP_UNARY(name, function)                                                             \
  inline Mp name(const Mp &x) {                                                                    \
    Mp result;                                                                                     \
    function(&result, &x);                                                                         \
    return result;                                                                                 \
  }
#define ANYSL_MP_BINARY(name, function)                                                            \
  inline Mp name(const Mp &a, const Mp &b) {                                                       \
    Mp result;                                                                                     \
    function(&result, &a, &b);                                                                     \
    return result;                                                                                 \
  }
#define ANYSL_MP_COMPARISON(name, condition)                                                       \
  inline bool name(const Mp &a, const Mp &b) {                                                     \
    int32_t order = anysl_mp_compare(&a, &b);                                                      \
    return condition;                                                                              \
  }

ANYSL_MP_BINARY(operator+, anysl_mp_add)
ANYSL_MP_BINARY(operator-, anysl_mp_sub)
ANYSL_MP_BINARY(operator*, anysl_mp_mul)
ANYSL_MP_COMPARISON(operator==, order == 0)
ANYSL_MP_COMPARISON(operator!=, order != 0)
ANYSL_MP_COMPARISON(operator<, order == -1)
ANYSL_MP_COMPARISON(operator<=, order == -1 || order == 0)
ANYSL_MP_COMPARISON(operator>, order == 1)
ANYSL_MP_COMPARISON(operator>=, order == 1 || order == 0)

/// -x where bit 0 of `sign` is set, else x.
inline Mp negateIf(const Mp &x, uint32_t sign) {
  Mp result = x;
  result.isNegative ^= int32_t(sign & 1);
  return result;
}
inline Mp operator-(const Mp &x) { return negateIf(x, 1); }

//===-- What a real promises ------------------------------------------------------------------===//

/// The range that <anysl/domain.h> keeps to.
template <>
struct IeeeFormat<Mp> {
  static constexpr double smallestNormal = IeeeFormat<double>::smallestNormal;
  static constexpr double largestFinite = IeeeFormat<double>::largestFinite;
};

template <>
inline constexpr bool isScalarOnly<Mp> = true;

inline double numberOf(const Mp &x) { return double(x); }
inline Mp select(bool condition, const Mp &a, const Mp &b) { return condition ? a : b; }
inline bool isNaN(const Mp &x) { return x.kind == Mp::NotANumber; }
inline bool isFinite(const Mp &x) { return x.kind < Mp::Infinite; }
inline bool hasSign(const Mp &x) { return x.isNegative; }
inline Mp absOf(const Mp &x) { return negateIf(x, uint32_t(x.isNegative)); }
inline Mp copySign(const Mp &magnitude, const Mp &sign) {
  return negateIf(magnitude, uint32_t(magnitude.isNegative ^ sign.isNegative));
}
ANYSL_MP_UNARY(floorOf, anysl_mp_floor)
ANYSL_MP_UNARY(ceilOf, anysl_mp_ceil)
ANYSL_MP_UNARY(justBelow, anysl_mp_next_below)
/// There are no flags to keep.
inline Mp divisor(const Mp &x, bool) { return x; }
inline Mp fusedMultiplyAdd(const Mp &a, const Mp &b, const Mp &c) {
  Mp result;
  anysl_mp_fma(&result, &a, &b, &c);
  return result;
}
inline void scaleFor(const Mp &m, Mp &down, Mp &up) {
  down = up = Mp(1);
  if (m.kind == Mp::Zero || m.kind == Mp::NotANumber)
    return;
  // Beside infinity every number of a host's is small.
  up.exponent = m.kind == Mp::Infinite ? IeeeFormat<double>::bias + 2 : m.exponent;
  down.exponent = 2 - up.exponent;
}
/// Of as many integers as double has; beyond, the cell that double takes.
inline uint32_t latticeCell(const Mp &x) {
  bool isWithin = absOf(x) < IeeeFormat<double>::largestInteger;
  return isWithin ? uint32_t(anysl_mp_to_integer(&x)) : latticeCell(numberOf(x));
}
inline int32_t toInteger(const Mp &x) { return toInteger(numberOf(x)); }

namespace math {

#define MATH_UNARY(name, ...) ANYSL_MP_UNARY(name, anysl_mp_##name)
#define MATH_BINARY(name, ...) ANYSL_MP_BINARY(name, anysl_mp_##name)
#include <anysl/MathFunctions.def>

} // namespace math

#undef ANYSL_MP_UNARY
#undef ANYSL_MP_BINARY
#undef ANYSL_MP_COMPARISON

} // namespace anysl

#endif // ANYSL_MP_H
