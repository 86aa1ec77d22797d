//===-- test/hard-cases/Inputs.cpp - the inputs that break obvious code -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/hard-cases/Inputs.h"
#include <algorithm>
#include <array>
#include <random>

using namespace hardcases;

namespace {

using Direction = std::array<double, 3>;

Direction scaled(const Direction &d, double s) { return {d[0] * s, d[1] * s, d[2] * s}; }
Direction sum(const Direction &a, const Direction &b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
double dot(const Direction &a, const Direction &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Direction unit(const Direction &d) {
  // Rounded once, so that the length is as near to 1 as the format lets it be.
  long double x = d[0], y = d[1], z = d[2], length = std::sqrt(x * x + y * y + z * z);
  return {double(x / length), double(y / length), double(z / length)};
}
/// Some unit vector across d.
Direction across(const Direction &d) {
  int axis = std::fabs(d[0]) < 0.5 ? 0 : 1;
  Direction e = {double(axis == 0), double(axis == 1), 0};
  return unit(sum(e, scaled(d, -d[size_t(axis)])));
}

/// Directions along axes, diagonal and in no special position.
std::vector<Direction> directions(int count) {
  std::vector<Direction> result = {
      {1, 0, 0}, {0, -1, 0}, {0, 0, 1}, unit({1, 1, 1}), unit({-3, 4, 0})};
  std::mt19937 generator(7);
  std::normal_distribution<double> component;
  while (int(result.size()) < count)
    result.push_back(unit({component(generator), component(generator), component(generator)}));
  result.resize(size_t(count));
  return result;
}

void append(Numbers &numbers, const Direction &d) {
  numbers.insert(numbers.end(), d.begin(), d.end());
}
Numbers concat(std::initializer_list<Direction> list, std::initializer_list<double> rest = {}) {
  Numbers result;
  for (const Direction &d : list)
    append(result, d);
  result.insert(result.end(), rest);
  return result;
}

/// A unit vector that comes down on n at an angle.
Direction incident(const Direction &n, double angle) {
  return sum(scaled(across(n), std::sin(angle)), scaled(n, -std::cos(angle)));
}

} // namespace

Inputs hardcases::join(std::initializer_list<Inputs> lists) {
  Inputs result;
  for (const Inputs &list : lists)
    result.insert(result.end(), list.begin(), list.end());
  return result;
}

Inputs hardcases::product(const std::vector<std::vector<double>> &axes) {
  Inputs result = {{}};
  for (const auto &axis : axes) {
    Inputs longer;
    for (const Numbers &start : result)
      for (double value : axis) {
        longer.push_back(start);
        longer.back().push_back(value);
      }
    result = longer;
  }
  return result;
}

Inputs hardcases::vectorsOfAllSizes(Format f) {
  Inputs result;
  std::vector<double> sizes = {1e-38, 1e-30, 1e-22, 1e-10, 0.01, 1, 1e10, 1e20, 1e38};
  if (f.isDouble)
    for (double more : {1e-307, 1e-200, 1e-155, 1e155, 1e200, 1e307})
      sizes.push_back(more);
  for (double size : sizes)
    for (const Direction &d : directions(24))
      result.push_back(concat({scaled(d, size)}));
  return result;
}

Inputs hardcases::unitVectors(Format f, int count) {
  Inputs result;
  for (const Direction &d : directions(count))
    result.push_back({f.round(d[0]), f.round(d[1]), f.round(d[2])});
  return result;
}

Inputs hardcases::nearPole(Format f) {
  Inputs result;
  for (double x : {0.0, 1e-5, 1e-4, -2e-4, 0.01})
    for (double y : {0.0, 3e-4, -0.01})
      for (double side : {-1, 1})
        result.push_back({f.round(x), f.round(y), f.round(side * std::sqrt(1 - x * x - y * y))});
  return result;
}

Inputs hardcases::reflections(Format, const std::vector<double> &lengthErrors) {
  Inputs result;
  for (const Direction &n : directions(12))
    for (double angle : {0.0, 1e-4, 0.5, 1.0, 1.5, 1.5707})
      for (double e : lengthErrors)
        result.push_back(concat({incident(n, angle), scaled(n, 1 + e)}));
  return result;
}

Inputs hardcases::aboutCriticalAngle(Format) {
  Inputs result;
  for (double eta : {1.5, 1.0001, 1.000001}) {
    double critical = std::asin(1 / eta);
    for (const Direction &n : directions(14))
      for (double offset = 1e-7; offset < 0.4; offset *= 8)
        for (double side : {-1, 1})
          if (critical + side * offset < 1.5707)
            result.push_back(concat({incident(n, critical + side * offset), n}, {eta}));
  }
  return result;
}

Inputs hardcases::extremeMedia(Format) {
  Inputs result;
  Direction n = {0, 0, 1};
  for (Direction I : {Direction{1, 0, 0}, Direction{0.6, 0, -0.8}, Direction{0, 0, -1}})
    for (double eta : {1.0, 0.0, 1e-30, 1e30, -1.2, 1.5, -1 / 1.5, 1 / 1.5})
      result.push_back(concat({I, n}, {eta}));
  return result;
}

Inputs hardcases::refractions(Format) {
  Inputs result;
  for (const Direction &n : directions(16))
    for (double angle : {0.0, 1e-6, 1e-3, 0.3, 1.0, 1.5, 1.57})
      for (double eta : {1.0, 0.5, 1 / 1.5, 0.999999, 1.5})
        result.push_back(concat({incident(n, angle), n}, {eta}));
  return result;
}

Inputs hardcases::closeVectors(Format) {
  Inputs result;
  for (const Direction &a : directions(20))
    for (double angle : {1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2})
      result.push_back(
          concat({a, sum(scaled(a, std::cos(angle)), scaled(across(a), std::sin(angle)))}));
  return result;
}

Inputs hardcases::facing(Format) {
  Inputs result;
  Direction n = {0.1, -0.7, 3};
  for (Direction i :
       {Direction{1, 0, 0}, Direction{-1, 0, 0}, Direction{0, 0, -1}, Direction{0, 0, 0}})
    for (Direction reference : {Direction{0, 0, 1}, Direction{-0.0, 0, 1}, Direction{0, 0, -0.0},
                                Direction{1e-30, 0, 0}, Direction{-1e-30, 0, 0}})
      result.push_back(concat({n, i, reference}));
  return result;
}

Inputs hardcases::coordinates(Format) {
  Inputs result;
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> within(-1, 1);
  for (double size : {1.0, 10.0, 1e4, 1e5, 1e6, 1e7, 1e30})
    for (int i = 0; i < 12; ++i)
      result.push_back(
          {size * within(generator), size * within(generator), size * within(generator)});
  for (double x : {-0.5, -1e-9, 0.0, -2.0, 5.0, -0.25, 3e9, -3e9, 100000.25})
    result.push_back({x, x, -x});
  return result;
}

Inputs hardcases::halfVectors(Format) {
  Inputs result;
  for (double alpha : {1e-4, 1e-3, 1e-2, 0.1, 0.5, 1.0})
    for (double share : {0.0, 0.1, 1.0, 3.0, 10.0}) {
      double angle = std::min(share * alpha, 1.5);
      for (double turn : {0.0, 0.7, 2.5})
        result.push_back({std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn),
                          std::cos(angle), alpha});
    }
  return result;
}

Inputs hardcases::colors(bool anySign) {
  Inputs result;
  for (double grey : {0.0, 1e-30, 1e-3, 0.18, 0.5, 1.0})
    result.push_back({grey, grey, grey});
  std::vector<double> levels = {0, 0.125, 0.5, 0.7, 1};
  for (const Numbers &c : product({levels, levels, levels}))
    result.push_back(c);
  if (anySign)
    for (double x : {-1e-6, -1.0, 100.0})
      for (size_t k = 0; k < 3; ++k) {
        Numbers c = {0.25, 0.5, 0.75};
        c[k] = x;
        result.push_back(c);
      }
  return result;
}

Inputs hardcases::frames(Format) {
  Inputs result;
  Direction zero = {0, 0, 0}, n = {0, 3, 4}, up = {0, 0, 1};
  for (const Direction &a : directions(8))
    for (double size : {1e-12, 1.0, 1e12}) {
      Direction b = sum(scaled(across(a), 2), a),
                cross = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]};
      result.push_back(concat({scaled(a, size), scaled(b, size), n, unit(cross)}));
      result.push_back(concat({scaled(a, size), scaled(a, -2 * size), n, up}));
      result.push_back(concat({scaled(a, size), scaled(a, size), zero, up}));
      result.push_back(concat({scaled(a, size), zero, n, up}));
    }
  result.push_back(concat({zero, zero, n, up}));
  result.push_back(concat({zero, zero, zero, up}));
  result.push_back(concat({zero, zero, zero, zero}));
  return result;
}

Inputs hardcases::allExponents(Format f) {
  Inputs result;
  int least = f.isDouble ? -1074 : -149, most = f.isDouble ? 1023 : 127;
  for (int e = least; e <= most; e += f.isDouble && std::abs(e) > 160 ? 37 : 1) {
    double x = std::ldexp(1.0, e);
    for (double y : {x, f.after(x), f.before(x)}) {
      result.push_back({y});
      result.push_back({-y});
    }
  }
  result.push_back({0});
  result.push_back({-0.0});
  result.push_back({f.largest()});
  result.push_back({-f.largest()});
  return result;
}
