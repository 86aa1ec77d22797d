//===-- test/unit/Host/InstanceTests.cpp - parameters by name ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/Host/Fixture.h"
#include <vector>

namespace {

std::vector<double> numbers(const Instance &instance, const char *name, size_t count) {
  std::vector<double> values(count);
  INFO(name);
  REQUIRE(anysl_instance_get_numbers(instance.get(), name, values.data(), count) == ANYSL_OK);
  return values;
}

AnyslStatus set(const Instance &instance, const char *name, std::vector<double> values) {
  return anysl_instance_set_numbers(instance.get(), name, values.data(), values.size());
}

using Numbers = std::vector<double>;

} // namespace

TEST_CASE("parameters start with their defaults", "[host]") {
  Library library = open("soa-float");
  Instance instance = instantiate(library.get());
  CHECK(numbers(instance, "Kd", 1) == Numbers{0.5});
  CHECK(numbers(instance, "tint", 3) == Numbers{0.5, 1, 0});
  CHECK(numbers(instance, "weights", 3) == Numbers{1, 2, 3});
  const char *label;
  REQUIRE(anysl_instance_get_strings(instance.get(), "label", &label, 1) == ANYSL_OK);
  CHECK(std::string(label) == "none");
}

TEST_CASE("a default follows the parameter it is computed from", "[host]") {
  Library library = open("soa-float");
  Instance instance = instantiate(library.get());
  CHECK(set(instance, "Kd", {0.25}) == ANYSL_OK);
  CHECK(numbers(instance, "tint", 3) == Numbers{0.25, 1, 0});
  CHECK(set(instance, "tint", {1, 2, 3}) == ANYSL_OK);
  CHECK(set(instance, "Kd", {0.75}) == ANYSL_OK);
  CHECK(numbers(instance, "tint", 3) == Numbers{1, 2, 3});
  CHECK(anysl_instance_unset(instance.get(), "tint") == ANYSL_OK);
  CHECK(numbers(instance, "tint", 3) == Numbers{0.75, 1, 0});
}

TEST_CASE("one number spreads as the shading language would", "[host]") {
  Library library = open("soa-float");
  Instance instance = instantiate(library.get());
  CHECK(set(instance, "tint", {0.5}) == ANYSL_OK);
  CHECK(numbers(instance, "tint", 3) == Numbers{0.5, 0.5, 0.5});
  CHECK(set(instance, "m", {2}) == ANYSL_OK);
  CHECK(numbers(instance, "m", 16) == Numbers{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2});
}

TEST_CASE("texts are copied", "[host]") {
  Library library = open("soa-float");
  Instance instance = instantiate(library.get());
  {
    std::string text = "a text long enough for the heap, which goes away at once";
    const char *value = text.c_str();
    REQUIRE(anysl_instance_set_strings(instance.get(), "label", &value, 1) == ANYSL_OK);
  }
  const char *label;
  REQUIRE(anysl_instance_get_strings(instance.get(), "label", &label, 1) == ANYSL_OK);
  CHECK(std::string(label) == "a text long enough for the heap, which goes away at once");
  CHECK(anysl_instance_unset(instance.get(), "label") == ANYSL_OK);
  REQUIRE(anysl_instance_get_strings(instance.get(), "label", &label, 1) == ANYSL_OK);
  CHECK(std::string(label) == "none");
}

TEST_CASE("wrong values are refused and change nothing", "[host]") {
  Library library = open("soa-float");
  Instance instance = instantiate(library.get());
  CHECK(set(instance, "Kq", {1}) == ANYSL_ERROR_NAME);
  CHECK(message() ==
        "soa-float.so: shader 'ramp': no parameter 'Kq'; it has Kd, tint, label, weights, "
        "gain, doubled, m, steps, fixed");
  CHECK(set(instance, "tint", {1, 2}) == ANYSL_ERROR_TYPE);
  CHECK(message() ==
        "soa-float.so: shader 'ramp': parameter 'tint' is a color and takes 3 values, not 2");
  CHECK(set(instance, "Kd", {1, 2, 3}) == ANYSL_ERROR_TYPE);
  CHECK(message() ==
        "soa-float.so: shader 'ramp': parameter 'Kd' is a float and takes 1 value, not 3");
  CHECK(set(instance, "weights", {1}) == ANYSL_ERROR_TYPE);
  CHECK(message() ==
        "soa-float.so: shader 'ramp': parameter 'weights' is a float[3] and takes 3 values, not 1");
  CHECK(set(instance, "label", {1}) == ANYSL_ERROR_TYPE);
  CHECK(message() == "soa-float.so: shader 'ramp': parameter 'label' is a string, not a number");
  const char *text = "red";
  CHECK(anysl_instance_set_strings(instance.get(), "tint", &text, 1) == ANYSL_ERROR_TYPE);
  CHECK(message() == "soa-float.so: shader 'ramp': parameter 'tint' is a color, not text");
  CHECK(set(instance, "fixed", {1}) == ANYSL_ERROR_STATE);
  CHECK(message() ==
        "soa-float.so: shader 'ramp': parameter 'fixed' was fixed when the library was linked");
  CHECK(numbers(instance, "fixed", 1) == Numbers{7});
  CHECK(numbers(instance, "tint", 3) == Numbers{0.5, 1, 0});
  double value;
  CHECK(anysl_instance_get_numbers(instance.get(), "tint", &value, 1) == ANYSL_ERROR_TYPE);
  CHECK(anysl_instance_unset(instance.get(), "Kq") == ANYSL_ERROR_NAME);
}

TEST_CASE("an instance needs a shader and services of the right version", "[host]") {
  Library library = open("soa-float");
  AnyslInstance *instance = nullptr;
  CHECK(anysl_instance_create(library.get(), "rump", nullptr, nullptr, &instance) ==
        ANYSL_ERROR_NAME);
  AnyslServices services = {};
  services.struct_size = 8;
  CHECK(anysl_instance_create(library.get(), "ramp", &services, nullptr, &instance) ==
        ANYSL_ERROR_VERSION);
  CHECK(message() ==
        "soa-float.so: the renderer's AnyslServices is of another version: its struct_size "
        "is 8, not " +
            std::to_string(sizeof(AnyslServices)));
  CHECK(instance == nullptr);
}
