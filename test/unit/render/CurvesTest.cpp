//===-- test/unit/render/CurvesTest.cpp - curves and points -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/render/TestScene.h"

#include "tools/anysl-render/Host.h"

#include <catch2/catch.hpp>

#include <numbers>

using namespace anysl::render;

namespace {

Vec3d randomDirection(uint32_t seed) {
  for (uint32_t k = 0;; ++k) {
    Vec3d d(unitNumber(hash(seed, 3 * k)) * 2 - 1, unitNumber(hash(seed, 3 * k + 1)) * 2 - 1,
            unitNumber(hash(seed, 3 * k + 2)) * 2 - 1);
    if (dot(d, d) <= 1 && dot(d, d) > 0.01)
      return normalized(d);
  }
}

/// How many rays that leave a scene's surfaces outwards meet them again.
int falseHits(const TestScene &scene, double spread, int &starts) {
  int hits = 0;
  starts = 0;
  Arena arena;
  for (uint32_t i = 0; i < 20000; ++i) {
    auto point = scene.look(
        {(unitNumber(hash(i, 1)) - 0.5) * spread, (unitNumber(hash(i, 2)) - 0.5) * spread, 4});
    if (!point)
      continue;
    Vec3d direction = randomDirection(i);
    if (dot(direction, point->frame.normal) < 0)
      direction = -direction;
    Arena::Scope scope(arena);
    RayStarts rays(arena, 1);
    rays.set(0, *point);
    float P[3], R[3];
    for (int k = 0; k < 3; ++k)
      P[k] = float(point->frame.P[k]), R[k] = float(direction[k]);
    AskedRays asked;
    makeTraceRays(rays, 0, 1, P, R, asked);
    ++starts;
    hits += scene.shoot(asked.ray(0, 0), SpecularRays).isHit();
  }
  return hits;
}

} // namespace

TEST_CASE("a straight curve: its width, parameters and frame", "[curves]") {
  for (const char *curve :
       {"Curves \"linear\" [2] \"nonperiodic\" \"P\" [-2 0 0  2 0 0] \"constantwidth\" [0.5]",
        "Curves \"cubic\" [4] \"nonperiodic\" \"P\" [-2 0 0  -0.66666666666 0 0  0.66666666666 0 0 "
        " 2 0 0] "
        "\"width\" [0.5 0.5]",
        "Basis \"b-spline\" 1 \"b-spline\" 1 Curves \"cubic\" [4] \"nonperiodic\" "
        "\"P\" [-6 0 0  -2 0 0  2 0 0  6 0 0] \"vertex float width\" [0.5 0.5 0.5 0.5]"}) {
    TestScene scene(std::string("WorldBegin Translate 0 0 4 ") + curve + " WorldEnd");
    INFO(curve);
    CHECK(scene.warnings.count() == 0);
    auto down = [&](double x, double y) {
      Ray ray;
      ray.origin = Vec3f(Vec3d(x, y, 0));
      ray.direction = {0, 0, 1};
      return scene.look(ray);
    };
    CHECK(down(1, 0.24));
    CHECK(down(1, -0.24));
    CHECK_FALSE(down(1, 0.26));
    CHECK_FALSE(down(1, -0.26));
    CHECK_FALSE(down(2.05, 0));
    auto point = down(1, 0.125);
    REQUIRE(point);
    CHECK(point->frame.v == Approx(0.75).epsilon(1e-3));
    CHECK(maxAbs(point->frame.dPdv - Vec3d(4, 0, 0)) < 1e-4);
    // Half of the radius aside is a sixth of half the tube's round.
    CHECK(length(point->frame.dPdu) == Approx(std::numbers::pi / 4).epsilon(1e-4));
    CHECK(std::fabs(point->frame.u - 0.5) == Approx(1. / 6).epsilon(1e-3));
    CHECK(length(point->frame.P - Vec3d(point->frame.P.x, 0, 4)) == Approx(0.25).epsilon(1e-6));
    CHECK(point->s == point->frame.u);
    CHECK(point->t == point->frame.v);
    // Towards the eye, across the curve, and the normal of (u, v).
    CHECK(point->normal.y == Approx(0.5).epsilon(1e-3));
    CHECK(point->normal.z < 0);
    CHECK(point->normal.x == Approx(0).margin(1e-6));
    CHECK(maxAbs(normalized(cross(point->frame.dPdu, point->frame.dPdv)) - point->normal) < 1e-6);
  }
}

TEST_CASE("curves bend as their basis says, and carry variables of every class", "[curves]") {
  // Two curves; the second is x = t, y = t^2 by its Bezier points, 3 units to the left.
  TestScene scene(
      "WorldBegin Translate 0 0 4 Curves \"cubic\" [4 7] \"nonperiodic\" \"P\" ["
      "0 0 0  0.333333333 0 0  0.666666667 0.333333333 0  1 1 0  "
      "-3 0 0  -2.8 0 0  -2.6 0 0  -2.5 0 0  -2.4 0 0  -2.2 0 0  -2 0 0] "
      "\"constantwidth\" [0.02] \"uniform float which\" [7 8] \"constant color Cs\" [1 0.5 0] "
      "\"varying float a\" [0 1  10 20 40] \"vertex float b\" [0 0 0.333333333 1  0 0 0 0 0 0 0] "
      "WorldEnd");
  CHECK(scene.warnings.count() == 0);
  for (double t : {0.1, 0.5, 0.8}) {
    Vec3d direction(t, t * t, 4);
    auto point = scene.look(direction);
    REQUIRE(point);
    CHECK(point->frame.v == Approx(t).epsilon(0.02));
    CHECK(point->color == Vec3d(1, 0.5, 0));
    CHECK(scene.value(direction, "which") == std::vector<float>{7});
    CHECK(scene.value(direction, "a").at(0) == Approx(point->frame.v).epsilon(1e-5));
    CHECK(scene.value(direction, "b").at(0) ==
          Approx(point->frame.v * point->frame.v).epsilon(1e-4));
    CHECK(normalized(point->frame.dPdv).y / normalized(point->frame.dPdv).x ==
          Approx(2 * t).epsilon(0.03));
  }
  Vec3d second(-2.25, 0, 4);
  CHECK(scene.value(second, "which") == std::vector<float>{8});
  CHECK(scene.value(second, "a").at(0) > 20);
  CHECK(scene.look(second)->frame.v > 0.5);
}

TEST_CASE("a ribbon with normals lies as they say", "[curves]") {
  // Flat on the floor: seen from above it has its width, and an edge seen from the side.
  std::string curve =
      "Curves \"linear\" [3] \"nonperiodic\" \"P\" [-2 0 0  0 0 0  2 0 0] "
      "\"constantwidth\" [1] \"N\" [0 1 0  0 1 0  0 1 0] \"varying float a\" [0 1 2] ";
  TestScene above("WorldBegin Translate 0 0 4 Rotate -90 1 0 0 " + curve + "WorldEnd");
  auto point = above.look({1, 0.25, 4});
  REQUIRE(point);
  CHECK(maxAbs(point->frame.P - Vec3d(1, 0.25, 4)) < 1e-5);
  CHECK(point->frame.v == Approx(0.75).epsilon(1e-5));
  CHECK(std::fabs(point->normal.z) == Approx(1));
  CHECK(above.value({1, 0.25, 4}, "a").at(0) == Approx(1.5).epsilon(1e-5));
  CHECK_FALSE(above.look({1, 0.55, 4}));
  TestScene side("WorldBegin Translate 0 0 4 " + curve + "WorldEnd");
  CHECK_FALSE(side.look({1, 0.25, 4}));
}

TEST_CASE("points are spheres, or discs where they have normals", "[curves]") {
  TestScene scene(
      "WorldBegin Translate 0 0 4 Scale 2 2 2 Points \"P\" [0 0 0  1 0 0] \"width\" [0.5 0.25] "
      "\"varying color Cs\" [1 0 0  0 1 0] \"uniform float[2] all\" [3 4] WorldEnd");
  auto point = scene.look({0, 0, 1});
  REQUIRE(point);
  CHECK(point->frame.P.z == Approx(3.5).epsilon(1e-6));
  CHECK(point->normal == Vec3d(0, 0, -1));
  CHECK(point->color == Vec3d(1, 0, 0));
  CHECK(scene.look({2, 0, 4})->color == Vec3d(0, 1, 0));
  CHECK(scene.value({0, 0, 1}, "all") == std::vector<float>{3, 4});
  CHECK_FALSE(scene.look({0.53, 0, 4}));
  CHECK_FALSE(scene.look({1.7, 0, 4}));

  TestScene disc("WorldBegin Translate 0 0 4 Points \"P\" [0 0 0] \"constantwidth\" [2] \"N\" [1 0 "
                 "-1] WorldEnd");
  point = disc.look({0.25, 0, 4});
  REQUIRE(point);
  CHECK(point->frame.P.z - 4 == Approx(point->frame.P.x).epsilon(1e-4)); // in the plane
  CHECK(maxAbs(point->normal - normalized(Vec3d(1, 0, -1))) < 1e-6);
}

TEST_CASE("rays that leave curves and points do not meet them", "[curves]") {
  for (const char *scale : {"1 1 1", "100 100 100", "0.01 0.01 0.01"}) {
    std::string at = std::string("WorldBegin Scale ") + scale + " Translate 0 0 4 ";
    for (const char *shape :
         {"Curves \"linear\" [2] \"nonperiodic\" \"P\" [-1 -1 0  1 1 0.5] \"constantwidth\" [0.5]",
          "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-1 -1 0  1 1 0.5] \"constantwidth\" [0.5] "
          "\"constant normal N\" [0 0.3 -1]",
          "Points \"P\" [0 0 0] \"constantwidth\" [2]",
          "Points \"P\" [0 0 0] \"constantwidth\" [2] \"N\" [0.2 0.3 -1]"}) {
      TestScene scene(at + shape + " WorldEnd");
      int starts;
      INFO(shape << " at " << scale);
      CHECK(falseHits(scene, 2, starts) == 0);
      CHECK(starts > 500);
    }
  }
}

TEST_CASE("wrong curves and points are left out", "[curves]") {
  auto check = [](const std::string &shape, const std::string &message) {
    TestScene scene("WorldBegin " + shape + " WorldEnd");
    INFO(shape);
    CHECK(scene.description.shapes.empty());
    CHECK(scene.warnings.count() == 1);
    CHECK(scene.warnings.contains(message));
  };
  check("Curves \"quadratic\" [3] \"nonperiodic\" \"P\" []",
        "\"quadratic\" is neither linear nor cubic");
  check("Curves \"cubic\" [5] \"nonperiodic\" \"P\" []",
        "5 vertices do not make a nonperiodic cubic curve, with a step of 3 in Basis");
  check("Curves \"linear\" [2] \"nonperiodic\" \"P\" [0 0 0]",
        "\"P\": expected 6 numbers, 2 vertex values");
  check("Curves \"linear\" [2] \"nonperiodic\"", "curves need their vertices");
  check("Points \"width\" [1]", "points need their places");
  check("Points \"P\" [0 0 0 1 1 1] \"width\" [1]",
        "\"width\": expected 2 numbers, 2 varying values");
}
