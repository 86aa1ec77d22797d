//===-- runtimes/real/operators/matrix.cpp - products and inverses ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/domain.h>
#include <anysl/runtime.h>

using namespace anysl;

namespace {

anysl_matrix product(const anysl_matrix &a, const anysl_matrix &b) {
  anysl_matrix result;
  repeat<16>([&](auto k) {
    constexpr int r = k / 4, c = k % 4;
    result.m[r][c] = a.m[r][0] * b.m[0][c] + a.m[r][1] * b.m[1][c] + a.m[r][2] * b.m[2][c] +
                     a.m[r][3] * b.m[3][c];
  });
  return result;
}

/// The 2 x 2 determinants of the upper and of the lower two rows, from which both the determinant
/// and the cofactors follow (Laplace's expansion by complementary minors).
struct Minors {
  anysl_float upper[6], lower[6];

  explicit Minors(const anysl_matrix &a) {
    const auto &m = a.m;
    auto minor = [&m](int row, int c1, int c2) {
      return m[row][c1] * m[row + 1][c2] - m[row][c2] * m[row + 1][c1];
    };
    upper[0] = minor(0, 0, 1), lower[0] = minor(2, 0, 1);
    upper[1] = minor(0, 0, 2), lower[1] = minor(2, 0, 2);
    upper[2] = minor(0, 0, 3), lower[2] = minor(2, 0, 3);
    upper[3] = minor(0, 1, 2), lower[3] = minor(2, 1, 2);
    upper[4] = minor(0, 1, 3), lower[4] = minor(2, 1, 3);
    upper[5] = minor(0, 2, 3), lower[5] = minor(2, 2, 3);
  }

  anysl_float determinant() const {
    return upper[0] * lower[5] - upper[1] * lower[4] + upper[2] * lower[3] + upper[3] * lower[2] -
           upper[4] * lower[1] + upper[5] * lower[0];
  }
};

anysl_matrix inverseOf(const anysl_matrix &a) {
  const auto &m = a.m;
  Minors minors(a);
  const auto &s = minors.upper, &c = minors.lower;
  anysl_float determinant = minors.determinant();
  anysl_matrix adjugate = {{
      {m[1][1] * c[5] - m[1][2] * c[4] + m[1][3] * c[3],
       m[0][2] * c[4] - m[0][1] * c[5] - m[0][3] * c[3],
       m[3][1] * s[5] - m[3][2] * s[4] + m[3][3] * s[3],
       m[2][2] * s[4] - m[2][1] * s[5] - m[2][3] * s[3]},
      {m[1][2] * c[2] - m[1][0] * c[5] - m[1][3] * c[1],
       m[0][0] * c[5] - m[0][2] * c[2] + m[0][3] * c[1],
       m[3][2] * s[2] - m[3][0] * s[5] - m[3][3] * s[1],
       m[2][0] * s[5] - m[2][2] * s[2] + m[2][3] * s[1]},
      {m[1][0] * c[4] - m[1][1] * c[2] + m[1][3] * c[0],
       m[0][1] * c[2] - m[0][0] * c[4] - m[0][3] * c[0],
       m[3][0] * s[4] - m[3][1] * s[2] + m[3][3] * s[0],
       m[2][1] * s[2] - m[2][0] * s[4] - m[2][3] * s[0]},
      {m[1][1] * c[1] - m[1][0] * c[3] - m[1][2] * c[0],
       m[0][0] * c[3] - m[0][1] * c[1] + m[0][2] * c[0],
       m[3][1] * s[1] - m[3][0] * s[3] - m[3][2] * s[0],
       m[2][0] * s[3] - m[2][1] * s[1] + m[2][2] * s[0]},
  }};
  return each([determinant](const anysl_float &element) { return divide(element, determinant); },
              adjugate);
}

} // namespace

void anysl_mul_matrix(anysl_matrix *result, const anysl_matrix *a, const anysl_matrix *b) {
  *result = product(*a, *b);
}

void anysl_div_matrix(anysl_matrix *result, const anysl_matrix *a, const anysl_matrix *b) {
  *result = product(*a, inverseOf(*b));
}

void anysl_determinant(anysl_float *result, const anysl_matrix *a) {
  *result = Minors(*a).determinant();
}

void anysl_inverse(anysl_matrix *result, const anysl_matrix *a) { *result = inverseOf(*a); }

// The three below put their transformation before the matrix, as the interface's Translate, Rotate
// and Scale do: a point, a row vector, meets it first.

void anysl_translate(anysl_matrix *result, const anysl_matrix *a, const anysl_vector *t) {
  anysl_float zero(0), one(1);
  *result = product({{{one, zero, zero, zero},
                      {zero, one, zero, zero},
                      {zero, zero, one, zero},
                      {t->x, t->y, t->z, one}}},
                    *a);
}

/// Rodrigues' formula about the normalised axis, counterclockwise as one looks against it.
void anysl_rotate_matrix(anysl_matrix *result, const anysl_matrix *a, const anysl_float *angle,
                         const anysl_vector *axis) {
  anysl_vector u;
  anysl_normalize(&u, axis);
  anysl_float s = math::sin(*angle), c = math::cos(*angle), k = 1 - c, zero(0), one(1);
  *result = product({{{c + u.x * u.x * k, u.x * u.y * k + u.z * s, u.x * u.z * k - u.y * s, zero},
                      {u.x * u.y * k - u.z * s, c + u.y * u.y * k, u.y * u.z * k + u.x * s, zero},
                      {u.x * u.z * k + u.y * s, u.y * u.z * k - u.x * s, c + u.z * u.z * k, zero},
                      {zero, zero, zero, one}}},
                    *a);
}

void anysl_scale_matrix_by(anysl_matrix *result, const anysl_matrix *a, const anysl_vector *t) {
  anysl_float zero(0), one(1);
  *result = product({{{t->x, zero, zero, zero},
                      {zero, t->y, zero, zero},
                      {zero, zero, t->z, zero},
                      {zero, zero, zero, one}}},
                    *a);
}
