//===-- anysl/vec.h - vectors, colours and matrices over any real number ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The composite types of shaders. Components are plain members, never an array with a computed
// index: after inlining every component lives in a register of its own, and widening has nothing to
// gather.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_VEC_H
#define ANYSL_VEC_H

namespace anysl {

//===-- Unrolled loops ------------------------------------------------------------------------===//
// Nothing is left of these after inlining, whichever passes run: no array keeps a computed index.

template <int N>
struct Constant {
  static constexpr int value = N;
  constexpr operator int() const { return N; }
};

template <typename T, T... N>
struct Sequence {
  template <typename F>
  static void call(F &&f) {
    (f(Constant<N>{}), ...);
  }
};

/// Calls f(Constant<0>{}), f(Constant<1>{}) ... f(Constant<N - 1>{}).
template <int N, typename F>
inline void repeat(F &&f) {
  __make_integer_seq<Sequence, int, N>::call(f);
}

//===-- Types ---------------------------------------------------------------------------------===//

// Vec and Rgb have copy constructors of their own, and so are passed by address. By value, their
// numbers would be packed into pairs, and widening would have to take the pairs apart again; of an
// address nothing is left after inlining.

/// A point, vector or normal; only the operators that transform them tell the three apart.
template <typename Real>
struct Vec {
  Real x, y, z;

  Vec() = default;
  Vec(const Real &x, const Real &y, const Real &z) : x(x), y(y), z(z) {}
  Vec(const Vec &o) : x(o.x), y(o.y), z(o.z) {}
  Vec &operator=(const Vec &o) {
    x = o.x, y = o.y, z = o.z;
    return *this;
  }
};

/// A colour: red, green, blue.
template <typename Real>
struct Rgb {
  Real r, g, b;

  Rgb() = default;
  Rgb(const Real &r, const Real &g, const Real &b) : r(r), g(g), b(b) {}
  Rgb(const Rgb &o) : r(o.r), g(o.g), b(o.b) {}
  Rgb &operator=(const Rgb &o) {
    r = o.r, g = o.g, b = o.b;
    return *this;
  }
};

/// A 4 x 4 matrix in rows, for row vectors: p' = p M.
template <typename Real>
struct Mat {
  Real m[4][4];
};

//===-- Arithmetic ----------------------------------------------------------------------------===//

template <typename Real>
inline Vec<Real> operator+(const Vec<Real> &a, const Vec<Real> &b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename Real>
inline Vec<Real> operator-(const Vec<Real> &a, const Vec<Real> &b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename Real>
inline Vec<Real> operator-(const Vec<Real> &a) {
  return {-a.x, -a.y, -a.z};
}
template <typename Real>
inline Vec<Real> operator*(const Vec<Real> &a, const Real &s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <typename Real>
inline Real dot(const Vec<Real> &a, const Vec<Real> &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Real>
inline Rgb<Real> operator*(const Rgb<Real> &a, const Rgb<Real> &b) {
  return {a.r * b.r, a.g * b.g, a.b * b.b};
}
template <typename Real>
inline Rgb<Real> operator*(const Rgb<Real> &a, const Real &s) {
  return {a.r * s, a.g * s, a.b * s};
}

//===-- Component by component ----------------------------------------------------------------===//

/// f of each component of one, two or three operands.
template <typename Real, typename F>
inline Vec<Real> each(F &&f, const Vec<Real> &a) {
  return {f(a.x), f(a.y), f(a.z)};
}
template <typename Real, typename F>
inline Vec<Real> each(F &&f, const Vec<Real> &a, const Vec<Real> &b) {
  return {f(a.x, b.x), f(a.y, b.y), f(a.z, b.z)};
}
template <typename Real, typename F>
inline Rgb<Real> each(F &&f, const Rgb<Real> &a) {
  return {f(a.r), f(a.g), f(a.b)};
}
template <typename Real, typename F>
inline Rgb<Real> each(F &&f, const Rgb<Real> &a, const Rgb<Real> &b) {
  return {f(a.r, b.r), f(a.g, b.g), f(a.b, b.b)};
}
template <typename Real, typename F>
inline Mat<Real> each(F &&f, const Mat<Real> &a) {
  Mat<Real> result;
  repeat<16>([&](auto k) { result.m[k / 4][k % 4] = f(a.m[k / 4][k % 4]); });
  return result;
}
template <typename Real, typename F>
inline Mat<Real> each(F &&f, const Mat<Real> &a, const Mat<Real> &b) {
  Mat<Real> result;
  repeat<16>([&](auto k) { result.m[k / 4][k % 4] = f(a.m[k / 4][k % 4], b.m[k / 4][k % 4]); });
  return result;
}

} // namespace anysl

#endif // ANYSL_VEC_H
