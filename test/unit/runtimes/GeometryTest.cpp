//===-- test/unit/runtimes/GeometryTest.cpp - lengths, directions, matrices -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <random>

namespace {

const double tiny = std::numeric_limits<anysl_number>::min(),
             huge = std::numeric_limits<anysl_number>::max();

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
  long double x = plain(v.x), y = plain(v.y), z = plain(v.z);
  return std::sqrt(x * x + y * y + z * z);
}

} // namespace

TEST_CASE("length neither overflows nor vanishes") {
  CHECK(call<anysl_length>(anysl_vector(3, -4, 12)) == 13);
  CHECK(call<anysl_length>(anysl_vector(0, 0, 0)) == 0);
  CHECK(call<anysl_length>(anysl_vector(infinite, 1, 2)) == infinite);
  CHECK(anysl::isNaN(call<anysl_length>(anysl_vector(1, notANumber, 2))));
  for (double factor :
       {8 * tiny, std::sqrt(tiny) / 8, 1e-3, 1.0, 1e10, std::sqrt(huge) * 8, huge / 16})
    for (const auto &d : directions()) {
      anysl_vector v = scaled(d, factor);
      long double exact = exactLength(v);
      Real length = call<anysl_length>(v);
      if (std::abs(plain(length) - exact) > 2 * spacing * exact)
        FAIL("|" << v.x << ", " << v.y << ", " << v.z << "| = " << length);
    }
}

TEST_CASE("a normalised vector has unit length and the same direction at every magnitude") {
  for (double factor :
       {8 * tiny, std::sqrt(tiny) / 8, 1e-3, 1.0, 1e10, std::sqrt(huge) * 8, huge / 8})
    for (const auto &d : directions()) {
      anysl_vector v = scaled(d, factor), n = call<anysl_normalize>(v);
      long double length = exactLength(v);
      auto isOff = [&](const Real &a, const Real &b) {
        return std::abs(plain(a) - plain(b) / length) > 2 * spacing;
      };
      if (isOff(n.x, v.x) || isOff(n.y, v.y) || isOff(n.z, v.z))
        FAIL("normalize(" << v.x << ", " << v.y << ", " << v.z << ") = " << n.x << ", " << n.y
                          << ", " << n.z);
    }
}

TEST_CASE("normalising what has no direction gives a stated result") {
  checkVector(call<anysl_normalize>(anysl_vector(0, 0, 0)), 0, 0, 0, 0);
  checkVector(call<anysl_normalize>(anysl_vector(Real(-0.0), 0, 0)), 0, 0, 0, 0);
  checkVector(call<anysl_normalize>(anysl_vector(infinite, largest, 2)), 1, 0, 0);
  double r = std::sqrt(0.5);
  checkVector(call<anysl_normalize>(anysl_vector(-infinite, 5, infinite)), -r, 0, r);
  anysl_vector n = call<anysl_normalize>(anysl_vector(1, notANumber, 2));
  CHECK((anysl::isNaN(n.x) || anysl::isNaN(n.y) || anysl::isNaN(n.z)));
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

TEST_CASE("light from far away comes along the axis as it is") {
  checkVector(call<anysl_solar_direction>(anysl_vector(1, -2, 3)), 1, -2, 3);
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

//===-- Refraction ----------------------------------------------------------------------------===//

namespace {

struct Fresnel {
  Real Kr, Kt;
  anysl_vector R, T;
};

Fresnel fresnel(const anysl_vector &I, const anysl_vector &N, Real eta) {
  Fresnel f;
  use<anysl_fresnel>()(&I, &N, &eta, &f.Kr, &f.Kt, &f.R, &f.T);
  return f;
}

/// The same equations with the digits of long double.
long double exactShare(const anysl_vector &I, const anysl_vector &N, Real eta, bool &isTotal) {
  long double n = plain(eta), x = plain(I.x), y = plain(I.y), z = plain(I.z);
  long double c = std::abs(x * plain(N.x) + y * plain(N.y) + z * plain(N.z));
  long double k = (1 - n) * (1 + n) + (n * c) * (n * c);
  isTotal = k < 0;
  if (isTotal)
    return 1;
  long double inside = std::sqrt(k);
  long double perpendicular = (n * c - inside) / (n * c + inside);
  long double parallel = (c - n * inside) / (c + n * inside);
  return (perpendicular * perpendicular + parallel * parallel) / 2;
}

/// A direction at an angle to a normal, both in no special position.
void atAngle(double angle, const std::array<double, 3> &normal, anysl_vector &I, anysl_vector &N) {
  double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  std::array<double, 3> n, t;
  for (int k = 0; k < 3; ++k)
    n[k] = normal[k] / length;
  // Any vector across n: the axis that n is farthest from, made perpendicular.
  int axis = std::abs(n[0]) < 0.5 ? 0 : 1;
  double tLength = std::sqrt(1 - n[axis] * n[axis]);
  for (int k = 0; k < 3; ++k)
    t[k] = ((k == axis) - n[axis] * n[k]) / tLength;
  for (int k = 0; k < 3; ++k) {
    (&N.x)[k] = Real(n[k]);
    (&I.x)[k] = Real(std::sin(angle) * t[k] - std::cos(angle) * n[k]);
  }
}

} // namespace

TEST_CASE(
    "fresnel at normal incidence, at Brewster's angle and at grazing is as the books have it") {
  Fresnel f = fresnel({0, 0, -1}, {0, 0, 1}, Real(1 / 1.5));
  CHECK(f.Kr == near(0.04));
  CHECK(f.Kt == near(0.96));
  checkVector(f.R, 0, 0, 1);
  checkVector(f.T, 0, 0, -1);
  // At Brewster's angle only half of the light, the perpendicular part, is reflected at all.
  double brewster = std::atan(1.5), inside = std::asin(std::sin(brewster) / 1.5);
  f = fresnel({Real(std::sin(brewster)), 0, Real(-std::cos(brewster))}, {0, 0, 1}, Real(1 / 1.5));
  double perpendicular = std::sin(brewster - inside) / std::sin(brewster + inside);
  CHECK(f.Kr == near(perpendicular * perpendicular / 2, 32));
  checkVector(f.T, std::sin(inside), 0, -std::cos(inside));
  checkVector(f.R, std::sin(brewster), 0, std::cos(brewster));
  CHECK(fresnel({1, 0, 0}, {0, 0, 1}, Real(1 / 1.5)).Kr == 1);
}

TEST_CASE("total reflection gives Kr = 1, Kt = 0, T = 0") {
  Fresnel f = fresnel({Real(0.8), 0, Real(-0.6)}, {0, 0, 1}, Real(1.5));
  CHECK(f.Kr == 1);
  CHECK(f.Kt == 0);
  checkVector(f.T, 0, 0, 0, 0);
  checkVector(f.R, 0.8, 0, 0.6);
}

TEST_CASE("about the critical angle the share is right, and the side never wrong") {
  for (Real eta : {Real(1.5), Real(1.0001), Real(1.000001)}) {
    double critical = std::asin(1 / plain(eta));
    for (const auto &normal : directions())
      for (double offset = 1e-7; offset < 0.4; offset *= 3)
        for (double side : {-1, 1}) {
          double angle = critical + side * offset;
          if (angle > 1.5707)
            continue;
          anysl_vector I, N;
          atAngle(angle, normal, I, N);
          bool isTotal;
          long double share = exactShare(I, N, eta, isTotal);
          Fresnel f = fresnel(I, N, eta);
          anysl_vector T = call<anysl_refract>(I, N, eta);
          bool hasNoT = T.x == 0 && T.y == 0 && T.z == 0;
          if (std::abs(plain(f.Kr) - share) > 1e-5 || f.Kr < 0 || f.Kr > 1 || hasNoT != isTotal)
            FAIL("eta " << eta << " angle " << angle << ": " << f.Kr << ", not " << double(share));
        }
  }
}

TEST_CASE("extreme ratios of media give shares in [0, 1]") {
  anysl_vector N(0, 0, 1), oblique(Real(0.6), 0, Real(-0.8)), grazing(1, 0, 0);
  CHECK(fresnel(grazing, N, 1).Kr == 0);
  CHECK(fresnel(oblique, N, 1).Kr == near(0));
  for (const anysl_vector &I : {oblique, grazing}) {
    for (Real eta : {Real(0), Real(1e-30), infinite, Real(1e30)}) {
      INFO("eta " << eta);
      CHECK(fresnel(I, N, eta).Kr == near(1));
    }
    CHECK(fresnel(I, N, Real(-1.2)).Kr == fresnel(I, N, Real(1.2)).Kr);
  }
}

TEST_CASE("refraction obeys Snell's law, and eta = 1 changes nothing") {
  for (const auto &normal : directions())
    for (double angle : {0.0, 1e-4, 0.3, 1.0, 1.5, 1.57}) {
      anysl_vector I, N;
      atAngle(angle, normal, I, N);
      anysl_vector same = call<anysl_refract>(I, N, 1);
      checkVector(same, plain(I.x), plain(I.y), plain(I.z), 2);
      for (Real eta : {Real(0.5), Real(1 / 1.5), Real(0.999)}) {
        anysl_vector T = call<anysl_refract>(I, N, eta);
        anysl_vector across = call<anysl_cross>(N, T), before = call<anysl_cross>(N, I);
        checkVector(across, plain(eta * before.x), plain(eta * before.y), plain(eta * before.z));
        CHECK(call<anysl_length>(T) == near(1));
      }
    }
}

//===-- Matrices ------------------------------------------------------------------------------===//

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
  checkVector(call<anysl_transform_point>(call<anysl_mul_matrix>(a, b), p), plain(expected.x),
              plain(expected.y), plain(expected.z));
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
