//===-- test/unit/runtimes/ShadersTest.cpp - operators that call other shaders ----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <anysl/standard/context.h>
#include <string>

namespace {

/// Notes what was asked, gives each number twice its number and one more, and doubles texts.
int callMethod(void *renderer, const AnyslShadeArgs *, uint32_t point, const char *shader,
               AnyslMessage *message) {
  static std::string doubled;
  *static_cast<std::string *>(renderer) += std::to_string(point) + shader + "->" + message->what +
                                           std::to_string(message->number_count) + ' ';
  for (uint32_t i = 0; i < message->number_count; ++i)
    message->numbers[i] = 2 * message->numbers[i] + 1;
  for (uint32_t i = 0; i < message->text_count; ++i) {
    doubled = std::string(message->texts[i]) + message->texts[i];
    message->texts[i] = doubled.c_str();
  }
  return std::string(shader) == "known";
}

const char *shaderName(void *, const AnyslShadeArgs *, const char *category, uint32_t index) {
  return index == 1 ? category : nullptr;
}

struct Point {
  std::string asked;
  AnyslServices services = {};
  AnyslShadeArgs args = {};
  anysl_context context = {};
  anysl_float numbers[3] = {4, 5, 6};
  anysl_string texts[2] = {"ab", nullptr};

  Point() {
    services.call_method = callMethod;
    services.shader_name = shaderName;
    args.services = &services;
    args.renderer = &asked;
    context.args = &args;
    context.point = 7;
  }
};

const anysl_string known = "known", unknown = "unknown", method = "f(t)v", none = nullptr;

} // namespace

TEST_CASE("a method of another shader gets numbers and texts and changes them") {
  Point point;
  auto call = [&](const anysl_string &shader, const anysl_string &what, uint32_t numbers,
                  uint32_t texts) {
    return use<anysl_call_method>()(&point.context, &shader, &what, point.numbers, numbers,
                                    point.texts, texts);
  };
  CHECK(call(known, method, 2, 1));
  CHECK(point.asked == "7known->f(t)v2 ");
  CHECK(point.numbers[0] == 9);
  CHECK(point.numbers[1] == 11);
  CHECK(point.numbers[2] == 6);
  CHECK(std::string(point.texts[0]) == "abab");
  CHECK(point.texts[1] == nullptr);
  // Text that is not there is the empty text.
  CHECK_FALSE(call(unknown, none, 0, 2));
  CHECK(point.asked == "7known->f(t)v2 7unknown->0 ");
  CHECK(std::string(point.texts[1]).empty());
}

TEST_CASE("no shader is null, and without the service there is none") {
  Point point;
  auto call = [&](const anysl_string &shader) {
    return use<anysl_call_method>()(&point.context, &shader, &method, point.numbers, 3u,
                                    point.texts, 0u);
  };
  CHECK_FALSE(call(none));
  CHECK(point.asked.empty());
  point.services = {};
  CHECK_FALSE(call(known));
  CHECK(point.numbers[2] == 6);
}

TEST_CASE("the renderer lists the shaders of a category") {
  Point point;
  anysl_string result = nullptr;
  CHECK(use<anysl_shader_name>()(&result, &point.context, &known, 1));
  CHECK(std::string(result) == "known");
  CHECK(!use<anysl_shader_name>()(&result, &point.context, &none, 0));
  CHECK(std::string(result).empty());
  point.services = {};
  CHECK(!use<anysl_shader_name>()(&result, &point.context, &known, 1));
}
