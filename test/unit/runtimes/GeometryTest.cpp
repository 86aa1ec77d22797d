//===-- test/unit/runtimes/GeometryTest.cpp - lengths, directions, transformations, matrices
//----===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <random>

namespace {

const double tiny = std::numeric_limits<Real>::min(), huge = std::numeric_limits<Real>::max();

/// Directions in all octants, from along an axis to oblique.
std::vector<std::array<double, 3>> directions() {
  std::vector<std::array<double, 3>> result = {
      {1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {1, 1, 1}, {-3, 4, 0}};
  std::mt19937 generator(7);
  std::normal_distribution<double> component;
  for (int i = 0; i < 500; ++i)
    result.push_back({component(generator), component(generator), component(generator)});
  return result;
}

anysl_vector scaled(const std::array<double, 3> &d, double factor) {
  return {Real(d[0] * factor), Real(d[1] * factor), Real(d[2] * factor)};
}

long double exactLength(const anysl_vector &v) {
  return std::sqrt((long double)v.x * v.x + (long double)v.y * v.y + (long double)v.z * v.z);
}

} // namespace

TEST_CASE("length neither overflows nor vanishes") {
  CHECK(call<anysl_length>(anysl_vector(3, -4, 12)) == 13);
  CHECK(call<anysl_length>(anysl_vector(0, 0, 0)) == 0);
  CHECK(call<anysl_length>(anysl_vector(infinite, 1, 2)) == infinite);
  CHECK(std::isnan(call<anysl_length>(anysl_vector(1, notANumber, 2))));
  for (double factor :
       {8 * tiny, std::sqrt(tiny) / 8, 1e-3, 1.0, 1e10, std::sqrt(huge) * 8, huge / 16})
    for (const auto &d : directions()) {
      anysl_vector v = scaled(d, factor);
      long double exact = exactLength(v);
      Real length = call<anysl_length>(v);
      if (std::abs(length - exact) > 2 * spacing * exact)
        FAIL("|" << v.x << ", " << v.y << ", " << v.z << "| = " << length);
    }
}

TEST_CASE("a normalised vector has unit length and the same direction at every magnitude") {
  for (double factor :
       {8 * tiny, std::sqrt(tiny) / 8, 1e-3, 1.0, 1e10, std::sqrt(huge) * 8, huge / 8})
    for (const auto &d : directions()) {
      anysl_vector v = scaled(d, factor), n = call<anysl_normalize>(v);
      long double length = exactLength(v);
      if (std::abs(n.x - v.x / length) > 2 * spacing ||
          std::abs(n.y - v.y / length) > 2 * spacing || std::abs(n.z - v.z / length) > 2 * spacing)
        FAIL("normalize(" << v.x << ", " << v.y << ", " << v.z << ") = " << n.x << ", " << n.y
                          << ", " << n.z);
    }
}

TEST_CASE("normalising what has no direction gives a stated result") {
  checkVector(call<anysl_normalize>(anysl_vector(0, 0, 0)), 0, 0, 0, 0);
  checkVector(call<anysl_normalize>(anysl_vector(Real(-0.0), 0, 0)), 0, 0, 0, 0);
  checkVector(call<anysl_normalize>(anysl_vector(infinite, largest, 2)), 1, 0, 0, 0);
  double r = std::sqrt(0.5);
  checkVector(call<anysl_normalize>(anysl_vector(-infinite, 5, infinite)), -r, 0, r);
  anysl_vector n = call<anysl_normalize>(anysl_vector(1, notANumber, 2));
  CHECK((std::isnan(n.x) || std::isnan(n.y) || std::isnan(n.z)));
}

TEST_CASE("a direction is in a cone up to its angle") {
  auto inCone = [](const anysl_vector &L, double degrees) {
    Real angle = Real(degrees * 3.14159265358979323846 / 180);
    anysl_vector axis(0, 0, 5);
    return use<anysl_in_cone>()(&L, &axis, &angle);
  };
  CHECK(inCone({0, 0, 2}, 1));
  CHECK(inCone({1, 0, Real(1.001)}, 45));
  CHECK_FALSE(inCone({1, 0, Real(0.999)}, 45));
  CHECK(inCone({1, 0, Real(0.001)}, 90));
  CHECK_FALSE(inCone({1, 0, Real(-0.001)}, 90));
  CHECK(inCone({0, Real(0.001), -1}, 180));
  CHECK_FALSE(inCone({0, 0, -1}, 90));
}

TEST_CASE("points, vectors and normals are transformed each in its own way") {
  // Row vectors: the last row translates.
  anysl_matrix m = {{{2, 0, 0, 0}, {0, 4, 0, 0}, {0, 1, 1, 0}, {10, 20, 30, 1}}};
  checkVector(call<anysl_transform_point>(m, anysl_vector(1, 2, 3)), 12, 31, 33);
  checkVector(call<anysl_transform_vector>(m, anysl_vector(1, 2, 3)), 2, 11, 3);
  // A normal stays perpendicular to the transformed plane.
  anysl_vector n = call<anysl_transform_normal>(m, anysl_vector(1, 2, 3));
  anysl_vector inPlane[] = {{2, -1, 0}, {0, 3, -2}};
  for (const anysl_vector &v : inPlane)
    CHECK(call<anysl_dot>(n, call<anysl_transform_vector>(m, v)) == near(0, 64));
  checkVector(n, 0.5, 0.5, 2.5);
}

TEST_CASE("a projection divides by w, and a singular matrix gives 0") {
  anysl_matrix projection = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 1}, {0, 0, 0, 0}}};
  checkVector(call<anysl_transform_point>(projection, anysl_vector(2, 4, 8)), 0.25, 0.5, 1);
  checkVector(call<anysl_transform_point>(projection, anysl_vector(2, 4, 0)), 0, 0, 0);
  checkVector(call<anysl_transform_normal>(anysl_matrix{}, anysl_vector(1, 2, 3)), 0, 0, 0);
}

//===-- Matrices
//--------------------------------------------------------------------------------===//

TEST_CASE("matrices are computed element by element") {
  anysl_matrix a, b;
  for (int k = 0; k < 16; ++k)
    a.m[k / 4][k % 4] = Real(k), b.m[k / 4][k % 4] = Real(2 * k + 1);
  anysl_matrix sum = call<anysl_add_matrix>(a, b), difference = call<anysl_sub_matrix>(a, b);
  anysl_matrix negative = call<anysl_neg_matrix>(a), triple = call<anysl_scale_matrix>(a, 3);
  for (int k = 0; k < 16; ++k) {
    CHECK(sum.m[k / 4][k % 4] == 3 * k + 1);
    CHECK(difference.m[k / 4][k % 4] == -k - 1);
    CHECK(negative.m[k / 4][k % 4] == -k);
    CHECK(triple.m[k / 4][k % 4] == 3 * k);
  }
}

TEST_CASE("the product of matrices is the transformation by the first and then the second") {
  anysl_matrix a = {{{1, 2, 0, 0}, {0, 1, 0, 0}, {3, 0, 1, 0}, {5, 6, 7, 1}}};
  anysl_matrix b = {{{2, 0, 0, 0}, {0, 1, 4, 0}, {0, 0, 3, 0}, {1, 1, 1, 1}}};
  anysl_vector p(1, Real(-2), Real(0.5));
  anysl_vector expected = call<anysl_transform_point>(b, call<anysl_transform_point>(a, p));
  checkVector(call<anysl_transform_point>(call<anysl_mul_matrix>(a, b), p), expected.x, expected.y,
              expected.z);
}

TEST_CASE("determinant and inverse agree with hand computation") {
  anysl_matrix m = {{{2, 1, 0, 0}, {0, 3, 1, 0}, {1, 0, 4, 0}, {5, 6, 7, 1}}};
  CHECK(call<anysl_determinant>(m) == near(25));
  const double identity[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  anysl_matrix inverse = call<anysl_inverse>(m);
  checkMatrix(inverse, {{0.48, -0.16, 0.04, 0},
                        {0.04, 0.32, -0.08, 0},
                        {-0.12, 0.04, 0.24, 0},
                        {-1.8, -1.4, -1.4, 1}});
  checkMatrix(call<anysl_mul_matrix>(m, inverse), identity);
  checkMatrix(call<anysl_div_matrix>(m, m), identity);
  // All sixteen elements take part.
  anysl_matrix full = {{{1, 2, 3, 4}, {2, -1, 1, 0}, {0, 5, -2, 1}, {3, 1, 2, -1}}};
  CHECK(call<anysl_determinant>(full) == near(-105, 32));
  checkMatrix(call<anysl_mul_matrix>(full, call<anysl_inverse>(full)), identity);
  CHECK(call<anysl_eq_matrix>(call<anysl_inverse>(anysl_matrix{}), anysl_matrix{}));
}

TEST_CASE("translation, rotation and scale come before the matrix") {
  anysl_matrix m = {{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 0, 1}}};
  Real quarter = Real(std::acos(-1.0) / 2);
  anysl_vector p(1, 2, 3);
  checkVector(call<anysl_transform_point>(call<anysl_translate>(m, anysl_vector(1, 0, -1)), p), 4,
              4, 4);
  checkVector(call<anysl_transform_point>(call<anysl_scale_matrix_by>(m, anysl_vector(1, 2, 3)), p),
              2, 8, 18);
  // Counterclockwise: x turns to y about z, y to z about x, z to x about y.
  auto turned = [&](const anysl_vector &axis) {
    return call<anysl_transform_point>(call<anysl_rotate_matrix>(m, quarter, axis), p);
  };
  checkVector(turned({0, 0, 7}), -4, 2, 6, 16);
  checkVector(turned({7, 0, 0}), 2, -6, 4, 16);
  checkVector(turned({0, 7, 0}), 6, 4, -2, 16);
}
