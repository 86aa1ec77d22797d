//===-- test/unit/Host/QueryTests.cpp - answers from values and from other shaders ------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/Host/Fixture.h"
#include <optional>
#include <vector>

namespace {

AnyslQuery asking(const char *name, uint32_t type, uint32_t length = 0, uint32_t element = 0) {
  AnyslQuery query = {};
  query.kind = ANYSL_QUERY_surface;
  query.type = type;
  query.array_length = length;
  query.element = element;
  query.name = name;
  query.subject = "";
  return query;
}

using Numbers = std::vector<double>;

Numbers numbers(const AnyslQuery &query, const AnyslCell *cells) {
  Numbers result;
  for (uint32_t i = 0; i < anysl_type_components(query.type); ++i)
    result.push_back(cells[i].number);
  return result;
}

/// What a variable gets of a value; nothing if it cannot take it.
std::optional<Numbers> answer(const AnyslQuery &query, uint32_t type, uint32_t length,
                              const std::vector<AnyslCell> &cells) {
  AnyslCell value[16];
  if (!anysl_answer(&query, type, length, cells.data(), value))
    return std::nullopt;
  return numbers(query, value);
}

std::optional<Numbers> ask(const Instance &instance, const AnyslQuery &query,
                           const AnyslShadeArgs *args = nullptr, uint32_t point = 0) {
  AnyslCell value[16];
  if (!anysl_instance_answer(instance.get(), args, point, &query, value))
    return std::nullopt;
  return numbers(query, value);
}

} // namespace

TEST_CASE("answers convert as assignments do", "[host]") {
  std::vector<AnyslCell> one = {{2}}, three = {{1}, {2}, {3}}, six = {{1}, {2}, {3}, {4}, {5}, {6}};
  CHECK(answer(asking("", ANYSL_FLOAT), ANYSL_FLOAT, 0, one) == Numbers{2});
  CHECK(answer(asking("", ANYSL_COLOR), ANYSL_FLOAT, 0, one) == Numbers{2, 2, 2});
  CHECK(answer(asking("", ANYSL_MATRIX), ANYSL_FLOAT, 0, one) ==
        Numbers{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2});
  CHECK(answer(asking("", ANYSL_VECTOR), ANYSL_COLOR, 0, three) == Numbers{1, 2, 3});
  CHECK(answer(asking("", ANYSL_COLOR), ANYSL_NORMAL, 0, three) == Numbers{1, 2, 3});
  CHECK_FALSE(answer(asking("", ANYSL_FLOAT), ANYSL_COLOR, 0, three));
  CHECK_FALSE(answer(asking("", ANYSL_STRING), ANYSL_FLOAT, 0, one));
  CHECK_FALSE(answer(asking("", ANYSL_FLOAT), ANYSL_STRING, 0, one));
  CHECK_FALSE(answer(asking("", ANYSL_COLOR), ANYSL_MATRIX, 0, six));
  // Arrays, element by element.
  CHECK(answer(asking("", ANYSL_FLOAT, 3, 1), ANYSL_FLOAT, 3, three) == Numbers{2});
  CHECK(answer(asking("", ANYSL_VECTOR, 2, 1), ANYSL_COLOR, 2, six) == Numbers{4, 5, 6});
  CHECK(answer(asking("", ANYSL_VECTOR, 3, 2), ANYSL_FLOAT, 3, three) == Numbers{3, 3, 3});
  CHECK_FALSE(answer(asking("", ANYSL_FLOAT, 2, 0), ANYSL_FLOAT, 3, three));
  CHECK_FALSE(answer(asking("", ANYSL_FLOAT), ANYSL_FLOAT, 3, three));
  CHECK_FALSE(answer(asking("", ANYSL_FLOAT, 1, 0), ANYSL_FLOAT, 0, one));
}

TEST_CASE("another shader's parameters are answers", "[host]") {
  Library library = open("soa-float");
  Instance instance = instantiate(library.get());
  double Kd = 0.25;
  REQUIRE(anysl_instance_set_numbers(instance.get(), "Kd", &Kd, 1) == ANYSL_OK);
  CHECK(ask(instance, asking("Kd", ANYSL_FLOAT)) == Numbers{0.25});
  CHECK(ask(instance, asking("Kd", ANYSL_COLOR)) == Numbers{0.25, 0.25, 0.25});
  CHECK(ask(instance, asking("tint", ANYSL_VECTOR)) == Numbers{0.25, 1, 0});
  CHECK(ask(instance, asking("weights", ANYSL_FLOAT, 3, 2)) == Numbers{3});
  CHECK_FALSE(ask(instance, asking("weights", ANYSL_FLOAT, 2, 1)));
  CHECK_FALSE(ask(instance, asking("nothing", ANYSL_FLOAT)));
  CHECK_FALSE(ask(instance, asking("tint", ANYSL_FLOAT)));
  AnyslCell text;
  AnyslQuery label = asking("label", ANYSL_STRING), name = asking("shadername", ANYSL_STRING);
  REQUIRE(anysl_instance_answer(instance.get(), nullptr, 0, &label, &text));
  CHECK(std::string(text.string) == "none");
  REQUIRE(anysl_instance_answer(instance.get(), nullptr, 0, &name, &text));
  CHECK(std::string(text.string) == "ramp");
}

TEST_CASE("what a shader has at a point is an answer in every layout and format", "[host]") {
  for (const char *name : {"soa-float", "soa-double", "aos-float", "aos-double"}) {
    INFO(name);
    Library library = open(name);
    Instance instance = instantiate(library.get());
    Batch batch = batchFor(instance.get(), 20);
    const AnyslShadeArgs *args = anysl_batch_args(batch.get());
    // Before anything is bound, the instance's own value.
    CHECK(ask(instance, asking("gain", ANYSL_FLOAT), args, 7) == Numbers{2});
    std::vector<double> gain(20), steps(40), s(20);
    for (int i = 0; i < 20; ++i)
      gain[i] = i, steps[2 * i + 1] = 100 + i, s[i] = 0.5;
    REQUIRE(anysl_batch_bind_double(batch.get(), "gain", 0, 20, gain.data(), 1) == ANYSL_OK);
    REQUIRE(anysl_batch_bind_double(batch.get(), "steps", 0, 20, steps.data(), 2) == ANYSL_OK);
    REQUIRE(anysl_batch_want_output(batch.get(), "doubled") == ANYSL_OK);
    REQUIRE(anysl_batch_write_double(batch.get(), ANYSL_s, 0, 20, s.data(), 1) == ANYSL_OK);
    REQUIRE(anysl_shade(instance.get(), batch.get(), 0, 20, 1) == ANYSL_OK);
    CHECK(ask(instance, asking("gain", ANYSL_FLOAT), args, 7) == Numbers{7});
    CHECK(ask(instance, asking("gain", ANYSL_COLOR), args, 19) == Numbers{19, 19, 19});
    CHECK(ask(instance, asking("steps", ANYSL_FLOAT, 2, 1), args, 3) == Numbers{103});
    CHECK(ask(instance, asking("steps", ANYSL_FLOAT, 2, 0), args, 3) == Numbers{0});
    CHECK_FALSE(ask(instance, asking("steps", ANYSL_FLOAT), args, 3));
    // doubled = 2 (gain tint s + steps[1]), where tint = (0.5, 1, 0)
    CHECK(ask(instance, asking("doubled", ANYSL_VECTOR), args, 4) ==
          Numbers{2 * (4 * 0.5 * 0.5 + 104), 2 * (4 * 1 * 0.5 + 104), 2 * 104});
    CHECK(ask(instance, asking("Kd", ANYSL_FLOAT), args, 4) == Numbers{0.5});
  }
}
