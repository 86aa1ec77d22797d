//===-- test/unit/rsl/Literals.cpp - numbers and strings as values ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Literals.h"
#include <catch2/catch.hpp>

using namespace anysl::rsl;

TEST_CASE("escapes in strings") {
  CHECK(unquote(R"("\(a\|b\)\+\\.")") == "\\(a\\|b\\)\\+\\.");
  CHECK(unquote("\"plain\"") == "plain");
  CHECK(unquote("\"\"").empty());
  CHECK(unquote(R"("a\nb\t\"\\")") == "a\nb\t\"\\");
  CHECK(unquote(R"("\101\60x\q")") == "A0xq");
  CHECK(unquote(R"("cut\0off")") == "cut");
  CHECK(unquote(R"("end\)") == "end\\");
}

TEST_CASE("numbers") {
  double value = -1;
  CHECK((parseNumber("1.", value) && value == 1));
  CHECK((parseNumber(".5", value) && value == 0.5));
  CHECK((parseNumber("1e-3", value) && value == 1e-3));
  CHECK((parseNumber("0x1F", value) && value == 31));
  CHECK((parseNumber("007", value) && value == 7));
  CHECK_FALSE(parseNumber("1.2.3", value));
  CHECK_FALSE(parseNumber("", value));
}
