//===-- test/unit/render/SubdivisionTest.cpp - Catmull-Clark surfaces -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/render/TestScene.h"

#include <catch2/catch.hpp>

using namespace anysl::render;

namespace {

const std::string cubeFaces =
    "[4 4 4 4 4 4] [0 2 3 1  4 5 7 6  0 1 5 4  2 6 7 3  0 4 6 2  1 3 7 5] ";
const std::string cubePoints =
    " \"P\" [-1 -1 -1  1 -1 -1  -1 1 -1  1 1 -1  -1 -1 1  1 -1 1  -1 1 1  1 1 1] ";

TestScene subdivided(const std::string &arguments) {
  return TestScene("Projection \"perspective\" \"fov\" [60] WorldBegin Translate 0 0 5 "
                   "SubdivisionMesh \"catmull-clark\" " +
                   arguments + " WorldEnd");
}

/// The place nearest to another, seen from the centre of the shape.
double distanceToPoint(const Mesh &mesh, Vec3d place) {
  double nearest = 1e30;
  for (const Vec3f &p : mesh.points)
    nearest = std::min(nearest, maxAbs(Vec3d(p) - Vec3d(0, 0, 5) - place));
  return nearest;
}

Vec3d component(const Variable &variable, size_t corner) {
  const float *v = variable.at(corner);
  return {v[0], v[1], v[2]};
}

} // namespace

TEST_CASE("a subdivided cube and tetrahedron go through the limits of their vertices",
          "[subdivision]") {
  auto cube = facets(subdivided(cubeFaces + cubePoints));
  // (9 v + 4 sum of the 3 neighbours + sum of the 3 opposite corners) / 24.
  for (double x : {-0.5, 0.5})
    for (double y : {-0.5, 0.5})
      for (double z : {-0.5, 0.5})
        CHECK(distanceToPoint(*cube, {x, y, z}) < 1e-5);
  // The face's middle, after one step by hand: (16 + 4 * 4 * 3/4 + 4 * 5/9) / 36.
  CHECK(distanceToPoint(*cube, {0, 0, (16 + 12 + 20. / 9) / 36}) < 1e-5);
  CHECK(openEdges(*cube) == 0);

  // The same in its hierarchical form, whose tags have texts as well.
  TestScene scene("Projection \"perspective\" \"fov\" [60] WorldBegin Translate 0 0 5 "
                  "HierarchicalSubdivisionMesh \"catmull-clark\" " +
                  cubeFaces + "[\"interpolateboundary\" \"crease\"] [1 0 0 2 1 0] [2 0 1] [0] []" +
                  cubePoints + " WorldEnd");
  CHECK(facets(scene)->points.size() == cube->points.size());

  auto tetrahedron = facets(subdivided("[3 3 3 3] [0 1 2  0 2 3  0 3 1  1 3 2] "
                                       "\"P\" [1 1 1  1 -1 -1  -1 1 -1  -1 -1 1]"));
  for (Vec3d v : {Vec3d(1, 1, 1), Vec3d(1, -1, -1), Vec3d(-1, 1, -1), Vec3d(-1, -1, 1)})
    CHECK(distanceToPoint(*tetrahedron, v * (2. / 9)) < 1e-5);
  CHECK(openEdges(*tetrahedron) == 0);
}

TEST_CASE("normals of a subdivided cube point outwards and fit its facets", "[subdivision]") {
  TestScene scene = subdivided(cubeFaces + cubePoints);
  auto mesh = facets(scene);
  for (size_t t = 0; t < mesh->triangles.size(); ++t) {
    const auto &[a, b, c] = mesh->triangles[t];
    Vec3d p(mesh->points[a]), q(mesh->points[b]), r(mesh->points[c]);
    Vec3d facet = normalized(cross(q - p, r - p));
    CHECK(dot(facet, p - Vec3d(0, 0, 5)) > 0);
    for (size_t k = 0; k < 3; ++k)
      CHECK(dot(component(mesh->normals, mesh->corners[t][k]), facet) > 0.99);
  }
  auto point = scene.look({0, 0, 1});
  REQUIRE(point);
  CHECK(maxAbs(point->normal - Vec3d(0, 0, -1)) < 1e-4);
  CHECK(point->frame.P.z == Approx(5 - (16 + 12 + 20. / 9) / 36).epsilon(1e-4));
  CHECK(point->frame.u == Approx(0.5).epsilon(1e-3));
}

TEST_CASE("creases, corners and holes", "[subdivision]") {
  // All edges as sharp as can be: the cube itself, with two normals at its edges.
  std::string edges, counts, tags, sharpness;
  for (const char *edge :
       {"0 1", "0 2", "0 4", "1 3", "1 5", "2 3", "2 6", "3 7", "4 5", "4 6", "5 7", "6 7"}) {
    edges += std::string(edge) + " ";
    counts += "2 1 ";
    tags += "\"crease\" ";
    sharpness += "10 ";
  }
  std::string sharp = "[" + tags + "] [" + counts + "] [" + edges + "] [" + sharpness + "]";
  auto cube = facets(subdivided(cubeFaces + sharp + cubePoints));
  CHECK(area(*cube) == Approx(24).epsilon(1e-5));
  CHECK(openEdges(*cube) == 0);
  for (size_t t = 0; t < cube->triangles.size(); ++t)
    for (size_t k = 0; k < 3; ++k) {
      Vec3d p = Vec3d(cube->points[cube->triangles[t][k]]) - Vec3d(0, 0, 5);
      Vec3d n = component(cube->normals, cube->corners[t][k]);
      CHECK(maxAbs(p) == Approx(1).epsilon(1e-5));
      CHECK(maxAbs(n) == Approx(1).epsilon(1e-4)); // along an axis
      CHECK(dot(p, n) == Approx(1).epsilon(1e-4));
    }

  auto pinned = facets(subdivided(cubeFaces + "[\"corner\"] [1 1] [7] [10]" + cubePoints));
  CHECK(distanceToPoint(*pinned, {1, 1, 1}) < 1e-5);
  CHECK(distanceToPoint(*pinned, {-0.5, -0.5, -0.5}) < 1e-5);

  TestScene open = subdivided(cubeFaces + "[\"hole\"] [1 0] [0] []" + cubePoints);
  CHECK(open.look({0, 0, 1})->frame.P.z > 5); // face 0 is in front: its back shows
}

TEST_CASE("a boundary is left out, pinned at its corners, or a spline", "[subdivision]") {
  std::string face = "[4] [0 1 2 3] ", points = " \"P\" [-1 -1 0  1 -1 0  1 1 0  -1 1 0]";
  CHECK(facets(subdivided(face + points))->triangles.empty());
  auto pinned = facets(subdivided(face + "[\"interpolateboundary\"] [0 0] [] []" + points));
  CHECK(distanceToPoint(*pinned, {1, 1, 0}) < 1e-5);
  auto smooth = facets(subdivided(face + "[\"interpolateboundary\"] [1 0] [2] []" + points));
  // (v0 + 4 v1 + v2) / 6, as on any cubic b-spline.
  CHECK(distanceToPoint(*smooth, {2. / 3, 2. / 3, 0}) < 1e-5);
  CHECK(distanceToPoint(*smooth, {1, 1, 0}) > 0.3);
}

TEST_CASE("faces of every size meet without cracks", "[subdivision]") {
  // A house: a pentagonal prism, of pentagons and quadrilaterals, near the eye on one side.
  TestScene scene(
      "Projection \"perspective\" \"fov\" [90] WorldBegin Translate 0 0 2.5 Scale 1 1 2 "
      "SubdivisionMesh \"catmull-clark\" [5 5 4 4 4 4 4] "
      "[0 1 2 3 4  9 8 7 6 5  0 5 6 1  1 6 7 2  2 7 8 3  3 8 9 4  4 9 5 0] "
      "[\"crease\"] [6 1] [0 1 2 3 4 0] [2.5] "
      "\"P\" [-1 -1 -1  -1 1 -1  0 2 -1  1 1 -1  1 -1 -1  -1 -1 1  -1 1 1  0 2 1  1 1 1  1 -1 1] "
      "WorldEnd");
  CHECK(scene.warnings.count() == 0);
  auto mesh = facets(scene);
  CHECK(mesh->triangles.size() > 1000);
  CHECK(openEdges(*mesh) == 0);
}

TEST_CASE("a subdivision mesh's variables of every class", "[subdivision]") {
  TestScene scene = subdivided(
      cubeFaces + cubePoints +
      "\"uniform float face\" [0 1 2 3 4 5] \"vertex point same\" [-1 -1 -1  1 -1 -1  "
      "-1 1 -1  1 1 -1  -1 -1 1  1 -1 1  -1 1 1  1 1 1] \"varying float x\" [-1 1 -1 1 -1 1 -1 1] "
      "\"facevarying float[2] st\" [0 0 0 1 1 1 1 0  0 0 0 1 1 1 1 0  0 0 0 1 1 1 1 0  0 0 0 1 1 1 "
      "1 0  "
      "0 0 0 1 1 1 1 0  0 0 0 1 1 1 1 0]");
  CHECK(scene.warnings.count() == 0);
  // Face 0 is 0 2 3 1: u runs along y and v along x.
  Vec3d direction(0.05, 0.1, 1);
  auto point = scene.look(direction);
  REQUIRE(point);
  CHECK(scene.value(direction, "face") == std::vector<float>{0});
  auto same = scene.value(direction, "same");
  for (int k = 0; k < 3; ++k)
    CHECK(same.at(size_t(k)) == Approx(point->frame.P[k]).margin(1e-5));
  CHECK(scene.value(direction, "x").at(0) == Approx(2 * point->frame.v - 1).margin(1e-4));
  CHECK(point->s == Approx(point->frame.v).margin(1e-5));
  CHECK(point->t == Approx(point->frame.u).margin(1e-5));
  CHECK(point->frame.v > 0.5);
  CHECK(point->dsdv == Approx(1).epsilon(1e-4));
  CHECK(point->dsdu == Approx(0).margin(1e-4));
}

TEST_CASE("wrong subdivision meshes are left out", "[subdivision]") {
  auto check = [](const std::string &arguments, const std::string &message, size_t shapes = 0) {
    TestScene scene("WorldBegin SubdivisionMesh " + arguments + " WorldEnd");
    INFO(arguments);
    CHECK(scene.description.shapes.size() == shapes);
    CHECK(scene.warnings.count() == 1);
    CHECK(scene.warnings.contains(message));
  };
  std::string points = " \"P\" [-1 -1 0  1 -1 0  1 1 0  -1 1 0]";
  check("\"loop\" [3] [0 1 2]" + points, "\"loop\" is not the scheme catmull-clark");
  check("\"catmull-clark\" [4] [0 1 2 4]" + points, "\"P\" has 4 vertices, but vertex 4 is used");
  check("\"catmull-clark\" [2] [0 1]" + points, "a face with 2 vertices");
  check("\"catmull-clark\" [4] [0 1 2 1]" + points, "a face has the same vertex twice");
  check("\"catmull-clark\" [4] [0 1 2]" + points, "fewer vertices than the faces need");
  check("\"catmull-clark\" [3] [0 1 2 3]" + points, "the numbers of vertices add up to 3, but 4");
  check("\"catmull-clark\" [4] [0 1 2 3] [\"hole\"] [1 0] [1] []" + points,
        "tag \"hole\": there is no number 1");
  check("\"catmull-clark\" [4] [0 1 2 3] [\"hole\"] [1] [0] []" + points,
        "the 1 tags need 2 numbers");
  check("\"catmull-clark\" [4] [0 1 2 3] [\"crease\"] [2 1] [0] []" + points,
        "fewer arguments than it says");
  check("\"catmull-clark\" [4] [0 1 2 3] [\"odd\"] [0 0] [] []" + points,
        "tag \"odd\" of a subdivision mesh", 1);
}
