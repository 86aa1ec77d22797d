//===-- runtimes/real/operators/geometry.cpp - lengths, directions, transformations -----------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/domain.h>
#include <anysl/runtime.h>

using namespace anysl;

void anysl_length(anysl_float *result, const anysl_vector *v) {
  *result = lengthOf(v->x, v->y, v->z);
}

/// v / |v|. A power of two brings v near unit length first, so nothing overflows or vanishes on the
/// way. What is infinite stays so, and is then limited to a number beside which the rest is
/// nothing.
void anysl_normalize(anysl_vector *result, const anysl_vector *v) {
  anysl_float largest = absOf(v->x);
  largest = select(absOf(v->y) > largest, absOf(v->y), largest);
  largest = select(absOf(v->z) > largest, absOf(v->z), largest);
  anysl_float down, up, limit(0x1p60);
  scaleFor(largest, down, up);
  anysl_vector scaled = each(
      [down, limit](const anysl_float &c) {
        anysl_float x = c * down;
        x = select(x > limit, limit, x);
        return select(x < -limit, -limit, x);
      },
      *v);
  anysl_float length = math::sqrt(dot(scaled, scaled));
  auto isZero = length == 0;
  anysl_float inverse = math::divide(anysl_float(1), divisor(length, isZero));
  *result = scaled * select(isZero, anysl_float(0), inverse);
}

/// L.A >= cos(angle) |L| |A|, which needs neither a division nor an arc cosine.
bool anysl_in_cone(const anysl_vector *L, const anysl_vector *axis, const anysl_float *angle) {
  anysl_float bound =
      math::cos(*angle) * lengthOf(L->x, L->y, L->z) * lengthOf(axis->x, axis->y, axis->z);
  return dot(*L, *axis) >= bound;
}

void anysl_solar_direction(anysl_vector *result, const anysl_vector *axis) { *result = *axis; }

void anysl_transform_point(anysl_vector *result, const anysl_matrix *matrix,
                           const anysl_vector *p) {
  const auto &m = matrix->m;
  anysl_vector q = {p->x * m[0][0] + p->y * m[1][0] + p->z * m[2][0] + m[3][0],
                    p->x * m[0][1] + p->y * m[1][1] + p->z * m[2][1] + m[3][1],
                    p->x * m[0][2] + p->y * m[1][2] + p->z * m[2][2] + m[3][2]};
  anysl_float w = p->x * m[0][3] + p->y * m[1][3] + p->z * m[2][3] + m[3][3];
  *result = each([w](const anysl_float &c) { return divide(c, w); }, q);
}

void anysl_transform_vector(anysl_vector *result, const anysl_matrix *matrix,
                            const anysl_vector *v) {
  const auto &m = matrix->m;
  *result = {v->x * m[0][0] + v->y * m[1][0] + v->z * m[2][0],
             v->x * m[0][1] + v->y * m[1][1] + v->z * m[2][1],
             v->x * m[0][2] + v->y * m[1][2] + v->z * m[2][2]};
}

/// n times the inverse transpose of the upper 3 x 3 part: the inverse transpose is the matrix of
/// cofactors over the determinant. A matrix without an inverse gives 0.
void anysl_transform_normal(anysl_vector *result, const anysl_matrix *matrix,
                            const anysl_vector *n) {
  const auto &m = matrix->m;
  auto cofactor = [&m](int r, int c) {
    int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  anysl_float determinant =
      m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  anysl_vector q = {n->x * cofactor(0, 0) + n->y * cofactor(1, 0) + n->z * cofactor(2, 0),
                    n->x * cofactor(0, 1) + n->y * cofactor(1, 1) + n->z * cofactor(2, 1),
                    n->x * cofactor(0, 2) + n->y * cofactor(1, 2) + n->z * cofactor(2, 2)};
  *result = each([determinant](const anysl_float &c) { return divide(c, determinant); }, q);
}
