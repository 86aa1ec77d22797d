//===-- test/unit/render/FootprintTest.cpp - how much of a surface a pixel sees ---------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Footprint.h"

#include <catch2/catch.hpp>

using namespace anysl::render;

namespace {

/// A pixel is 0.02 high and wide at depth 1.
Camera camera(bool perspective = true) {
  CameraDescription description;
  description.perspective = perspective;
  description.fov = 90;
  description.width = description.height = 100;
  return Camera(description);
}

/// The plane through P with these derivatives.
SurfacePoint plane(Vec3d P, Vec3d dPdu, Vec3d dPdv) {
  SurfacePoint point;
  point.frame.P = P;
  point.frame.dPdu = dPdu;
  point.frame.dPdv = dPdv;
  point.frame.normal = normalized(cross(dPdu, dPdv));
  return point;
}

Ray ray(Vec3f origin, Vec3f direction) {
  Ray result;
  result.origin = origin;
  result.direction = direction;
  return result;
}

void fromEye(SurfacePoint &point) {
  findFootprint(camera(), true, ray({}, Vec3f(normalized(point.frame.P))), point);
}

} // namespace

TEST_CASE("a surface that faces the eye shows what a pixel covers", "[footprint]") {
  SurfacePoint point = plane({0, 0, 5}, {2, 0, 0}, {0, 4, 0});
  fromEye(point);
  CHECK(point.du == Approx(0.02 * 5 / 2));
  CHECK(point.dv == Approx(0.02 * 5 / 4));
  // Off the axis of the camera as well, since the plane is the picture's.
  point = plane({3, -4, 5}, {2, 0, 0}, {0, 4, 0});
  fromEye(point);
  CHECK(point.du == Approx(0.02 * 5 / 2));
  CHECK(point.dv == Approx(0.02 * 5 / 4));
  // The area stays the pixel's where u and v lie askew in the picture.
  point = plane({0, 0, 5}, {1, 1, 0}, {-3, 3, 0});
  fromEye(point);
  CHECK(length(cross(point.frame.dPdu * point.du, point.frame.dPdv * point.dv)) ==
        Approx(0.1 * 0.1));
}

TEST_CASE("a surface that leans away is seen for longer", "[footprint]") {
  // 60 degrees about x: twice as far along v.
  SurfacePoint point = plane({0, 0, 5}, {1, 0, 0}, {0, 0.5, std::sqrt(0.75)});
  fromEye(point);
  CHECK(point.du == Approx(0.1));
  CHECK(point.dv == Approx(0.2));
  point = plane({0, 0, 5}, {1, 0, 0}, {0, 0, 1});
  fromEye(point);
  CHECK(point.du == Approx(0.1));
  CHECK(std::isfinite(point.dv));
  CHECK(point.dv > 1);
}

TEST_CASE("parallel rays see the same at every depth", "[footprint]") {
  SurfacePoint point = plane({1, 2, 50}, {2, 0, 0}, {0, 4, 0});
  findFootprint(camera(false), true, ray({1, 2, 0}, {0, 0, 1}), point);
  CHECK(point.du == Approx(0.01));
  CHECK(point.dv == Approx(0.005));
}

TEST_CASE("a mirror prolongs the way from the eye", "[footprint]") {
  // Straight back from a mirror at depth 3 to a plane at depth 1.
  SurfacePoint point = plane({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
  findFootprint(camera(), false, ray({0, 0, 3}, {0, 0, -1}), point);
  CHECK(point.du == Approx(0.1));
  CHECK(point.dv == Approx(0.1));
}

TEST_CASE("a ray's neighbours say what u and v change by, and how I changes", "[footprint]") {
  // From (0, 0, 3) straight back to depth 1; the neighbours start (0.1, 0, 0) and (0, 0.2, 0) away
  // and lean outwards by 0.05 and 0.3 for each unit of length.
  RaySpread spread{{{0.1, 0, 0}, {0, 0.2, 0}}, {{0.05, 0, 0}, {0, 0.3, 0}}};
  Ray traced = ray({0, 0, 3}, {0, 0, -1});
  traced.spread = &spread;
  SurfacePoint point = plane({0, 0, 1}, {1, 0, 0}, {0, 4, 0});
  findFootprint(camera(), false, traced, point);
  CHECK(point.toRight.u == Approx(0.1 + 2 * 0.05));
  CHECK(point.down.v == Approx((0.2 + 2 * 0.3) / 4));
  CHECK(point.du == Approx(0.2));
  CHECK(point.dv == Approx(0.2));
  // P goes 0.2 to the right while the origin goes 0.1: I changes by half of what P does.
  CHECK(point.dIdu.x == Approx(0.5));
  CHECK(point.dIdv.y == Approx(4 * 0.75));
  // Behind a surface that it has passed the ray is still the same.
  traced.origin = {0, 0, 2};
  traced.travelled = 1;
  findFootprint(camera(), false, traced, point);
  CHECK(point.du == Approx(0.2));
}

TEST_CASE("where a surface has no two directions nothing changes", "[footprint]") {
  SurfacePoint point = plane({0, 0, 5}, {1, 0, 0}, {0, 1, 0});
  point.frame.dPdu = Vec3d();
  fromEye(point);
  CHECK(point.du == 0);
  CHECK(point.dv == 0);
}
