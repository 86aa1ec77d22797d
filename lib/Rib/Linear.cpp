//===-- lib/Rib/Linear.cpp - vectors and matrices ---------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/Linear.h"

#include <numbers>
#include <utility>

using namespace anysl::render;

Matrix4 Matrix4::identity() { return scaling({1, 1, 1}); }

Matrix4 Matrix4::translation(Vec3d t) {
  Matrix4 result = identity();
  result.m[3] = {t.x, t.y, t.z, 1};
  return result;
}

Matrix4 Matrix4::scaling(Vec3d s) {
  Matrix4 result;
  result.m[0][0] = s.x;
  result.m[1][1] = s.y;
  result.m[2][2] = s.z;
  result.m[3][3] = 1;
  return result;
}

Matrix4 Matrix4::rotation(double degrees, Vec3d axis) {
  Vec3d a = normalized(axis);
  if (a == Vec3d())
    return identity();
  double angle = degrees * (std::numbers::pi / 180);
  double s = std::sin(angle), c = std::cos(angle), k = 1 - c;
  Matrix4 result;
  result.m[0] = {a.x * a.x * k + c, a.x * a.y * k + a.z * s, a.x * a.z * k - a.y * s, 0};
  result.m[1] = {a.x * a.y * k - a.z * s, a.y * a.y * k + c, a.y * a.z * k + a.x * s, 0};
  result.m[2] = {a.x * a.z * k + a.y * s, a.y * a.z * k - a.x * s, a.z * a.z * k + c, 0};
  result.m[3] = {0, 0, 0, 1};
  return result;
}

namespace anysl::render {
Matrix4 operator*(const Matrix4 &a, const Matrix4 &b) {
  Matrix4 result;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      for (int k = 0; k < 4; ++k)
        result.m[row][column] += a.m[row][k] * b.m[k][column];
  return result;
}
} // namespace anysl::render

bool Matrix4::invert() {
  // Gauss and Jordan, with the largest pivot of each column.
  Matrix4 a = *this, result = identity();
  for (int column = 0; column < 4; ++column) {
    int pivot = column;
    for (int row = column + 1; row < 4; ++row)
      if (std::fabs(a.m[row][column]) > std::fabs(a.m[pivot][column]))
        pivot = row;
    double value = a.m[pivot][column];
    if (value == 0 || !std::isfinite(value))
      return false;
    std::swap(a.m[pivot], a.m[column]);
    std::swap(result.m[pivot], result.m[column]);
    for (int k = 0; k < 4; ++k) {
      a.m[column][k] /= value;
      result.m[column][k] /= value;
    }
    for (int row = 0; row < 4; ++row) {
      double factor = row == column ? 0 : a.m[row][column];
      for (int k = 0; k < 4; ++k) {
        a.m[row][k] -= factor * a.m[column][k];
        result.m[row][k] -= factor * result.m[column][k];
      }
    }
  }
  *this = result;
  return true;
}

Vec3d Matrix4::point(Vec3d p) const {
  double c[4];
  for (int k = 0; k < 4; ++k)
    c[k] = p.x * m[0][k] + p.y * m[1][k] + p.z * m[2][k] + m[3][k];
  if (c[3] == 1 || c[3] == 0)
    return {c[0], c[1], c[2]};
  return {c[0] / c[3], c[1] / c[3], c[2] / c[3]};
}
