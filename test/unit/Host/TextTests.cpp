//===-- test/unit/Host/TextTests.cpp - text made while shading --------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Text.h"

#include "test/unit/Host/Fixture.h"
#include <clocale>
#include <limits>
#include <thread>
#include <vector>

using namespace anysl::host;

namespace {

struct Value {
  uint32_t type;
  std::vector<AnyslCell> cells;
};

Value number(double x) { return {ANYSL_FLOAT, {{x}}}; }
Value triple(uint32_t type, double x, double y, double z) { return {type, {{x}, {y}, {z}}}; }
Value text(const char *string) {
  AnyslCell cell;
  cell.string = string;
  return {ANYSL_STRING, {cell}};
}

/// As the operators of a call of format() ask for it.
std::string format(const char *format, std::vector<Value> values = {}) {
  std::string result;
  uint32_t index = 0;
  for (const Value &value : values)
    appendFormatted(result, format, index++, value.type, value.cells.data());
  appendFormatted(result, format, index, 0, nullptr);
  return result;
}

} // namespace

TEST_CASE("directives show values", "[host]") {
  CHECK(format("x") == "x");
  CHECK(format("") == "");
  CHECK(format("a%fb", {number(0.5)}) == "a0.500000b");
  CHECK(format("%g %e", {number(0.5), number(1)}) == "0.5 1.000000e+00");
  CHECK(format("%d %i|", {number(3.9), number(-3.9)}) == "3 -3|");
  CHECK(format("%p", {triple(ANYSL_NORMAL, 1, 2, -3)}) == "1.000000 2.000000 -3.000000");
  CHECK(format("<%s>", {text("wood")}) == "<wood>");
  Value matrix{ANYSL_MATRIX, std::vector<AnyslCell>(16)};
  CHECK(format("%.0m", {matrix}) == "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0");
}

TEST_CASE("flags, width and precision are C's", "[host]") {
  CHECK(format("%5.2f|", {number(0.5)}) == " 0.50|");
  CHECK(format("%-6.1f|%+d|%04d", {number(1), number(2), number(3)}) == "1.0   |+2|0003");
  CHECK(format("%.1c", {triple(ANYSL_COLOR, 1, 0.25, 0)}) == "1.0 0.2 0.0");
  CHECK(format("%6s|%.2s", {text("ab"), text("wood")}) == "    ab|wo");
  CHECK(format("%200.1f", {number(1)}).size() == 200);
  // Nobody wants a line of a gigabyte.
  CHECK(format("%999999999f", {number(1)}).size() == 999);
  CHECK(format("%.999999999f", {number(1)}).size() == 1001);
}

TEST_CASE("percent signs that are no directives", "[host]") {
  CHECK(format("100%%") == "100%");
  CHECK(format("%%%f%%", {number(1)}) == "%1.000000%");
  CHECK(format("%q %f %", {number(1)}) == "%q 1.000000 %");
  CHECK(format("%5") == "%5");
}

TEST_CASE("values and directives that do not belong together", "[host]") {
  CHECK(format("%f", {triple(ANYSL_COLOR, 1, 2, 3)}) == "1.000000 2.000000 3.000000");
  CHECK(format("%c", {number(1)}) == "1.000000");
  CHECK(format("%s", {number(1)}) == "1.000000");
  CHECK(format("%f", {text("a")}) == "a");
  CHECK(format("a%fb%sc", {number(1)}) == "a1.000000b%sc");
  CHECK(format("%%%sc") == "%%sc");
  CHECK(format("a%fb", {number(1), number(2)}) == "a1.000000b");
}

TEST_CASE("numbers of any size", "[host]") {
  CHECK(format("%d", {number(1e300)}) == "9200000000000000000");
  CHECK(format("%d", {number(-1e300)}) == "-9200000000000000000");
  CHECK(format("%d", {number(std::numeric_limits<double>::quiet_NaN())}) == "0");
  CHECK(format("%f", {number(1e300)}).size() == 301 + 7);
}

TEST_CASE("a renderer's locale does not change numbers", "[host]") {
  for (const char *name : {"de_DE.UTF-8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_NUMERIC, name))
      break;
  std::string shown = format("%f", {number(0.5)});
  std::setlocale(LC_NUMERIC, "C");
  CHECK(shown == "0.500000");
}

TEST_CASE("equal texts are one, whoever makes them", "[host]") {
  const char *first = intern("some text");
  std::string copy = "some text";
  CHECK(intern(copy) == first);
  CHECK(intern("some text ") != first);
  std::vector<const char *> made(64 * 8);
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < 64; ++i)
        made[t * 64 + i] = intern("thread " + std::to_string(i));
    });
  for (std::thread &thread : threads)
    thread.join();
  for (size_t i = 0; i < made.size(); ++i)
    CHECK(made[i] == made[i % 64]);
  CHECK(std::string(made[63]) == "thread 63");
}

TEST_CASE("patterns are POSIX basic regular expressions and three more operators", "[host]") {
  CHECK(matches("oo", "wood"));
  CHECK_FALSE(matches("^oo", "wood"));
  CHECK(matches("^w.*d$", "wood"));
  CHECK(matches("", "wood"));
  CHECK(matches("wo*d", "wd"));
  CHECK_FALSE(matches("wo\\+d", "wd"));
  CHECK(matches("wo\\+d", "wood"));
  CHECK(matches("^wo\\?d$", "wd"));
  CHECK_FALSE(matches("^wo\\?d$", "wood"));
  CHECK(matches("^\\(oak\\|wood\\)$", "oak"));
  CHECK_FALSE(matches("^\\(oak\\|wood\\)$", "oakwood"));
  CHECK(matches("o\\{2\\}", "wood"));
  CHECK(matches("[a-z][[:digit:]]", "x1"));
  // Without a backslash these are characters.
  CHECK(matches("a+b|c?(d)", "a+b|c?(d)"));
  CHECK_FALSE(matches("a+b", "aab"));
  CHECK(matches("\\(.\\)\\1", "wood"));
}

TEST_CASE("malformed patterns are found nowhere", "[host]") {
  for (const char *pattern :
       {"[", "\\(", "\\)", "\\", "a\\{2", "[[:nothing:]]", "\\(a\\)\\2", "a\\{2,1\\}"}) {
    INFO(pattern);
    CHECK_FALSE(matches(pattern, "a(]) [ \\ aa"));
    CHECK_FALSE(matches(pattern, "a")); // again, from what is kept
  }
  for (int i = 0; i < 300; ++i)
    CHECK(matches(std::to_string(i).c_str(), ("x" + std::to_string(i)).c_str()));
}

namespace {

struct Printed {
  std::vector<std::string> lines;
  static void print(void *renderer, const AnyslShadeArgs *, uint32_t point, const char *text) {
    static_cast<Printed *>(renderer)->lines.push_back(std::to_string(point) + ": " + text);
  }
};

} // namespace

TEST_CASE("points print whole lines, however their values come", "[host]") {
  Library library = open("soa-float");
  AnyslServices services = {};
  services.struct_size = sizeof services;
  services.print = Printed::print;
  Printed printed;
  Instance instance = instantiate(library.get(), &services, &printed);
  AnyslShadeArgs args;
  anysl_instance_fill_args(instance.get(), &args);
  const AnyslServices &completed = *args.services;
  REQUIRE(completed.print_value);
  auto put = [&](uint32_t point, uint32_t index, uint32_t type, double x) {
    AnyslCell cell{x};
    completed.print_value(&printed, &args, point, "a %g b %g c", index, type, &cell);
  };
  for (uint32_t index : {0u, 1u})
    for (uint32_t point : {3u, 5u, 4u})
      put(point, index, ANYSL_FLOAT, point + 10 * index);
  CHECK(printed.lines.empty());
  for (uint32_t point : {3u, 5u, 4u})
    put(point, 2, 0, 0);
  put(3, 0, 0, 0);
  CHECK(printed.lines == std::vector<std::string>{"3: a 3 b 13 c", "5: a 5 b 15 c", "4: a 4 b 14 c",
                                                  "3: a %g b %g c"});
}

TEST_CASE("an instance has libanysl's services where the renderer has none", "[host]") {
  Library library = open("soa-float");
  Instance instance = instantiate(library.get());
  AnyslShadeArgs args;
  anysl_instance_fill_args(instance.get(), &args);
  AnyslCell cell{2};
  const char *made = args.services->append(nullptr, "x", "%g", 0, ANYSL_FLOAT, &cell);
  CHECK(std::string(made) == "x2");
  CHECK(made == args.services->append(nullptr, "x", "%g", 0, ANYSL_FLOAT, &cell));
  CHECK(args.services->match(nullptr, "b*", "a") == 1);
  CHECK_FALSE(args.services->trace);
}
