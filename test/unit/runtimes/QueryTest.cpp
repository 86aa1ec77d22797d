//===-- test/unit/runtimes/QueryTest.cpp - operators that ask by name -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <anysl/standard/context.h>
#include <string>

namespace {

/// A renderer that knows one name, and notes how it was asked.
struct Point {
  AnyslQuery last = {};
  uint32_t point = 99;
  AnyslServices services = {};
  AnyslShadeArgs args = {};
  anysl_context context = {};

  Point() {
    services.query = answer;
    args.services = &services;
    args.renderer = this;
    context.args = &args;
    context.point = 7;
  }

  static int answer(void *renderer, const AnyslShadeArgs *, uint32_t point, const AnyslQuery *query,
                    AnyslCell *value) {
    auto &self = *static_cast<Point *>(renderer);
    self.last = *query;
    self.point = point;
    if (std::string(query->name) != "known")
      return 0;
    uint32_t count = query->type == ANYSL_FLOAT ? 1 : query->type == ANYSL_MATRIX ? 16 : 3;
    if (query->type == ANYSL_STRING)
      value->string = "text";
    else
      for (uint32_t i = 0; i < count; ++i)
        value[i].number = i + 1;
    return 1;
  }
};

const anysl_string known = "known", unknown = "unknown", none = nullptr, file = "wood.tex";

} // namespace

TEST_CASE("a variable is set to the answer, or left alone") {
  Point point;
  Real x = 9;
  CHECK(
      use<anysl_query_float>()(&point.context, ANYSL_QUERY_attribute, 0, &none, &known, 0, 0, &x));
  CHECK(x == 1);
  CHECK_FALSE(use<anysl_query_float>()(&point.context, ANYSL_QUERY_attribute, 0, &none, &unknown, 0,
                                       0, &x));
  CHECK(x == 1);
  anysl_color color(9, 9, 9);
  CHECK_FALSE(
      use<anysl_query_color>()(&point.context, ANYSL_QUERY_surface, 0, &none, &none, 0, 0, &color));
  checkColor(color, 9, 9, 9);
  CHECK(use<anysl_query_color>()(&point.context, ANYSL_QUERY_surface, 0, &none, &known, 0, 0,
                                 &color));
  checkColor(color, 1, 2, 3);
  anysl_vector vector(9, 9, 9);
  CHECK(use<anysl_query_vector>()(&point.context, ANYSL_QUERY_option, 0, &none, &known, 0, 0,
                                  &vector));
  checkVector(vector, 1, 2, 3);
  anysl_matrix matrix;
  for (uint32_t kind : {ANYSL_QUERY_option, ANYSL_QUERY_rayinfo}) {
    for (int k = 0; k < 16; ++k)
      matrix.m[k / 4][k % 4] = 9;
    CHECK_FALSE(use<anysl_query_matrix>()(&point.context, kind, 0, &none, &unknown, 0, 0, &matrix));
    CHECK(matrix.m[3][3] == 9);
    CHECK(use<anysl_query_matrix>()(&point.context, kind, 0, &none, &known, 0, 0, &matrix));
    checkMatrix(matrix, {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}});
  }
  for (uint32_t kind : {ANYSL_QUERY_rendererinfo, ANYSL_QUERY_lightsource}) {
    anysl_string text = "before";
    CHECK_FALSE(use<anysl_query_string>()(&point.context, kind, 0, &none, &unknown, 0, 0, &text));
    CHECK(std::string(text) == "before");
    CHECK(use<anysl_query_string>()(&point.context, kind, 0, &none, &known, 0, 0, &text));
    CHECK(std::string(text) == "text");
  }
}

TEST_CASE("a question says what it is about, and varying ones which point asks") {
  Point point;
  Real x;
  use<anysl_query_float>()(&point.context, ANYSL_QUERY_textureinfo, 0, &file, &known, 3, 2, &x);
  CHECK(point.point == 0);
  CHECK(point.last.kind == ANYSL_QUERY_textureinfo);
  CHECK(point.last.type == ANYSL_FLOAT);
  CHECK(point.last.array_length == 3);
  CHECK(point.last.element == 2);
  CHECK(std::string(point.last.subject) == "wood.tex");
  use<anysl_query_float>()(&point.context, ANYSL_QUERY_lightsource, 5, &none, &known, 0, 0, &x);
  CHECK(point.point == 7);
  CHECK(point.last.light == 5);
  CHECK(std::string(point.last.subject).empty());
}

TEST_CASE("a renderer without answers knows nothing") {
  Point point;
  point.services = {};
  Real x = 4;
  CHECK_FALSE(
      use<anysl_query_float>()(&point.context, ANYSL_QUERY_option, 0, &none, &known, 0, 0, &x));
  CHECK_FALSE(
      use<anysl_query_float>()(&point.context, ANYSL_QUERY_surface, 0, &none, &known, 0, 0, &x));
  CHECK(x == 4);
}

TEST_CASE("an array is as long as the answers, and as there is room for") {
  Point point;
  point.services.query = [](void *, const AnyslShadeArgs *, uint32_t asking,
                            const AnyslQuery *query, AnyslCell *value) {
    CHECK((query->array_length == ANYSL_ANY_LENGTH && asking == 0));
    if (query->element >= 3 || std::string(query->name) != "known")
      return 0;
    if (query->type == ANYSL_STRING)
      value->string = "abc" + query->element;
    else
      for (uint32_t c = 0; c < 3; ++c)
        value[c].number = 10 * query->element + c;
    return 1;
  };
  anysl_float numbers[8] = {9, 9, 9, 9, 9, 9, 9, 9};
  anysl_string texts[4] = {"", "", "", "old"};
  auto ask = [&](const anysl_string &name, anysl_string shape, uint32_t count, uint32_t words) {
    return use<anysl_query_array>()(&point.context, ANYSL_QUERY_attribute, &none, &name, &shape,
                                    numbers, count, texts, words);
  };
  CHECK_FALSE(ask(unknown, "f*7", 8, 0));
  CHECK(numbers[0] == 9);
  CHECK(ask(known, "f*7", 8, 0));
  CHECK((numbers[0] == 3 && numbers[1] == 0 && numbers[3] == 20 && numbers[4] == 9));
  CHECK(ask(known, "t*2", 7, 0));
  CHECK((numbers[0] == 2 && numbers[4] == 10 && numbers[6] == 12 && numbers[7] == 9));
  CHECK(ask(known, "s*4", 1, 4));
  CHECK(numbers[0] == 3);
  CHECK((std::string(texts[0]) == "abc" && std::string(texts[2]) == "c" &&
         std::string(texts[3]) == "old"));
  point.services = {};
  CHECK_FALSE(ask(known, "f*7", 8, 0));
}
