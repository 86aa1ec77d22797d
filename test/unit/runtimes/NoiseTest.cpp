//===-- test/unit/runtimes/NoiseTest.cpp - what noise promises --------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Operators.h"
#include <random>
#include <vector>

namespace {

using Coordinates = std::array<Real, 4>;

/// Every form of a family through one signature: the channels of form (dimension, type).
template <auto F1, auto F2, auto F3, auto F4>
std::vector<Real> ask(int dimension, const Coordinates &c) {
  anysl_vector p(c[0], c[1], c[2]);
  auto list = [](const auto &v) {
    if constexpr (std::is_same_v<decltype(v), const Real &>)
      return std::vector<Real>{v};
    else if constexpr (std::is_same_v<decltype(v), const anysl_color &>)
      return std::vector<Real>{v.r, v.g, v.b};
    else
      return std::vector<Real>{v.x, v.y, v.z};
  };
  switch (dimension) {
  case 1:
    return list(call<F1>(c[0]));
  case 2:
    return list(call<F2>(c[0], c[1]));
  case 3:
    return list(call<F3>(p));
  default:
    return list(call<F4>(p, c[3]));
  }
}

#define FORMS(family, type)                                                                        \
  ask<anysl_##family##_##type##_1, anysl_##family##_##type##_2, anysl_##family##_##type##_3,       \
      anysl_##family##_##type##_4>

using Form = std::vector<Real> (*)(int, const Coordinates &);
const Form noiseForms[] = {FORMS(noise, float), FORMS(noise, color), FORMS(noise, vector)};
const Form cellForms[] = {FORMS(cellnoise, float), FORMS(cellnoise, color),
                          FORMS(cellnoise, vector)};

std::vector<Real> periodic(int type, int dimension, const Coordinates &c,
                           const Coordinates &period) {
  anysl_vector p(c[0], c[1], c[2]), q(period[0], period[1], period[2]);
  auto ofType = [&](auto f1, auto f2, auto f3, auto f4) {
    auto list = [](auto v) {
      if constexpr (std::is_same_v<decltype(v), Real>)
        return std::vector<Real>{v};
      else if constexpr (std::is_same_v<decltype(v), anysl_color>)
        return std::vector<Real>{v.r, v.g, v.b};
      else
        return std::vector<Real>{v.x, v.y, v.z};
    };
    switch (dimension) {
    case 1:
      return list(apply(f1, c[0], period[0]));
    case 2:
      return list(apply(f2, c[0], c[1], period[0], period[1]));
    case 3:
      return list(apply(f3, p, q));
    default:
      return list(apply(f4, p, c[3], q, period[3]));
    }
  };
  if (type == 0)
    return ofType(use<anysl_pnoise_float_1>(), use<anysl_pnoise_float_2>(),
                  use<anysl_pnoise_float_3>(), use<anysl_pnoise_float_4>());
  if (type == 1)
    return ofType(use<anysl_pnoise_color_1>(), use<anysl_pnoise_color_2>(),
                  use<anysl_pnoise_color_3>(), use<anysl_pnoise_color_4>());
  return ofType(use<anysl_pnoise_vector_1>(), use<anysl_pnoise_vector_2>(),
                use<anysl_pnoise_vector_3>(), use<anysl_pnoise_vector_4>());
}

class Random {
public:
  Real in(double low, double high) {
    return Real(std::uniform_real_distribution<double>(low, high)(generator));
  }
  Coordinates point(double low, double high) {
    return {in(low, high), in(low, high), in(low, high), in(low, high)};
  }

private:
  std::mt19937 generator{42};
};

} // namespace

TEST_CASE("noise is one half on the lattice, negative and huge coordinates included") {
  for (Form form : noiseForms)
    for (int dimension = 1; dimension <= 4; ++dimension)
      for (Real k : {Real(0), Real(-1), Real(-2), Real(5), Real(1000003), Real(1e30), Real(-1e30)})
        for (Real value : form(dimension, {k, k + 1, Real(3), Real(-7)}))
          CHECK(value == 0.5);
}

TEST_CASE("noise lies in [0, 1], centred, spread, and different in each channel") {
  Random random;
  for (Form form : noiseForms)
    for (int dimension = 1; dimension <= 4; ++dimension) {
      const int samples = 20000;
      double sum[3] = {}, square[3] = {}, product = 0;
      double low = 1, high = 0;
      for (int i = 0; i < samples; ++i) {
        std::vector<Real> v = form(dimension, random.point(-1000, 1000));
        for (size_t k = 0; k < v.size(); ++k) {
          double x = plain(v[k]);
          sum[k] += x, square[k] += x * x;
          low = std::min(low, x), high = std::max(high, x);
        }
        if (v.size() == 3)
          product += plain((v[0] - 0.5) * (v[1] - 0.5));
      }
      INFO("dimension " << dimension);
      CHECK(low >= 0);
      CHECK(high <= 1);
      CHECK(low < 0.25);
      CHECK(high > 0.75);
      double mean = sum[0] / samples, variance = square[0] / samples - mean * mean;
      CHECK(mean == Approx(0.5).margin(0.01));
      CHECK(variance > 0.005);
      CHECK(std::abs(product / samples) < 0.05 * variance + 0.001);
    }
}

TEST_CASE("noise is smooth, across cells too") {
  Random random;
  const double h = sizeof(Real) == 4 ? 1e-3 : 1e-5;
  for (int dimension = 1; dimension <= 4; ++dimension)
    for (int i = 0; i < 4000; ++i) {
      Coordinates c = random.point(-4, 4);
      if (i % 2)
        c[i / 2 % dimension] = Real(std::round(plain(c[i / 2 % dimension])));
      Coordinates before = c, after = c;
      Real &below = before[i / 2 % dimension], &above = after[i / 2 % dimension];
      below = below - Real(h), above = above + Real(h);
      auto noise = [&](const Coordinates &at) { return plain(noiseForms[0](dimension, at)[0]); };
      double middle = noise(c);
      double difference = noise(after) - noise(before);
      double bend = noise(after) + noise(before) - 2 * middle;
      REQUIRE(std::abs(difference) < 8 * h);
      REQUIRE(std::abs(bend) < 40 * h * h + 4 * spacing);
    }
}

TEST_CASE("the first channel of colour noise is float noise") {
  Random random;
  for (int dimension = 1; dimension <= 4; ++dimension) {
    Coordinates c = random.point(-9, 9);
    CHECK(noiseForms[1](dimension, c)[0] == noiseForms[0](dimension, c)[0]);
    CHECK(noiseForms[2](dimension, c) == noiseForms[1](dimension, c));
  }
}

TEST_CASE("cell noise is constant on [n, n + 1), with a true floor") {
  for (Form form : cellForms)
    for (int dimension = 1; dimension <= 4; ++dimension)
      for (int n : {-3, -2, -1, 0, 1, 2, 100}) {
        Coordinates c = {Real(n), Real(0.5), Real(-0.5), Real(2.5)}, next = c;
        next[0] = Real(n + 1);
        std::vector<Real> value = form(dimension, c);
        for (double inside : {1e-9, 0.5, 0.999}) {
          Coordinates d = c;
          d[0] = Real(n + inside);
          CHECK(form(dimension, d) == value);
        }
        CHECK(form(dimension, next) != value);
        for (Real v : value) {
          CHECK(v >= 0);
          CHECK(v < 1);
        }
      }
  CHECK(cellForms[0](1, {Real(-1e-9)}) != cellForms[0](1, {Real(0)}));
  CHECK(cellForms[0](1, {Real(-1e-9)}) == cellForms[0](1, {Real(-0.5)}));
}

TEST_CASE("cell noise is spread evenly") {
  const int cells = 20000, bins = 20;
  int count[4][bins] = {};
  for (int i = 0; i < cells; ++i)
    for (int dimension = 1; dimension <= 4; ++dimension) {
      Coordinates c = {Real(i % 100), Real(i / 100), Real(i % 7), Real(i % 13)};
      if (dimension == 1)
        c[0] = Real(i);
      ++count[dimension - 1][int(plain(cellForms[0](dimension, c)[0]) * bins)];
    }
  for (auto &dimension : count)
    for (int n : dimension)
      CHECK(std::abs(n - cells / bins) < 5 * std::sqrt(cells / bins));
}

TEST_CASE("periodic noise repeats, and is one half on the lattice") {
  Random random;
  for (int type = 0; type < 3; ++type)
    for (int dimension = 1; dimension <= 4; ++dimension)
      for (int i = 0; i < 200; ++i) {
        Coordinates period = {3, 5, 2, 7};
        // Sixteenths, so that moving by a period is exact.
        Coordinates c = random.point(-20, 20);
        for (Real &x : c)
          x = anysl::floorOf(x * 16) * Real(1 / 16.0);
        Coordinates moved = c;
        int axis = i % dimension;
        moved[axis] = moved[axis] + period[axis] * Real(1 + i % 3);
        REQUIRE(periodic(type, dimension, c, period) == periodic(type, dimension, moved, period));
        Coordinates lattice = c;
        for (Real &x : lattice)
          x = anysl::floorOf(x);
        for (Real value : periodic(type, dimension, lattice, period))
          REQUIRE(value == 0.5);
      }
}

TEST_CASE("a period without meaning counts as 1") {
  Coordinates c = {Real(0.3), Real(4.7), Real(-2.2), Real(0.9)};
  for (int dimension = 1; dimension <= 4; ++dimension) {
    std::vector<Real> one = periodic(0, dimension, c, {1, 1, 1, 1});
    for (Real p : {Real(0), Real(0.5), Real(-3), notANumber})
      CHECK(periodic(0, dimension, c, {p, p, p, p}) == one);
  }
}

TEST_CASE("any coordinate gives a finite number, the same each time") {
  for (Real x : {Real(3e9), Real(-3e9), Real(1e15), Real(1e30), largest, -largest, Real(1e-40)})
    for (int dimension = 1; dimension <= 4; ++dimension) {
      Coordinates c = {x, -x, x * Real(1 / 3.0), Real(0.5)};
      for (auto value : {noiseForms[0](dimension, c)[0], cellForms[0](dimension, c)[0],
                         periodic(0, dimension, c, {4, 4, 4, 4})[0]}) {
        CHECK(value >= 0);
        CHECK(value <= 1);
      }
      CHECK(noiseForms[0](dimension, c) == noiseForms[0](dimension, c));
    }
  // NaN selects a cell like any other number does; no conversion of it is undefined.
  CHECK(cellForms[0](1, {notANumber}) == cellForms[0](1, {notANumber}));
  CHECK(anysl::isNaN(noiseForms[0](1, {notANumber})[0]));
}
