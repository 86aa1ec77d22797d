//===-- test/unit/runtimes/Operators.h - calling operators ------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_RUNTIMES_OPERATORS_H
#define ANYSL_TEST_RUNTIMES_OPERATORS_H

#include <anysl/runtime.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <type_traits>

using Real = anysl_float;

/// The operators that some test calls, collected before main from the instantiations of `use`.
inline std::set<const void *> &calledOperators() {
  static std::set<const void *> set;
  return set;
}

template <auto Op>
struct Called {
  static inline const bool noted = calledOperators().insert(reinterpret_cast<void *>(Op)).second;
};

/// An operator itself, noted as tested.
template <auto Op>
auto use() {
  (void)&Called<Op>::noted;
  return Op;
}

template <typename R, typename... P>
R apply(void (*op)(R *, const P *...), const std::type_identity_t<P> &...operands) {
  R result;
  op(&result, &operands...);
  return result;
}
template <typename R, typename... P>
R apply(R (*op)(const P *...), const std::type_identity_t<P> &...operands) {
  return op(&operands...);
}

/// The result of an operator on values: call<anysl_add_float>(1, 2).
template <auto Op, typename... P>
auto call(const P &...operands) {
  return apply(use<Op>(), operands...);
}

/// A number as the C library's functions want it.
inline double plain(const Real &x) { return double(anysl::numberOf(x)); }

using Limits = std::numeric_limits<anysl_number>;
inline const Real infinite = Limits::infinity();
inline const Real notANumber = Limits::quiet_NaN();
inline const Real largest = Limits::max();
/// Half of it is what one rounding may change a number near 1 by.
inline constexpr anysl_number spacing = Limits::epsilon();

namespace anysl {
template <typename T>
  requires(std::is_same_v<T, ::Real> && !std::is_arithmetic_v<T>)
std::ostream &operator<<(std::ostream &out, const T &x) {
  return out << plain(x);
}
} // namespace anysl

/// `value` to within some units in the last place.
inline Catch::Detail::Approx near(double value, double units = 8) {
  return Approx(value).epsilon(units * spacing).margin(units * spacing);
}

inline void checkVector(const anysl_vector &v, double x, double y, double z, double units = 8) {
  CHECK(anysl::valueOf(v.x) == near(x, units));
  CHECK(anysl::valueOf(v.y) == near(y, units));
  CHECK(anysl::valueOf(v.z) == near(z, units));
}

inline void checkColor(const anysl_color &c, double r, double g, double b, double units = 8) {
  CHECK(anysl::valueOf(c.r) == near(r, units));
  CHECK(anysl::valueOf(c.g) == near(g, units));
  CHECK(anysl::valueOf(c.b) == near(b, units));
}

inline void checkMatrix(const anysl_matrix &m, const double (&expected)[4][4], double units = 16) {
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      INFO("row " << row << " column " << column);
      CHECK(anysl::valueOf(m.m[row][column]) == near(expected[row][column], units));
    }
}

#endif // ANYSL_TEST_RUNTIMES_OPERATORS_H
