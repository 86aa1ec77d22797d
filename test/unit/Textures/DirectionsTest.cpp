//===-- test/unit/Textures/DirectionsTest.cpp - where a direction lies in a picture -----------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Textures/Directions.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace anysl::textures;

namespace {

struct Place {
  double s, t;
};

Place find(EnvironmentLayout layout, Direction d) {
  PictureFilter filter;
  REQUIRE(findDirection(layout, d, {}, {}, filter));
  return {filter.s, filter.t};
}

void check(EnvironmentLayout layout, Direction d, double s, double t) {
  CAPTURE(d[0], d[1], d[2]);
  Place place = find(layout, d);
  CHECK(place.s == Approx(s).margin(1e-12));
  CHECK(place.t == Approx(t).margin(1e-12));
}

} // namespace

TEST_CASE("with z up, +x is at the left edge and s goes over +y") {
  auto layout = EnvironmentLayout::LatLongZUp;
  check(layout, {2, 0, 0}, 0, 0.5);
  check(layout, {0, 3, 0}, 0.25, 0.5);
  check(layout, {-1, 0, 0}, 0.5, 0.5);
  check(layout, {0, -1, 0}, 0.75, 0.5);
  check(layout, {1, 0, 1}, 0, 0.25);
  CHECK(find(layout, {0, 0, 1}).t == 0);
  CHECK(find(layout, {0, 0, -1}).t == Approx(1));
}

TEST_CASE("with y up, +z is in the middle and +x to its left") {
  auto layout = EnvironmentLayout::LatLongYUp;
  check(layout, {0, 0, 1}, 0.5, 0.5);
  check(layout, {1, 0, 0}, 0.25, 0.5);
  check(layout, {-1, 0, 0}, 0.75, 0.5);
  check(layout, {0, 1, 1}, 0.5, 0.25);
  CHECK(find(layout, {0, 5, 0}).t == 0);
}

TEST_CASE("the faces of a cube stand below each other or in two rows") {
  const Direction ahead[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int face = 0; face < 6; ++face) {
    check(EnvironmentLayout::CubeColumn, ahead[face], 0.5, (face + 0.5) / 6);
    check(EnvironmentLayout::CubeRows, ahead[face], (face % 3 + 0.5) / 3, (face / 3 + 0.5) / 2);
  }
  // On the face of +z, +x is to the right and +y up; half a face away is 45 degrees.
  check(EnvironmentLayout::CubeColumn, {0.5, 0.5, 1}, 0.75, (4 + 0.25) / 6);
}

TEST_CASE("filters are the derivatives of places") {
  const Direction changes[2] = {{0.3, -0.2, 0.1}, {-0.1, 0.25, 0.4}};
  constexpr double step = 1e-6;
  for (auto layout : {EnvironmentLayout::LatLongZUp, EnvironmentLayout::LatLongYUp,
                      EnvironmentLayout::CubeColumn, EnvironmentLayout::CubeRows})
    for (Direction d : {Direction{0.9, 0.3, 0.2}, {-0.2, 1.4, -0.5}, {0.3, 0.1, -1.2}}) {
      CAPTURE(int(layout), d[0]);
      PictureFilter filter;
      REQUIRE(findDirection(layout, d, changes[0], changes[1], filter));
      for (int k = 0; k < 2; ++k) {
        Direction moved = d;
        for (int c = 0; c < 3; ++c)
          moved[c] += step * changes[k][c];
        Place there = find(layout, moved);
        CHECK(filter.ds[k] == Approx((there.s - filter.s) / step).epsilon(1e-4).margin(1e-6));
        CHECK(filter.dt[k] == Approx((there.t - filter.t) / step).epsilon(1e-4).margin(1e-6));
      }
    }
}

TEST_CASE("what is no direction lies nowhere, and filters stay finite") {
  PictureFilter filter;
  constexpr double huge = std::numeric_limits<double>::infinity();
  CHECK_FALSE(findDirection(EnvironmentLayout::LatLongZUp, {0, 0, 0}, {}, {}, filter));
  CHECK_FALSE(findDirection(EnvironmentLayout::CubeRows, {huge, 0, 0}, {}, {}, filter));
  CHECK_FALSE(findDirection(EnvironmentLayout::CubeRows, {std::nan(""), 0, 0}, {}, {}, filter));
  REQUIRE(findDirection(EnvironmentLayout::LatLongZUp, {1e-9, 0, 1}, {0, 1, 0}, {huge, 0, 0}, filter));
  CHECK(std::fabs(filter.ds[0]) <= 0.5);
  CHECK(std::isfinite(filter.dt[1]));
}
