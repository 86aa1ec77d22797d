//===-- test/unit/runtimes/IntervalTest.cpp - bounds contain what is exact --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The operators of this real, compared with those of the real mp, which are in a module of their
// own: operators have the same names in every real. Each operator that the table lists and the real
// defines is compared; so is one added later.
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <anysl/domain.h>
#include <anysl/mp.h>
#include <dlfcn.h>
#include <random>
#include <tuple>

using namespace anysl;

// References are weak, so that the table can name operators which other modules define.
extern "C" {
#define STC_OP(id, name, ...) __attribute__((weak)) decltype(anysl_##name) anysl_##name;
#include <anysl/StcOps.def>
}

namespace {

/// A function of the module with the real mp.
void *exactFunction(const std::string &name) {
  static void *module = dlopen(ANYSL_MP_MODULE, RTLD_NOW | RTLD_LOCAL);
  REQUIRE(module);
  return dlsym(module, name.c_str());
}

//===-- Operands ------------------------------------------------------------------------------===//

/// Numbers that shaders compute with, and those about which functions change their nature.
class Random {
public:
  float number() {
    switch (generator() % 8) {
    case 0:
      return float(int(generator() % 9) - 4); // on lattices, 0 among them
    case 1:
      return float(std::ldexp(uniform(-1, 1), int(generator() % 60) - 30));
    case 2:
      return float(uniform(-1, 1) * 1e-3 + (generator() % 3 - 1.0));
    case 3:
      return float(uniform(-300, 300));
    default:
      return float(uniform(-2, 2));
    }
  }
  /// A point, its neighbourhood, or more.
  Interval interval() {
    float x = number(), y = x;
    switch (generator() % 4) {
    case 0:
      break;
    case 1:
      y = bounds::nextAbove(x);
      break;
    case 2:
      y = x + std::abs(x) * 1e-5f;
      break;
    default:
      y = x + float(std::exp(uniform(-12, 1)));
    }
    return {x, y};
  }
  /// A number within bounds, often one of them.
  float inside(const Interval &x) {
    switch (generator() % 3) {
    case 0:
      return x.low;
    case 1:
      return x.high;
    default:
      float y = float(uniform(x.low, x.high));
      return y < x.low ? x.low : y > x.high ? x.high : y;
    }
  }
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  }

private:
  std::mt19937 generator{5};
};

bool contains(const Interval &bounds, double nearest) {
  // The nearest double of a number between two floats is between them too.
  return isNaN(bounds) || std::isnan(nearest) ||
         (double(bounds.low) <= nearest && nearest <= double(bounds.high));
}

//===-- Operators -----------------------------------------------------------------------------===//

template <typename T>
constexpr bool isNumeric = std::is_same_v<T, anysl_float> || std::is_same_v<T, anysl_color> ||
                           std::is_same_v<T, anysl_vector> || std::is_same_v<T, anysl_matrix>;

template <typename T>
constexpr size_t componentsOf = sizeof(T) / sizeof(anysl_float);

template <typename... P>
  requires(isNumeric<std::remove_const_t<std::remove_pointer_t<P>>> && ...)
bool compareWithExact(const char *name, void (*op)(P...)) {
  void *exactOp = exactFunction(std::string("anysl_") + name);
  if (!exactOp)
    return false;
  constexpr size_t sizes[] = {componentsOf<std::remove_pointer_t<P>>...};
  constexpr size_t count = (componentsOf<std::remove_pointer_t<P>> + ... + 0);
  std::vector<Interval> known(count);
  std::vector<Mp> exact(count);
  Random random;
  for (int i = 0; i < 3000; ++i) {
    std::vector<Interval> operands(count);
    for (Interval &x : operands)
      x = random.interval();
    known = operands;
    auto at = [&](auto &components, size_t parameter) {
      size_t first = 0;
      for (size_t k = 0; k < parameter; ++k)
        first += sizes[k];
      return &components[first];
    };
    [&]<size_t... K>(std::index_sequence<K...>) {
      op(reinterpret_cast<P>(at(known, K))...);
      for (int sample = 0; sample < 3; ++sample) {
        for (size_t k = 0; k < count; ++k)
          exact[k] = Mp(random.inside(operands[k]));
        std::vector<Mp> before = exact;
        reinterpret_cast<void (*)(decltype((void)K, (void *)nullptr)...)>(exactOp)(at(exact, K)...);
        for (size_t k = 0; k < count; ++k)
          if (!contains(known[k], double(exact[k]))) {
            std::string text;
            for (size_t j = 0; j < count; ++j)
              text += " " + std::to_string(double(before[j])) + " in [" +
                      std::to_string(operands[j].low) + ", " + std::to_string(operands[j].high) +
                      "]";
            FAIL(name << ": component " << k << " is " << double(exact[k]) << ", not in ["
                      << known[k].low << ", " << known[k].high << "], of" << text);
          }
      }
    }(std::make_index_sequence<sizeof...(P)>());
  }
  return true;
}

/// Operators with operands of other kinds: of integers, texts, conditions, contexts.
bool compareWithExact(const char *, ...) { return false; }

} // namespace

TEST_CASE("bounds contain what exact arithmetic gives, for every operator") {
  int compared = 0;
#define STC_OP(id, name, ...)                                                                      \
  if (anysl_##name)                                                                                \
    compared += compareWithExact(#name, anysl_##name);
#include <anysl/StcOps.def>
  CHECK(compared > 100);
}

//===-- Elementary functions ------------------------------------------------------------------===//

namespace {

using Unary = void (*)(Mp *, const Mp *);
using Binary = void (*)(Mp *, const Mp *, const Mp *);

template <typename F>
void compareFunction(const char *name, F &&f) {
  auto exactOf = reinterpret_cast<Unary>(exactFunction(std::string("anysl_mp_") + name));
  REQUIRE(exactOf);
  Random random;
  for (int i = 0; i < 20000; ++i) {
    Interval x = random.interval(), y = f(x);
    Mp exact, at = random.inside(x);
    exactOf(&exact, &at);
    if (!contains(y, double(exact)))
      FAIL(name << "(" << double(at) << ") = " << double(exact) << " is not in [" << y.low << ", "
                << y.high << "], of [" << x.low << ", " << x.high << "]");
  }
}

template <typename F>
void compareFunctionOfTwo(const char *name, F &&f) {
  auto exactOf = reinterpret_cast<Binary>(exactFunction(std::string("anysl_mp_") + name));
  REQUIRE(exactOf);
  Random random;
  for (int i = 0; i < 20000; ++i) {
    Interval x = random.interval(), y = random.interval(), z = f(x, y);
    Mp exact, a = random.inside(x), b = random.inside(y);
    exactOf(&exact, &a, &b);
    if (!contains(z, double(exact)))
      FAIL(name << "(" << double(a) << ", " << double(b) << ") = " << double(exact)
                << " is not in [" << z.low << ", " << z.high << "]");
  }
}

} // namespace

TEST_CASE("bounds contain what exact arithmetic gives, for every elementary function") {
#define MATH_UNARY(name, ...)                                                                      \
  compareFunction(#name, [](const Interval &x) { return math::name(x); });
#define MATH_BINARY(name, ...)                                                                     \
  compareFunctionOfTwo(#name,                                                                      \
                       [](const Interval &x, const Interval &y) { return math::name(x, y); });
#include <anysl/MathFunctions.def>
}

//===-- How tight -----------------------------------------------------------------------------===//

TEST_CASE("bounds of exact results are these, and others are two neighbours") {
  Interval three = call<anysl_add_float>(Real(1), Real(2));
  CHECK(three.isPoint());
  CHECK(call<anysl_mul_float>(Real(0.5f), Real(3)).isPoint());
  CHECK(call<anysl_div_float>(Real(3), Real(4)).isPoint());
  CHECK(call<anysl_sqrt>(Real(9)).isPoint());
  CHECK(call<anysl_floor>(Real(2.5f)).isPoint());
  for (Interval x : {call<anysl_div_float>(Real(1), Real(3)), call<anysl_sqrt>(Real(2)),
                     call<anysl_sin>(Real(1)), call<anysl_exp>(Real(1)), Interval(0.1)}) {
    CHECK(!x.isPoint());
    CHECK(bounds::nextAbove(x.low) == x.high);
  }
  CHECK(call<anysl_sin>(Interval(0.0f, 100.0f)).high == 1);
  CHECK(call<anysl_min_float>(Interval(0.0f, 1.0f), Interval(0.5f, 3.0f)).high == 1);
}

TEST_CASE("digits that cancel are seen") {
  // 1 - cos(x) of a small x: nothing is left.
  Interval x = call<anysl_sub_float>(Real(1), call<anysl_cos>(Real(1e-4f)));
  CHECK(x.halfWidth() > 0.5 * std::abs(x.middle()));
}

TEST_CASE("comparisons are certain, or go by the middles") {
  Interval low(0.0f, 1.0f), high(0.5f, 4.0f), above(2.0f, 3.0f);
  CHECK((low < above).isKnown());
  CHECK((low < above));
  CHECK((above < low).isKnown());
  CHECK_FALSE((above < low));
  CHECK_FALSE((low < high).isKnown());
  CHECK(call<anysl_lt_float>(low, high));
  CHECK_FALSE((low == low).isKnown());
  CHECK((Interval(1) == Interval(1)).isKnown());
  CHECK((Interval(1) != above).isKnown());
  Truth unknown = low < high, known = low < above;
  CHECK_FALSE((unknown & known).isKnown());
  CHECK((unknown | known).isKnown());
  CHECK((unknown & !known).isKnown());
}

TEST_CASE("noise has room for all cells that a point may be in") {
  Interval cell = call<anysl_cellnoise_float_1>(Interval(0.9f, 1.1f));
  CHECK(contains(cell, plain(call<anysl_cellnoise_float_1>(Real(0.5f)))));
  CHECK(contains(cell, plain(call<anysl_cellnoise_float_1>(Real(1.5f)))));
  CHECK(call<anysl_cellnoise_float_1>(Interval(0.25f, 0.75f)).isPoint());
  Interval wide = call<anysl_noise_float_1>(Interval(0.0f, 9.0f));
  CHECK(wide.low == 0);
  CHECK(wide.high == 1);
  // Across a plane of the lattice, where noise is smooth, bounds stay close.
  CHECK(call<anysl_noise_float_1>(Interval(2.9999998f, 3.0000002f)).halfWidth() < 1e-5);
}
