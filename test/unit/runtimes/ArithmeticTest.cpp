//===-- test/unit/runtimes/ArithmeticTest.cpp - arithmetic and comparison ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"

TEST_CASE("real arithmetic is IEEE's, but for division by nothing") {
  CHECK(call<anysl_neg_float>(Real(3)) == -3);
  CHECK(call<anysl_add_float>(3, Real(0.5)) == 3.5);
  CHECK(call<anysl_sub_float>(3, Real(0.5)) == 2.5);
  CHECK(call<anysl_mul_float>(3, Real(0.5)) == 1.5);
  CHECK(call<anysl_div_float>(3, Real(0.5)) == 6);
  CHECK(call<anysl_div_float>(1, 3) == near(1 / 3.0, 1));
}

TEST_CASE("a quotient of finite numbers by nothing, or next to nothing, is 0") {
  Real denormal = Limits::min() / 4;
  for (Real a : {Real(0), Real(1), Real(-1), largest})
    for (Real b : {Real(0), Real(-0.0), denormal, -denormal}) {
      INFO(a << " / " << b);
      CHECK(call<anysl_div_float>(a, b) == 0);
    }
  CHECK(anysl::isNaN(call<anysl_div_float>(notANumber, 2)));
  CHECK(anysl::isNaN(call<anysl_div_float>(2, notANumber)));
  checkColor(call<anysl_div_color>(anysl_color(1, 2, 3), anysl_color(0, 2, 0)), 0, 1, 0);
  checkVector(call<anysl_div_vector>(anysl_vector(1, 2, 3), anysl_vector(0, 2, 0)), 0, 1, 0);
}

TEST_CASE("colours are computed component by component") {
  anysl_color a(1, 2, 3), b(4, -5, Real(0.5));
  checkColor(call<anysl_neg_color>(a), -1, -2, -3);
  checkColor(call<anysl_add_color>(a, b), 5, -3, 3.5);
  checkColor(call<anysl_sub_color>(a, b), -3, 7, 2.5);
  checkColor(call<anysl_mul_color>(a, b), 4, -10, 1.5);
  checkColor(call<anysl_div_color>(a, b), 0.25, -0.4, 6);
  checkColor(call<anysl_scale_color>(a, 2), 2, 4, 6);
}

TEST_CASE("vectors are computed component by component, and multiplied two ways") {
  anysl_vector a(1, 2, 3), b(4, -5, Real(0.5));
  checkVector(call<anysl_neg_vector>(a), -1, -2, -3);
  checkVector(call<anysl_add_vector>(a, b), 5, -3, 3.5);
  checkVector(call<anysl_sub_vector>(a, b), -3, 7, 2.5);
  checkVector(call<anysl_mul_vector>(a, b), 4, -10, 1.5);
  checkVector(call<anysl_div_vector>(a, b), 0.25, -0.4, 6);
  checkVector(call<anysl_scale_vector>(a, 2), 2, 4, 6);
  CHECK(call<anysl_dot>(a, b) == near(-4.5));
  checkVector(call<anysl_cross>(a, b), 16, 11.5, -13);
  checkVector(call<anysl_cross>(anysl_vector(1, 0, 0), anysl_vector(0, 1, 0)), 0, 0, 1);
}

TEST_CASE("a result may be its own operand") {
  anysl_vector a(1, 2, 3), b(4, -5, Real(0.5));
  use<anysl_cross>()(&a, &a, &b);
  checkVector(a, 16, 11.5, -13);
  anysl_matrix m = {{{1, 2, 0, 0}, {3, 4, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  use<anysl_mul_matrix>()(&m, &m, &m);
  checkMatrix(m, {{7, 10, 0, 0}, {15, 22, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}});
}

TEST_CASE("numbers are ordered, and NaN is unequal to all") {
  CHECK(call<anysl_lt_float>(1, 2));
  CHECK_FALSE(call<anysl_lt_float>(2, 2));
  CHECK(call<anysl_le_float>(2, 2));
  CHECK_FALSE(call<anysl_le_float>(3, 2));
  CHECK(call<anysl_gt_float>(3, 2));
  CHECK_FALSE(call<anysl_gt_float>(2, 2));
  CHECK(call<anysl_ge_float>(2, 2));
  CHECK_FALSE(call<anysl_ge_float>(1, 2));
  CHECK(call<anysl_eq_float>(2, 2));
  CHECK_FALSE(call<anysl_eq_float>(notANumber, notANumber));
  CHECK(call<anysl_ne_float>(notANumber, notANumber));
  CHECK_FALSE(call<anysl_ne_float>(2, 2));
}

TEST_CASE("values of several components are equal if all components are") {
  anysl_color color(1, 2, 3);
  anysl_vector vector(1, 2, 3);
  CHECK(call<anysl_eq_color>(color, color));
  CHECK_FALSE(call<anysl_ne_color>(color, color));
  CHECK(call<anysl_eq_vector>(vector, vector));
  CHECK_FALSE(call<anysl_ne_vector>(vector, vector));
  for (int k = 0; k < 3; ++k) {
    anysl_color otherColor(k == 0 ? 9 : 1, k == 1 ? 9 : 2, k == 2 ? 9 : 3);
    anysl_vector otherVector(k == 0 ? 9 : 1, k == 1 ? 9 : 2, k == 2 ? 9 : 3);
    CHECK_FALSE(call<anysl_eq_color>(color, otherColor));
    CHECK(call<anysl_ne_color>(color, otherColor));
    CHECK_FALSE(call<anysl_eq_vector>(vector, otherVector));
    CHECK(call<anysl_ne_vector>(vector, otherVector));
  }
  anysl_matrix m = {};
  CHECK(call<anysl_eq_matrix>(m, m));
  CHECK_FALSE(call<anysl_ne_matrix>(m, m));
  for (int k = 0; k < 16; ++k) {
    anysl_matrix other = m;
    other.m[k / 4][k % 4] = 1;
    CHECK_FALSE(call<anysl_eq_matrix>(m, other));
    CHECK(call<anysl_ne_matrix>(m, other));
  }
}

TEST_CASE("text is compared by content, and no text is the empty text") {
  char a[] = "shader", b[] = "shader";
  anysl_string first = a, second = b, longer = "shaders", empty = "", none = nullptr;
  CHECK(call<anysl_eq_string>(first, second));
  CHECK_FALSE(call<anysl_ne_string>(first, second));
  CHECK_FALSE(call<anysl_eq_string>(first, longer));
  CHECK_FALSE(call<anysl_eq_string>(longer, first));
  CHECK(call<anysl_ne_string>(first, empty));
  CHECK(call<anysl_eq_string>(empty, none));
  CHECK(call<anysl_ne_string>(none, first));
}
