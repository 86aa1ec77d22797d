//===-- test/unit/runtimes/TextTest.cpp - operators that make and print text ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A renderer that notes what the operators ask of it.
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <anysl/standard/context.h>
#include <list>
#include <sstream>
#include <string>

namespace {

std::string describe(const char *format, uint32_t index, uint32_t type, const AnyslCell *value) {
  std::ostringstream text;
  text << format << '#' << index << ':' << type;
  int count = type == ANYSL_FLOAT            ? 1
              : type == ANYSL_MATRIX         ? 16
              : type && type != ANYSL_STRING ? 3
                                             : 0;
  for (int i = 0; i < count; ++i)
    text << ' ' << value[i].number;
  if (type == ANYSL_STRING)
    text << ' ' << value->string;
  return text.str();
}

const char *append(void *renderer, const char *text, const char *format, uint32_t index,
                   uint32_t type, const AnyslCell *value) {
  auto &kept = *static_cast<std::list<std::string> *>(renderer);
  kept.push_back(text + describe(format, index, type, value));
  return kept.back().c_str();
}

void printValue(void *renderer, const AnyslShadeArgs *, uint32_t point, const char *format,
                uint32_t index, uint32_t type, const AnyslCell *value) {
  static_cast<std::list<std::string> *>(renderer)->push_back(std::to_string(point) + ' ' +
                                                             describe(format, index, type, value));
}

int match(void *, const char *pattern, const char *text) { return std::string(pattern) == text; }

struct Point {
  std::list<std::string> asked;
  AnyslServices services = {};
  AnyslShadeArgs args = {};
  anysl_context context = {};

  Point() {
    services.append = append;
    services.print_value = printValue;
    services.match = match;
    args.services = &services;
    args.renderer = &asked;
    context.args = &args;
    context.point = 7;
  }
};

const Real number = 2.5;
const anysl_color color(1, 2, 3);
const anysl_vector vector(4, 5, 6);
const anysl_string string = "text", none = nullptr, format = "f", before = "b ";

anysl_matrix matrix() {
  anysl_matrix m;
  for (int k = 0; k < 16; ++k)
    m.m[k / 4][k % 4] = Real(k);
  return m;
}

} // namespace

TEST_CASE("text is appended to by the renderer") {
  Point point;
  anysl_matrix m = matrix();
  anysl_string result;
  use<anysl_append_float>()(&result, &point.context, &before, &format, 1, &number);
  CHECK(std::string(result) == "b f#1:1 2.5");
  use<anysl_append_color>()(&result, &point.context, &none, &format, 0, &color);
  CHECK(std::string(result) == "f#0:2 1 2 3");
  use<anysl_append_vector>()(&result, &point.context, &before, &format, 2, &vector);
  CHECK(std::string(result) == "b f#2:4 4 5 6");
  use<anysl_append_matrix>()(&result, &point.context, &before, &format, 0, &m);
  CHECK(std::string(result) == "b f#0:6 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15");
  use<anysl_append_string>()(&result, &point.context, &before, &format, 0, &string);
  CHECK(std::string(result) == "b f#0:7 text");
  use<anysl_append_rest>()(&result, &point.context, &before, &format, 3);
  CHECK(std::string(result) == "b f#3:0");
}

TEST_CASE("values are printed by the renderer, for their point") {
  Point point;
  anysl_matrix m = matrix();
  use<anysl_print_float>()(&point.context, &format, 0, &number);
  use<anysl_print_color>()(&point.context, &format, 1, &color);
  use<anysl_print_vector>()(&point.context, &format, 2, &vector);
  use<anysl_print_matrix>()(&point.context, &format, 3, &m);
  use<anysl_print_string>()(&point.context, &format, 4, &none);
  use<anysl_print_rest>()(&point.context, &format, 5);
  CHECK(point.asked == std::list<std::string>{"7 f#0:1 2.5", "7 f#1:2 1 2 3", "7 f#2:4 4 5 6",
                                              "7 f#3:6 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15",
                                              "7 f#4:7 ", "7 f#5:0"});
}

TEST_CASE("a pattern is matched by the renderer") {
  Point point;
  Real result;
  use<anysl_match>()(&result, &point.context, &string, &string);
  CHECK(result == 1);
  use<anysl_match>()(&result, &point.context, &string, &none);
  CHECK(result == 0);
}

TEST_CASE("a renderer is told what a shader leaves out") {
  Point point;
  static std::string told;
  use<anysl_warn>()(&point.context, &string); // no service
  point.services.warn = [](void *, const AnyslShadeArgs *, const char *text) { told += text; };
  use<anysl_warn>()(&point.context, &string);
  CHECK(told == "text");
}

TEST_CASE("without such services text stays as it is and nothing is printed") {
  Point point;
  point.services = {};
  anysl_string result;
  use<anysl_append_float>()(&result, &point.context, &string, &format, 0, &number);
  CHECK(std::string(result) == "text");
  use<anysl_append_rest>()(&result, &point.context, &none, &format, 0);
  CHECK(std::string(result).empty());
  use<anysl_print_float>()(&point.context, &format, 0, &number);
  use<anysl_print_rest>()(&point.context, &format, 1);
  Real found = 1;
  use<anysl_match>()(&found, &point.context, &string, &string);
  CHECK(found == 0);
}
