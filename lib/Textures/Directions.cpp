//===-- lib/Textures/Directions.cpp - where a direction lies in a picture -----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Textures/Directions.h"

#include <algorithm>
#include <cmath>

namespace anysl::textures {
namespace {

constexpr double pi = 3.14159265358979323846;

double dot(const Direction &a, const Direction &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Longitude and latitude about the z axis: s counts turns from +x over +y, t from +z.
void findLatLong(const Direction &d, const Direction (&change)[2], PictureFilter &filter) {
  double across = std::hypot(d[0], d[1]), length = std::hypot(across, d[2]);
  double s = std::atan2(d[1], d[0]) / (2 * pi);
  filter.s = s < 0 ? s + 1 : s;
  filter.t = std::atan2(across, d[2]) / pi;
  if (across > 0) {
    double turn = 1 / (across * across) / (2 * pi), tilt = 1 / (length * length) / pi;
    filter.sBy = {-d[1] * turn, d[0] * turn, 0};
    filter.tBy = {d[0] / across * d[2] * tilt, d[1] / across * d[2] * tilt, -across * tilt};
  }
  for (int k = 0; k < 2; ++k) {
    const Direction &c = change[k];
    // At the poles every longitude is near; half a turn is the most that a filter can cover.
    double tilt = across > 0 ? dot(filter.tBy, c) : std::hypot(c[0], c[1]) / d[2] / pi;
    filter.ds[k] = std::clamp(dot(filter.sBy, c), -0.5, 0.5);
    filter.dt[k] = std::clamp(tilt, -0.5, 0.5);
  }
}

/// The faces of a cube, as seen from inside: which way is ahead, to the right, and up.
struct Face {
  int ahead, right, up; ///< axis 1, 2, 3, negative for its opposite
};
constexpr Face faces[6] = {{1, -3, 2}, {-1, 3, 2}, {2, 1, -3}, {-2, 1, 3}, {3, 1, 2}, {-3, -1, 2}};

double along(const Direction &d, int axis) { return axis > 0 ? d[axis - 1] : -d[-axis - 1]; }

/// How (x along one axis) / (x along another) changes with x, times a factor.
Direction slopeOfRatio(const Direction &d, int of, int by, double factor) {
  double below = along(d, by);
  Direction slope = {0, 0, 0};
  auto add = [&](int axis, double x) { slope[std::abs(axis) - 1] += axis > 0 ? x : -x; };
  add(of, factor / below);
  add(by, -factor * along(d, of) / (below * below));
  return slope;
}

void findOnCube(bool inRows, const Direction &d, const Direction (&change)[2],
                PictureFilter &filter) {
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (std::fabs(d[k]) > std::fabs(d[axis]))
      axis = k;
  int number = 2 * axis + (d[axis] < 0);
  const Face &face = faces[number];
  double columns = inRows ? 3 : 1, rows = inRows ? 2 : 6;
  double column = inRows ? number % 3 : 0, row = inRows ? number / 3 : number;
  double ahead = along(d, face.ahead), right = along(d, face.right), up = along(d, face.up);
  double x = 0.5 + 0.5 * right / ahead, y = 0.5 - 0.5 * up / ahead;
  filter.s = (column + x) / columns;
  filter.t = (row + y) / rows;
  filter.low[0] = column / columns, filter.high[0] = (column + 1) / columns;
  filter.low[1] = row / rows, filter.high[1] = (row + 1) / rows;
  filter.sBy = slopeOfRatio(d, face.right, face.ahead, 0.5 / columns);
  filter.tBy = slopeOfRatio(d, face.up, face.ahead, -0.5 / rows);
  for (int k = 0; k < 2; ++k) {
    filter.ds[k] = std::clamp(dot(filter.sBy, change[k]), -1 / columns, 1 / columns);
    filter.dt[k] = std::clamp(dot(filter.tBy, change[k]), -1 / rows, 1 / rows);
  }
}

} // namespace

bool findDirection(EnvironmentLayout layout, const Direction &direction, const Direction &changeX,
                   const Direction &changeY, PictureFilter &filter) {
  double length = std::hypot(direction[0], direction[1], direction[2]);
  if (!(length > 0) || !std::isfinite(length))
    return false;
  Direction change[2] = {changeX, changeY};
  for (Direction &c : change)
    for (double &x : c)
      x = std::isfinite(x) ? x : 0;
  filter = {};
  auto turned = [](const Direction &d) { return Direction{d[2], -d[0], d[1]}; };
  switch (layout) {
  case EnvironmentLayout::LatLongZUp:
    findLatLong(direction, change, filter);
    break;
  case EnvironmentLayout::LatLongYUp: {
    Direction changes[2] = {turned(change[0]), turned(change[1])};
    findLatLong(turned(direction), changes, filter);
    filter.s = filter.s < 0.5 ? filter.s + 0.5 : filter.s - 0.5;
    auto turnedBack = [](const Direction &x) { return Direction{-x[1], x[2], x[0]}; };
    filter.sBy = turnedBack(filter.sBy);
    filter.tBy = turnedBack(filter.tBy);
    break;
  }
  case EnvironmentLayout::CubeColumn:
  case EnvironmentLayout::CubeRows:
    findOnCube(layout == EnvironmentLayout::CubeRows, direction, change, filter);
    break;
  }
  return true;
}

} // namespace anysl::textures
