//===-- test/unit/runtimes/DualTest.cpp - derivatives of every operator -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Compiled for the reals that carry derivatives, also of second order. With double below, each
// operator that the table lists and the real defines is compared with central differences; so is
// one added later.
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <random>
#include <span>
#include <tuple>

using namespace anysl;
using Number = anysl_number;

// References are weak, so that the table can name operators which other modules define.
extern "C" {
#define STC_OP(id, name, ...) __attribute__((weak)) decltype(anysl_##name) anysl_##name;
#include <anysl/StcOps.def>
}

namespace {

constexpr bool isExact = sizeof(Number) == sizeof(double);

/// The plain numbers of a real, and which of them says how which other one changes.
struct Slope {
  int derivative, of;
  bool byV;
};
using Plain = PlainOf<anysl_float>;
constexpr int numberCount = sizeof(anysl_float) / sizeof(Plain);
constexpr Slope firstOrder[] = {{1, 0, false}, {2, 0, true}};
constexpr Slope secondOrder[] = {{1, 0, false}, {2, 0, true}, {3, 0, false}, {4, 3, false},
                                 {5, 3, true},  {6, 0, true}, {7, 6, false}, {8, 6, true}};
constexpr std::span<const Slope> slopes =
    numberCount == 9 ? std::span<const Slope>(secondOrder) : std::span<const Slope>(firstOrder);

double partOf(const anysl_float &x, int index) {
  return double(reinterpret_cast<const Plain *>(&x)[index]);
}

//===-- Every operator against differences ----------------------------------------------------===//

template <typename T>
constexpr bool isNumeric = std::is_same_v<T, anysl_float> || std::is_same_v<T, anysl_color> ||
                           std::is_same_v<T, anysl_vector> || std::is_same_v<T, anysl_matrix>;

template <typename T>
void flatten(T &value, std::vector<anysl_float *> &components) {
  auto *first = reinterpret_cast<anysl_float *>(&value);
  for (size_t i = 0; i < sizeof(T) / sizeof(anysl_float); ++i)
    components.push_back(first + i);
}

/// Where an operator is evaluated: each component of each operand, and how it changes with u and v.
struct Sample {
  std::vector<double> x, u, v;
  void resize(size_t n) { x.resize(n), u.resize(n), v.resize(n); }
};

/// All components after a call with the operands of a sample, moved by some steps of u and v.
template <typename... P>
std::vector<anysl_float> evaluate(void (*op)(P...), const Sample &at, double u, double v) {
  std::tuple<std::remove_const_t<std::remove_pointer_t<P>>...> operands;
  std::vector<anysl_float *> components;
  std::apply([&](auto &...operand) { (flatten(operand, components), ...); }, operands);
  for (size_t i = 0; i < components.size(); ++i)
    *components[i] = withDerivatives<anysl_float>(Number(at.x[i] + u * at.u[i] + v * at.v[i]),
                                                  Number(at.u[i]), Number(at.v[i]));
  std::apply([&](auto &...operand) { op(&operand...); }, operands);
  std::vector<anysl_float> result;
  for (anysl_float *component : components)
    result.push_back(*component);
  return result;
}

double difference(double above, double below, double step) { return (above - below) / (2 * step); }

/// Compares one derivative, where two steps agree on what it is. Gives whether they do.
bool compare(const char *name, double derivative, const double (&wide)[2], const double (&fine)[2],
             double step) {
  double d = difference(wide[0], wide[1], 2 * step), e = difference(fine[0], fine[1], step);
  double scale = std::max(1.0, std::abs(e));
  if (std::abs(d - e) > 1e-6 * scale)
    return false;
  if (!(std::abs(derivative - e) <= 2e-6 * scale))
    FAIL(name << ": the derivative is " << derivative << ", not " << e);
  return true;
}

template <typename... P>
  requires(isNumeric<std::remove_const_t<std::remove_pointer_t<P>>> && ...)
bool compareWithDifferences(const char *name, void (*op)(P...)) {
  constexpr size_t count = ((sizeof(std::remove_pointer_t<P>) / sizeof(anysl_float)) + ... + 0);
  constexpr double step = 1e-6;
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-1.9, 1.9);
  Sample at;
  at.resize(count);
  int smooth = 0, all = 0;
  for (int i = 0; i < 300; ++i) {
    for (size_t k = 0; k < count; ++k)
      at.x[k] = number(generator), at.u[k] = number(generator), at.v[k] = number(generator);
    auto dual = evaluate(op, at, 0, 0);
    for (bool byV : {false, true}) {
      auto moved = [&](double d) { return evaluate(op, at, byV ? 0 : d, byV ? d : 0); };
      auto a = moved(2 * step), b = moved(-2 * step), c = moved(step), d = moved(-step);
      for (const Slope &slope : slopes)
        for (size_t k = 0; k < count && slope.byV == byV; ++k) {
          ++all;
          smooth += compare(name, partOf(dual[k], slope.derivative),
                            {partOf(a[k], slope.of), partOf(b[k], slope.of)},
                            {partOf(c[k], slope.of), partOf(d[k], slope.of)}, step);
        }
    }
  }
  INFO(name << ": smooth at " << smooth << " of " << all);
  CHECK(smooth > 0.9 * all);
  return true;
}

/// Operators with operands of other kinds: of integers, texts, conditions, contexts.
bool compareWithDifferences(const char *, ...) { return false; }

} // namespace

TEST_CASE("derivatives agree with central differences") {
  if (!isExact)
    return;
  int compared = 0;
#define STC_OP(id, name, result, parameters, purity, rule, effect, ...)                            \
  if (std::string(#effect) != "Derivatives" && std::string(#name) != "detach_float" &&             \
      anysl_##name)                                                                                \
    compared += compareWithDifferences(#name, anysl_##name);
#include <anysl/StcOps.def>
  CHECK(compared > 100);
}

//===-- Single rules --------------------------------------------------------------------------===//

namespace {

/// x, changing as u does twice over and as v does backwards.
Real moving(Number x) { return withDerivatives<Real>(x, 2, -1); }

void checkSlope(const Real &y, double slope) {
  CHECK(derivativeU(y) == near(2 * slope, 32));
  CHECK(derivativeV(y) == near(-slope, 32));
}

} // namespace

TEST_CASE("elementary functions have their slopes") {
  const Number x = Number(0.7);
  const double y = x;
  checkSlope(call<anysl_sin>(moving(x)), std::cos(y));
  checkSlope(call<anysl_tan>(moving(x)), 1 / std::pow(std::cos(y), 2));
  checkSlope(call<anysl_asin>(moving(x)), 1 / std::sqrt(1 - y * y));
  checkSlope(call<anysl_atan>(moving(x)), 1 / (1 + y * y));
  checkSlope(call<anysl_exp>(moving(x)), std::exp(y));
  checkSlope(call<anysl_log>(moving(x)), 1 / y);
  checkSlope(call<anysl_inversesqrt>(moving(x)), -0.5 * std::pow(y, -1.5));
  checkSlope(call<anysl_pow>(moving(x), Real(3)), 3 * y * y);
  checkSlope(call<anysl_pow>(Real(3), moving(x)), std::log(3.0) * std::pow(3.0, y));
  // Both values and slopes of powers 0, 1 and 2, by x and by y.
  checkSlope(call<anysl_pow>(moving(x), Real(2)), 2 * y);
  checkSlope(call<anysl_pow>(moving(x), Real(1)), 1);
  checkSlope(call<anysl_pow>(Real(x), moving(2)), y * y * std::log(y));
  checkSlope(call<anysl_pow>(Real(x), moving(0)), std::log(y));
  checkSlope(math::sinh(moving(x)), std::cosh(y));
  checkSlope(math::cosh(moving(x)), std::sinh(y));
  checkSlope(math::tanh(moving(x)), 1 / std::pow(std::cosh(y), 2));
  checkSlope(math::exp2(moving(x)), std::log(2.0) * std::exp2(y));
  checkSlope(math::log2(moving(x)), 1 / (y * std::log(2.0)));
  checkSlope(math::log10(moving(x)), 1 / (y * std::log(10.0)));
  checkSlope(math::cbrt(moving(x)), std::pow(y, -2 / 3.0) / 3);
  checkSlope(math::reciprocal(moving(x)), -1 / (y * y));
  checkSlope(math::hypot(moving(x), Real(2)), y / std::hypot(y, 2));
  checkSlope(math::pow(moving(x), Real(5)), 5 * std::pow(y, 4));
}

TEST_CASE("the arc tangent of two numbers has the same slopes in every quadrant") {
  for (Number y : {-2, -1, 0, 1, 2})
    for (Number x : {-3, -1, 0, 1, 3}) {
      INFO("atan(" << y << ", " << x << ")");
      double square = double(x) * x + double(y) * y, inverse = square > 0 ? 1 / square : 0;
      checkSlope(call<anysl_atan2>(moving(y), Real(x)), x * inverse);
      checkSlope(call<anysl_atan2>(Real(y), moving(x)), -y * inverse);
    }
  const Number tiny = Number(1e-30);
  checkSlope(call<anysl_atan2>(moving(tiny), Real(-tiny)), -0.5e30);
}

TEST_CASE("at singular points derivatives are 0") {
  const Real zero = moving(0), one = moving(1), two(2), half = Number(0.5);
  const Real results[] = {call<anysl_sqrt>(zero),
                          call<anysl_sqrt>(moving(-1)),
                          call<anysl_inversesqrt>(zero),
                          call<anysl_log>(zero),
                          call<anysl_log>(moving(-1)),
                          call<anysl_acos>(one),
                          call<anysl_acos>(moving(-1)),
                          call<anysl_asin>(one),
                          call<anysl_acos>(moving(2)),
                          call<anysl_pow>(zero, half),
                          call<anysl_pow>(zero, two),
                          call<anysl_pow>(zero, zero),
                          call<anysl_pow>(zero, Real(-1)),
                          call<anysl_pow>(moving(-2), half),
                          call<anysl_div_float>(one, zero),
                          call<anysl_div_float>(zero, zero),
                          call<anysl_mod>(one, zero),
                          call<anysl_atan2>(zero, zero),
                          call<anysl_exp>(moving(1e6)),
                          call<anysl_pow>(moving(1e6), moving(1e6)),
                          call<anysl_length>(anysl_vector(zero, zero, zero)),
                          call<anysl_normalize>(anysl_vector(zero, zero, zero)).y};
  for (size_t i = 0; i < std::size(results); ++i) {
    INFO("number " << i);
    CHECK(derivativeU(results[i]) == 0);
    CHECK(derivativeV(results[i]) == 0);
    CHECK(isFinite(valueOf(results[i])));
  }
}

TEST_CASE("at kinks and jumps the derivative is that from one side") {
  checkSlope(call<anysl_abs>(moving(0)), 1);
  checkSlope(call<anysl_abs>(moving(-3)), -1);
  checkSlope(call<anysl_floor>(moving(2)), 0);
  checkSlope(call<anysl_ceil>(moving(Number(2.5))), 0);
  checkSlope(call<anysl_mod>(moving(2), Real(1)), 1);
  checkSlope(call<anysl_mod>(Real(Number(5.5)), moving(2)), -2);
  // Of equal operands the first counts.
  checkSlope(call<anysl_min_float>(moving(1), Real(1)), 1);
  checkSlope(call<anysl_min_float>(Real(1), moving(1)), 0);
  checkSlope(call<anysl_max_float>(moving(1), Real(1)), 1);
  checkSlope(call<anysl_max_float>(Real(1), moving(1)), 0);
}

TEST_CASE("lengths keep their derivatives at every size") {
  for (Number size : {Number(1e-30), Number(1), Number(1e30)}) {
    anysl_vector p(withDerivatives<Real>(3 * size, size, 0),
                   withDerivatives<Real>(4 * size, 0, size), Real(0));
    Real length = call<anysl_length>(p);
    CHECK(double(derivativeU(length)) / size == near(0.6));
    CHECK(double(derivativeV(length)) / size == near(0.8));
    anysl_vector n = call<anysl_normalize>(p);
    CHECK(derivativeU(n.x) == near((1 - 0.36) / 5));
    CHECK(derivativeU(n.y) == near(-0.48 / 5));
  }
}
