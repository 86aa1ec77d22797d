//===-- test/unit/runtimes/ValuesTest.cpp - constants, copies, components ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <cstring>

TEST_CASE("constants become reals and text") {
  Real number;
  use<anysl_const_float>()(&number, 0.1);
  CHECK(number == Real(0.1));
  anysl_string text;
  use<anysl_const_string>()(&text, "rgb");
  CHECK(std::strcmp(text, "rgb") == 0);
}

TEST_CASE("triples are made of numbers and of each other") {
  checkColor(call<anysl_make_color>(1, 2, 3), 1, 2, 3);
  checkVector(call<anysl_make_vector>(1, 2, 3), 1, 2, 3);
  checkColor(call<anysl_splat_color>(Real(0.25)), 0.25, 0.25, 0.25);
  checkVector(call<anysl_splat_vector>(Real(0.25)), 0.25, 0.25, 0.25);
  checkColor(call<anysl_color_from_vector>(anysl_vector(1, 2, 3)), 1, 2, 3);
  checkVector(call<anysl_vector_from_color>(anysl_color(1, 2, 3)), 1, 2, 3);
}

TEST_CASE("a matrix is made row by row, or of a multiple of the identity") {
  checkMatrix(call<anysl_make_matrix>(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16),
              {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}});
  checkMatrix(call<anysl_splat_matrix>(3),
              {{3, 0, 0, 0}, {0, 3, 0, 0}, {0, 0, 3, 0}, {0, 0, 0, 3}});
}

TEST_CASE("a condition is 1 or 0") {
  Real x;
  use<anysl_float_from_test>()(&x, true);
  CHECK(x == 1);
  use<anysl_float_from_test>()(&x, false);
  CHECK(x == 0);
}

TEST_CASE("a copy is the same value") {
  CHECK(call<anysl_copy_float>(Real(7)) == 7);
  checkColor(call<anysl_copy_color>(anysl_color(1, 2, 3)), 1, 2, 3);
  checkVector(call<anysl_copy_vector>(anysl_vector(1, 2, 3)), 1, 2, 3);
  anysl_matrix m = {{{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}}};
  checkMatrix(call<anysl_copy_matrix>(m),
              {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}});
  const char *text = "text";
  CHECK(call<anysl_copy_string>(text) == text);
}

TEST_CASE("a component's index is floored and clamped") {
  anysl_color color(10, 20, 30);
  anysl_vector vector(10, 20, 30);
  struct {
    Real index;
    int component;
  } const cases[] = {{0, 0},          {1, 1},         {2, 2},        {Real(0.99), 0},
                     {Real(1.99), 1}, {Real(2.5), 2}, {3, 2},        {-1, 0},
                     {Real(-0.5), 0}, {largest, 2},   {-largest, 0}, {infinite, 2},
                     {notANumber, 0}};
  for (auto [index, component] : cases) {
    INFO("index " << index);
    CHECK(call<anysl_get_color>(color, index) == 10 * (component + 1));
    CHECK(call<anysl_get_vector>(vector, index) == 10 * (component + 1));

    anysl_color changedColor = color;
    anysl_vector changedVector = vector;
    Real x = 5;
    use<anysl_set_color>()(&changedColor, &index, &x);
    use<anysl_set_vector>()(&changedVector, &index, &x);
    checkColor(changedColor, component == 0 ? 5 : 10, component == 1 ? 5 : 20,
               component == 2 ? 5 : 30);
    checkVector(changedVector, component == 0 ? 5 : 10, component == 1 ? 5 : 20,
                component == 2 ? 5 : 30);
  }
}

TEST_CASE("a matrix element is found and set by clamped indices") {
  anysl_matrix m;
  for (int k = 0; k < 16; ++k)
    m.m[k / 4][k % 4] = Real(k);
  for (int row = -1; row < 6; ++row)
    for (int column = -1; column < 6; ++column) {
      int r = std::min(std::max(row, 0), 3), c = std::min(std::max(column, 0), 3);
      INFO(row << ", " << column);
      CHECK(call<anysl_get_matrix>(m, Real(row + 0.25), Real(column + 0.75)) == 4 * r + c);
      anysl_matrix changed = m;
      Real i(row), j(column), x(99);
      use<anysl_set_matrix>()(&changed, &i, &j, &x);
      for (int k = 0; k < 16; ++k)
        CHECK(changed.m[k / 4][k % 4] == (k == 4 * r + c ? 99 : k));
    }
}
