//===-- lib/Rib/Linear.h - vectors and matrices -----------------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Scenes are set up and hits are evaluated in double precision; rays and colours are float.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_RIB_LINEAR_H
#define ANYSL_LIB_RIB_LINEAR_H

#include <array>
#include <cmath>

/// Compiles a function once for each length of vectors; the program chooses when it starts.
#define ANYSL_RENDER_WIDE                                                                          \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))

namespace anysl::render {

template <typename T>
struct Vec3 {
  T x{}, y{}, z{};

  constexpr Vec3() = default;
  constexpr Vec3(T x, T y, T z) : x(x), y(y), z(z) {}
  explicit constexpr Vec3(T all) : x(all), y(all), z(all) {}
  template <typename U>
  explicit constexpr Vec3(const Vec3<U> &v) : x(T(v.x)), y(T(v.y)), z(T(v.z)) {}

  T operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  T &operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }

  friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend Vec3 operator*(Vec3 a, T s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Vec3 operator*(T s, Vec3 a) { return a * s; }
  friend Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  Vec3 &operator+=(Vec3 b) { return *this = *this + b; }
  Vec3 &operator*=(Vec3 b) { return *this = *this * b; }
  friend bool operator==(const Vec3 &, const Vec3 &) = default;
};

using Vec3d = Vec3<double>;
using Vec3f = Vec3<float>;

template <typename T>
T dot(Vec3<T> a, Vec3<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <typename T>
Vec3<T> cross(Vec3<T> a, Vec3<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3d v) { return std::sqrt(dot(v, v)); }
template <typename T>
T maxAbs(Vec3<T> v) {
  return std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z)));
}
template <typename T>
bool isFinite(Vec3<T> v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
/// A vector of unit length, or zero where v has no direction. The scaling keeps squares from
/// overflowing.
inline Vec3d normalized(Vec3d v) {
  double scale = maxAbs(v);
  if (!(scale > 0) || !isFinite(v))
    return Vec3d();
  v = {v.x / scale, v.y / scale, v.z / scale};
  return v * (1 / length(v));
}
template <typename T>
Vec3<T> lerp(Vec3<T> a, Vec3<T> b, T t) {
  return a * (1 - t) + b * t;
}

/// A 4x4 matrix for row vectors: a point p maps to p M, and "first A, then B" is A * B.
struct Matrix4 {
  std::array<std::array<double, 4>, 4> m{};

  static Matrix4 identity();
  static Matrix4 translation(Vec3d t);
  static Matrix4 scaling(Vec3d s);
  /// By an angle in degrees; a positive one turns x to y about z, y to z about x, z to x about y.
  static Matrix4 rotation(double degrees, Vec3d axis);

  friend Matrix4 operator*(const Matrix4 &a, const Matrix4 &b);
  friend bool operator==(const Matrix4 &, const Matrix4 &) = default;

  /// The inverse; false, and the matrix unchanged, where there is none.
  bool invert();
  /// The inverse, or the identity where there is none.
  Matrix4 inverse() const {
    Matrix4 result = *this;
    return result.invert() ? result : identity();
  }

  Vec3d point(Vec3d p) const;
  /// The same for a matrix whose last column is 0 0 0 1.
  Vec3d affinePoint(Vec3d p) const { return vector(p) + Vec3d(m[3][0], m[3][1], m[3][2]); }
  Vec3d vector(Vec3d v) const {
    return {v.x * m[0][0] + v.y * m[1][0] + v.z * m[2][0],
            v.x * m[0][1] + v.y * m[1][1] + v.z * m[2][1],
            v.x * m[0][2] + v.y * m[1][2] + v.z * m[2][2]};
  }
  /// Transforms a normal where *this* is the inverse of the points' matrix.
  Vec3d normalByInverse(Vec3d n) const {
    return {m[0][0] * n.x + m[0][1] * n.y + m[0][2] * n.z,
            m[1][0] * n.x + m[1][1] * n.y + m[1][2] * n.z,
            m[2][0] * n.x + m[2][1] * n.y + m[2][2] * n.z};
  }
};

} // namespace anysl::render

#endif
