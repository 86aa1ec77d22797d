//===-- test/unit/render/LinearTest.cpp - vectors and matrices
//---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/Linear.h"

#include <catch2/catch.hpp>

using namespace anysl::render;

TEST_CASE("normalized keeps the direction at every scale", "[linear]") {
  for (double scale : {1e-300, 1e-30, 1.0, 1e30, 1e300}) {
    Vec3d n = normalized(Vec3d(3, -4, 12) * scale);
    CHECK(n.x == Approx(3.0 / 13));
    CHECK(n.y == Approx(-4.0 / 13));
    CHECK(n.z == Approx(12.0 / 13));
  }
  CHECK(normalized(Vec3d()) == Vec3d());
  CHECK(normalized(Vec3d(NAN, 0, 1)) == Vec3d());
}

TEST_CASE("a rotation turns x to y about z, y to z about x, z to x about y", "[linear]") {
  auto near = [](Vec3d a, Vec3d b) { return maxAbs(a - b) < 1e-14; };
  CHECK(near(Matrix4::rotation(90, {0, 0, 2}).vector({1, 0, 0}), {0, 1, 0}));
  CHECK(near(Matrix4::rotation(90, {5, 0, 0}).vector({0, 1, 0}), {0, 0, 1}));
  CHECK(near(Matrix4::rotation(90, {0, 1, 0}).vector({0, 0, 1}), {1, 0, 0}));
  // A third of a turn about the diagonal permutes the axes.
  CHECK(near(Matrix4::rotation(120, {1, 1, 1}).vector({1, 2, 3}), {3, 1, 2}));
}

TEST_CASE("a product means: first the left factor", "[linear]") {
  Matrix4 m = Matrix4::scaling({2, 2, 2}) * Matrix4::translation({1, 0, 0});
  CHECK(m.point({1, 1, 1}) == Vec3d(3, 2, 2));
  CHECK(m.vector({1, 1, 1}) == Vec3d(2, 2, 2));
}

TEST_CASE("an inverse undoes its matrix, and a flat matrix has none", "[linear]") {
  Matrix4 m = Matrix4::scaling({2, 3, 0.25}) * Matrix4::rotation(33, {1, 2, 3}) *
              Matrix4::translation({4, 5, -6});
  Matrix4 inverse = m;
  REQUIRE(inverse.invert());
  Vec3d p = (m * inverse).point({7, 8, 9});
  CHECK(maxAbs(p - Vec3d(7, 8, 9)) < 1e-13);
  Matrix4 flat = Matrix4::scaling({1, 0, 1});
  CHECK_FALSE(flat.invert());
  CHECK(flat == Matrix4::scaling({1, 0, 1}));
}

TEST_CASE("normals stay orthogonal under scaling", "[linear]") {
  Matrix4 m = Matrix4::scaling({1, 5, 1});
  Vec3d tangent = m.vector({1, -1, 0});
  Vec3d normal = m.inverse().normalByInverse({1, 1, 0});
  CHECK(dot(tangent, normal) == Approx(0).margin(1e-15));
}
