//===-- test/unit/render/PolygonTest.cpp - polygons, their holes and values -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/render/TestScene.h"

#include "tools/anysl-render/Sampling.h"
#include "tools/anysl-render/Triangulate.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace anysl::render;

namespace {

using Loops = std::vector<std::vector<Vec3d>>;

Vec3d areaVector(const std::vector<Vec3d> &loop) {
  Vec3d sum;
  for (size_t i = 0; i < loop.size(); ++i)
    sum += cross(loop[i], loop[(i + 1) % loop.size()]) * 0.5;
  return sum;
}

/// Triangulates and compares the areas; every triangle must turn as the outline does, so that equal
/// areas mean that the polygon is covered once and its holes are not.
void checkAreas(const Loops &loops) {
  std::vector<Vec3d> corners;
  std::vector<uint32_t> sizes;
  double expected = 0;
  Vec3d normal = normalized(areaVector(loops[0]));
  for (size_t i = 0; i < loops.size(); ++i) {
    corners.insert(corners.end(), loops[i].begin(), loops[i].end());
    sizes.push_back(uint32_t(loops[i].size()));
    double area = std::fabs(dot(areaVector(loops[i]), normal));
    expected += i == 0 ? area : -area;
  }
  std::vector<std::array<uint32_t, 3>> triangles;
  triangulate(corners, sizes, triangles);
  CHECK(triangles.size() <= corners.size() + 2 * loops.size() - 4);
  double sum = 0;
  for (const auto &[a, b, c] : triangles) {
    double area = 0.5 * dot(cross(corners[b] - corners[a], corners[c] - corners[a]), normal);
    CHECK(area >= -1e-12 * expected);
    sum += area;
  }
  CHECK(sum == Approx(expected).epsilon(1e-9));
}

/// A star of `count` corners with radii between `inner` and `outer`, in a tilted plane.
std::vector<Vec3d> star(Vec3d centre, double inner, double outer, uint32_t count, uint32_t seed) {
  std::vector<Vec3d> loop;
  for (uint32_t i = 0; i < count; ++i) {
    double angle = 2 * std::numbers::pi * i / count;
    double radius = inner + (outer - inner) * unitNumber(hash(seed, i));
    Vec3d p = centre + Vec3d(std::cos(angle), std::sin(angle), 0) * radius;
    loop.push_back({p.x, p.y, 0.25 * p.x - 0.75 * p.y + 3});
  }
  return loop;
}

} // namespace

TEST_CASE("triangles cover a polygon once, and none of its holes", "[polygon]") {
  checkAreas({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}});
  // Concave, either way round, in another plane.
  checkAreas({{{0, 0, 0}, {0, 4, 0}, {0, 4, 1}, {0, 1, 1}, {0, 1, 4}, {0, 0, 4}}});
  checkAreas({{{0, 0, 4}, {0, 1, 4}, {0, 1, 1}, {0, 4, 1}, {0, 4, 0}, {0, 0, 0}}});
  // A hole, either way round; holes level with each other and with corners of the outline.
  checkAreas(
      {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}}});
  checkAreas(
      {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}}});
  checkAreas({{{0, 0, 0}, {9, 0, 0}, {9, 2, 0}, {8, 1, 0}, {7, 3, 0}, {0, 3, 0}},
              {{1, 1, 0}, {2, 1, 0}, {1.5, 2, 0}},
              {{3, 1, 0}, {4, 1, 0}, {3.5, 2, 0}},
              {{5, 1, 0}, {6, 1, 0}, {5.5, 2, 0}}});
  // A comb, in which most corners are no ears, and corners on a straight line.
  std::vector<Vec3d> comb;
  for (int i = 0; i < 20; ++i)
    comb.push_back({double(i), i % 2 ? 5.0 : 0.5, 0});
  comb.insert(comb.end(), {{19, 0, 0}, {10, 0, 0}, {5, 0, 0}, {0, 0, 0}});
  checkAreas({comb});
}

TEST_CASE("triangles cover random stars with starry holes", "[polygon]") {
  for (uint32_t seed = 0; seed < 200; ++seed) {
    Loops loops = {star({}, 5, 9, 5 + seed % 60, seed)};
    for (uint32_t hole = 0; hole < seed % 8; ++hole) {
      double angle = 2 * std::numbers::pi * hole / 8;
      loops.push_back(star(Vec3d(std::cos(angle), std::sin(angle), 0) * 2.5, 0.2, 0.9,
                           3 + hash(seed, hole) % 9, hash(seed, hole + 100)));
    }
    INFO("seed " << seed);
    checkAreas(loops);
  }
}

TEST_CASE("a polygon that crosses itself or has no area does no harm", "[polygon]") {
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<Vec3d> bow = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}};
  triangulate(bow, std::vector<uint32_t>{4}, triangles);
  CHECK(triangles.size() <= 2);
  std::vector<Vec3d> flat(7, Vec3d(1, 2, 3));
  triangulate(flat, std::vector<uint32_t>{4, 3}, triangles);
  std::vector<Vec3d> outside = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 0}, {6, 5, 0}, {5, 6, 0}};
  triangles.clear();
  triangulate(outside, std::vector<uint32_t>{3, 3}, triangles);
  CHECK(triangles.size() == 1);
}

TEST_CASE("rays pass through a polygon's holes and meet the rest", "[polygon]") {
  for (const char *polygon :
       {"GeneralPolygon [4 4] \"P\" [-2 -2 4  2 -2 4  2 2 4  -2 2 4  -1 -1 4  1 -1 4  1 1 4  -1 1 "
        "4]",
        "PointsGeneralPolygons [2] [4 4] [3 2 1 0 4 5 6 7] "
        "\"P\" [-2 -2 4  2 -2 4  2 2 4  -2 2 4  -1 -1 4  1 -1 4  1 1 4  -1 1 4]"}) {
    TestScene scene(std::string("WorldBegin ") + polygon + " WorldEnd");
    for (double x = -2.45; x < 2.5; x += 0.1)
      for (double y = -2.45; y < 2.5; y += 0.1) {
        double far = std::max(std::fabs(x), std::fabs(y));
        CHECK(scene.look({x, y, 4}).has_value() == (far < 2 && far > 1));
      }
  }
}

TEST_CASE("a polygon's variables of every class", "[polygon]") {
  // Two squares side by side, turned by 90 degrees about z: x of the object is y of the camera.
  TestScene scene("WorldBegin Translate 0 0 4 Rotate 90 0 0 1 "
                  "PointsPolygons [4 4] [0 1 4 3  1 2 5 4] \"P\" [-2 -1 0  0 -1 0  2 -1 0  -2 1 0  "
                  "0 1 0  2 1 0] "
                  "\"constant float[2] pair\" [7 8] \"uniform float each\" [10 20] "
                  "\"varying float ramp\" [0 2 4 0 2 4] \"vertex vector along\" [1 0 0 1 0 0 1 0 0 "
                  "1 0 0 1 0 0 1 0 0] "
                  "\"facevarying color side\" [1 0 0 1 0 0 1 0 0 1 0 0  0 1 0 0 1 0 0 1 0 0 1 0] "
                  "\"constant point mark\" [1 2 3] \"uniform color Cs\" [1 0 0  0 0 1] WorldEnd");
  Vec3d left(0.5, -1, 4), right(0.5, 1, 4);
  CHECK(scene.value(left, "pair") == std::vector<float>{7, 8});
  CHECK(scene.value(left, "each") == std::vector<float>{10});
  CHECK(scene.value(right, "each") == std::vector<float>{20});
  CHECK(scene.value(right, "ramp").at(0) == Approx(3).epsilon(1e-5));
  CHECK(scene.value(right, "along").at(1) == Approx(1).epsilon(1e-5));
  CHECK(scene.value(right, "along").at(0) == Approx(0).margin(1e-5));
  CHECK(scene.value(left, "side").at(0) == Approx(1));
  CHECK(scene.value(right, "side").at(1) == Approx(1));
  CHECK(scene.value(left, "mark").at(0) == Approx(-2));
  CHECK(scene.value(left, "mark").at(1) == Approx(1));
  CHECK(scene.value(left, "mark").at(2) == Approx(7));
  CHECK(scene.look(left)->color == Vec3d(1, 0, 0));
  CHECK(scene.look(right)->color == Vec3d(0, 0, 1));
}

TEST_CASE("derivatives of a polygon's texture coordinates", "[polygon]") {
  TestScene scene("WorldBegin Translate 0 0 4 Polygon \"P\" [-1 -1 0  1 -1 0  1 1 0  -1 1 0] "
                  "\"st\" [0 0 4 1 4 7 0 6] WorldEnd");
  // s = 2 (x + 1), t = (x + 1) / 2 + 3 (y + 1), and u, v are x, y.
  auto point = scene.look({0.1, 0.2, 4});
  REQUIRE(point);
  CHECK(point->dsdu == Approx(2).epsilon(1e-5));
  CHECK(point->dsdv == Approx(0).margin(1e-5));
  CHECK(point->dtdu == Approx(0.5).epsilon(1e-5));
  CHECK(point->dtdv == Approx(3).epsilon(1e-5));
}

TEST_CASE("a quadric's variables lie at the corners of u and v", "[polygon]") {
  // The equator's front is at u = 1/4, v = 1/2.
  TestScene scene(
      "WorldBegin Translate 0 0 4 Rotate 180 0 0 1 Rotate -90 1 0 0 "
      "Sphere 1 -1 1 360 \"varying float a\" [0 1 2 3] \"Cs\" [1 0 0 1 0 0 0 0 1 0 0 1] "
      "\"uniform float b\" [5] \"st\" [0 0 2 0 0 3 2 3] WorldEnd");
  auto point = scene.look({0, 0, 1});
  REQUIRE(point);
  double u = point->frame.u, v = point->frame.v;
  CHECK(v == Approx(0.5));
  CHECK(scene.value({0, 0, 1}, "a").at(0) == Approx(u + 2 * v));
  CHECK(scene.value({0, 0, 1}, "b").at(0) == 5);
  CHECK(point->color.x == Approx(0.5));
  CHECK(point->color.z == Approx(0.5));
  CHECK(point->s == Approx(2 * u));
  CHECK(point->t == Approx(3 * v));
  CHECK(point->dsdu == Approx(2));
  CHECK(point->dtdv == Approx(3));
  // On a unit sphere the normal is the place, seen from the centre, and so are its derivatives.
  double outside = dot(point->normal, normalized(point->frame.P - Vec3d(0, 0, 4)));
  CHECK(std::fabs(outside) == Approx(1));
  CHECK(maxAbs(point->dNdu - point->frame.dPdu * outside) < 1e-6);
  CHECK(maxAbs(point->dNdv - point->frame.dPdv * outside) < 1e-6);
}

TEST_CASE("facets of polygons are cut finely without cracks", "[polygon]") {
  TestScene scene("Format 200 200 1 WorldBegin Translate 0 0 4 PointsPolygons [4 4 4 4 4 4] "
                  "[0 2 3 1  4 5 7 6  0 1 5 4  2 6 7 3  0 4 6 2  1 3 7 5] "
                  "\"P\" [-1 -1 -1  1 -1 -1  -1 1 -1  1 1 -1  -1 -1 1  1 -1 1  -1 1 1  1 1 1] "
                  "\"varying float y\" [-1 -1 1 1 -1 -1 1 1] WorldEnd");
  auto mesh = facets(scene);
  Camera camera(scene.description.camera);
  Dicing dicing(camera);
  dicing.edge = 10; // a unit is 100 pixels
  refine(*mesh, dicing);
  CHECK(mesh->triangles.size() > 2000);
  CHECK(openEdges(*mesh) == 0);
  CHECK(area(*mesh) == Approx(24).epsilon(1e-6));
  for (const auto &triangle : mesh->triangles)
    for (size_t k = 0; k < 3; ++k) {
      Vec3d a(mesh->points[triangle[k]]), b(mesh->points[triangle[(k + 1) % 3]]);
      CHECK(length(b - a) < 0.151);
      CHECK(mesh->values.list.at(0).at(triangle[k])[0] == Approx(a.y).margin(1e-6));
    }
}
