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

/// Notes what was asked, and gives each number twice its number and one more.
int callMethod(void *renderer, const AnyslShadeArgs *, uint32_t point, const char *shader,
               const char *method, double values[32]) {
  *static_cast<std::string *>(renderer) +=
      std::to_string(point) + shader + "->" + method + std::to_string(int(values[31])) + ' ';
  for (int i = 0; i < 32; ++i)
    values[i] = 2 * values[i] + 1;
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
  anysl_matrix a, b;

  Point() {
    services.call_method = callMethod;
    services.shader_name = shaderName;
    args.services = &services;
    args.renderer = &asked;
    context.args = &args;
    context.point = 7;
    for (int k = 0; k < 16; ++k) {
      a.m[k / 4][k % 4] = Real(k);
      b.m[k / 4][k % 4] = Real(16 + k);
    }
  }
};

const anysl_string known = "known", unknown = "unknown", method = "f(t)v", none = nullptr;

} // namespace

TEST_CASE("a method of another shader gets two matrices of numbers and changes them") {
  Point point;
  CHECK(use<anysl_call_method>()(&point.context, &known, &method, &point.a, &point.b));
  CHECK(point.asked == "7known->f(t)v31 ");
  CHECK(point.a.m[0][0] == 1);
  CHECK(point.a.m[2][1] == 19);
  CHECK(point.b.m[3][3] == 63);
  CHECK(!use<anysl_call_method>()(&point.context, &unknown, &none, &point.a, &point.b));
  CHECK(point.asked == "7known->f(t)v31 7unknown->63 ");
}

TEST_CASE("no shader is null, and without the service there is none") {
  Point point;
  CHECK(!use<anysl_call_method>()(&point.context, &none, &method, &point.a, &point.b));
  CHECK(point.asked.empty());
  point.services = {};
  CHECK(!use<anysl_call_method>()(&point.context, &known, &method, &point.a, &point.b));
  CHECK(point.a.m[2][1] == 9);
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
