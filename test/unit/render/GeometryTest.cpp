//===-- test/unit/render/GeometryTest.cpp - surfaces, rays and their starts
//--------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/render/TestScene.h"

#include "tools/anysl-render/Host.h"

#include <catch2/catch.hpp>

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

/// The ray that a shader at the point gets for a direction.
Ray restart(const SurfacePoint &point, Vec3d direction) {
  Arena arena;
  RayStarts starts(arena, 1);
  starts.set(0, point);
  float P[3], R[3];
  for (int k = 0; k < 3; ++k) {
    P[k] = float(point.frame.P[k]);
    R[k] = float(direction[k]);
  }
  AskedRays rays;
  makeTraceRays(starts, 0, 1, P, R, rays);
  REQUIRE(rays.valid[0]);
  return rays.ray(0, 0);
}

/// Shoots at an object, starts a second ray from each hit into the outer half space and counts how
/// often it meets the convex object that it starts from.
void checkRestarts(const std::string &shape, double scale) {
  std::string s = std::to_string(scale);
  TestScene scene("WorldBegin Translate 0 0 " + std::to_string(4 * scale) + " Scale " + s + " " +
                  s + " " + s + " Rotate 30 1 2 3 " + shape + " WorldEnd");
  int starts = 0, falseHits = 0;
  for (uint32_t i = 0; i < 100000; ++i) {
    Ray ray;
    Vec3d aim(unitNumber(hash(i, 1)) - 0.5, unitNumber(hash(i, 2)) - 0.5, 4);
    ray.direction = Vec3f(normalized(aim));
    Hit hit = scene.shoot(ray);
    if (!hit.isHit())
      continue;
    SurfacePoint point;
    scene.geometry->evaluate(hit, ray.origin, ray.direction, 0, point);
    Vec3d direction = randomDirection(i);
    if (dot(direction, point.frame.normal) < 0)
      direction = -direction;
    // Grazing directions are the hard ones.
    if (i % 2)
      direction = normalized(direction -
                             point.frame.normal * (dot(direction, point.frame.normal) * 0.9999));
    // Rounding may tip a tangent to the inner side.
    if (dot(Vec3d(Vec3f(direction)), point.frame.normal) < 1e-6)
      continue;
    ++starts;
    falseHits += scene.shoot(restart(point, direction)).isHit();
  }
  INFO(shape << " at scale " << scale);
  CHECK(starts > 20000);
  CHECK(falseHits == 0);
}

} // namespace

TEST_CASE("rays that leave a sphere do not meet it at any scale", "[geometry]") {
  for (double scale : {1.0, 1e2, 1e4, 1e6})
    checkRestarts("Sphere 1 -1 1 360", scale);
}

TEST_CASE("rays that leave a cube do not meet it at any scale", "[geometry]") {
  for (double scale : {1.0, 1e2, 1e4, 1e6})
    checkRestarts("PointsPolygons [4 4 4 4 4 4] "
                  "[0 2 3 1  4 5 7 6  0 1 5 4  2 6 7 3  0 4 6 2  1 3 7 5] "
                  "\"P\" [-1 -1 -1  1 -1 -1  -1 1 -1  1 1 -1  -1 -1 1  1 -1 1  -1 1 1  1 1 1]",
                  scale);
}

TEST_CASE("rays that start on a large floor near the eye do not meet it", "[geometry]") {
  TestScene scene("WorldBegin Polygon \"P\" [-1000 -0.01 -1000  1000 -0.01 -1000  1000 -0.01 1000  "
                  "-1000 -0.01 1000] WorldEnd");
  int falseHits = 0;
  for (uint32_t i = 0; i < 20000; ++i) {
    Ray ray;
    ray.direction =
        Vec3f(normalized(Vec3d(unitNumber(hash(i, 1)) - 0.5, -0.5, unitNumber(hash(i, 2)))));
    Hit hit = scene.shoot(ray);
    REQUIRE(hit.isHit());
    SurfacePoint point;
    scene.geometry->evaluate(hit, ray.origin, ray.direction, 0, point);
    Vec3d up = randomDirection(i);
    up.y = std::fabs(up.y) * 1e-3;
    falseHits += scene.shoot(restart(point, up)).isHit();
  }
  CHECK(falseHits == 0);
}

TEST_CASE("a camera far from the world's origin sees as exactly as one near it", "[geometry]") {
  TestScene scene("Translate 0 0 5 Translate -10000000 -20000000 30000000 WorldBegin "
                  "Translate 10000000 20000000 -30000000 Sphere 1 -1 1 360 WorldEnd");
  Ray ray;
  ray.direction = {0, 0, 1};
  Hit hit = scene.shoot(ray);
  REQUIRE(hit.isHit());
  CHECK(hit.t == 4.0f);
}

TEST_CASE("packets find what single rays find", "[geometry]") {
  TestScene scene(
      "WorldBegin Translate 0 0 4 Sphere 1 -0.5 1 270 Translate 1.5 0 0 Cylinder 0.5 -1 1 360 "
      "Translate -3 0 0 Polygon \"P\" [-0.5 -1 0  0.5 -1 0  0 1 0.5] WorldEnd");
  for (uint32_t group = 0; group < 64; ++group) {
    RTCRayHit16 packet = {};
    alignas(64) int valid[16];
    Ray rays[16];
    for (uint32_t i = 0; i < 16; ++i) {
      rays[i].direction =
          Vec3f(normalized(Vec3d(unitNumber(hash(group, 2 * i)) * 1.6 - 0.8,
                                 unitNumber(hash(group, 2 * i + 1)) * 0.8 - 0.4, 1)));
      valid[i] = i % 5 ? -1 : 0;
      packet.ray.dir_x[i] = rays[i].direction.x;
      packet.ray.dir_y[i] = rays[i].direction.y;
      packet.ray.dir_z[i] = rays[i].direction.z;
      packet.ray.tfar[i] = 1e30f;
      packet.ray.mask[i] = CameraRays;
      packet.hit.geomID[i] = packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    scene.geometry->intersect<16>(valid, packet);
    for (uint32_t i = 0; i < 16; ++i) {
      if (!valid[i]) {
        CHECK(packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID);
        continue;
      }
      Hit hit = scene.shoot(rays[i]);
      CHECK(packet.hit.geomID[i] == hit.geometry);
      if (hit.isHit()) {
        CHECK(packet.hit.primID[i] == hit.primitive);
        CHECK(packet.ray.tfar[i] == Approx(hit.t).epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("visibility hides surfaces from kinds of rays", "[geometry]") {
  TestScene scene(
      "WorldBegin Translate 0 0 4 AttributeBegin Attribute \"visibility\" \"camera\" [0] "
      "Sphere 1 -1 1 360 AttributeEnd AttributeBegin Attribute \"visibility\" \"trace\" [0] "
      "\"transmission\" [\"transparent\"] Translate 0 0 4 Sphere 1 -1 1 360 AttributeEnd "
      "Opacity 0.5 0.5 0.5 Translate 0 0 8 Sphere 1 -1 1 360 WorldEnd");
  Ray ray;
  ray.direction = {0, 0, 1};
  CHECK(scene.shoot(ray, CameraRays).t == 7);
  CHECK(scene.shoot(ray, SpecularRays).t == 3);
  CHECK(scene.shoot(ray, DiffuseRays).t == 3);
  CHECK(scene.shoot(ray, OpaqueShadowRays).t == 3);
  CHECK(scene.shoot(ray, PartialShadowRays).t == 11);
  CHECK(scene.geometry->opacityAt(scene.shoot(ray, PartialShadowRays), ray.origin, ray.direction) ==
        Vec3d(0.5));
}

TEST_CASE("specular and diffuse rays see surfaces of their own", "[geometry]") {
  TestScene scene(
      "WorldBegin Translate 0 0 4 AttributeBegin Attribute \"visibility\" \"diffuse\" [0] "
      "Sphere 1 -1 1 360 AttributeEnd AttributeBegin Attribute \"visibility\" \"specular\" [0] "
      "Translate 0 0 -3 Sphere 0.5 -0.5 0.5 360 AttributeEnd Translate 0 0 4 Sphere 1 -1 1 360 "
      "WorldEnd");
  Ray ray;
  ray.direction = {0, 0, 1};
  CHECK(scene.shoot(ray, CameraRays).t == 0.5);
  CHECK(scene.shoot(ray, SpecularRays).t == 3);
  CHECK(scene.shoot(ray, DiffuseRays).t == 0.5);
}

TEST_CASE("a polygon's normal, texture coordinates and colours", "[geometry]") {
  TestScene scene("WorldBegin Translate 0 0 2 Polygon \"P\" [-1 -1 0  1 -1 0  1 1 0  -1 1 0] "
                  "\"st\" [0 0 4 0 4 4 0 4] \"Cs\" [0 0 0  1 0 0  1 1 0  0 1 0] WorldEnd");
  Ray ray;
  ray.direction = Vec3f(normalized({0.25, 0.125, 1}));
  Hit hit = scene.shoot(ray);
  REQUIRE(hit.isHit());
  SurfacePoint point;
  scene.geometry->evaluate(hit, ray.origin, ray.direction, ~uint64_t(0), point);
  // Anticlockwise as components go: the normal is +z in object space, away from this camera.
  CHECK(point.frame.normal == Vec3d(0, 0, 1));
  CHECK(point.s == Approx(3).epsilon(1e-5));
  CHECK(point.t == Approx(2.5).epsilon(1e-5));
  CHECK(point.color.x == Approx(0.75).epsilon(1e-5));
  CHECK(point.color.y == Approx(0.625).epsilon(1e-5));
  CHECK(point.frame.u == Approx(0.5).epsilon(1e-5)); // u and v are x and y of object space
  CHECK(maxAbs(point.frame.dPdu - Vec3d(1, 0, 0)) < 1e-12);
  CHECK(maxAbs(point.frame.dPdv - Vec3d(0, 1, 0)) < 1e-12);
}

TEST_CASE("rays that shaders ask for, one or sixteen at once", "[geometry]") {
  Arena arena;
  RayStarts starts(arena, 16);
  for (size_t i = 0; i < 16; ++i) {
    SurfacePoint point;
    point.frame.P = {0, 0, 1000.0 + double(i)};
    point.frame.normal = {0, 0, -1};
    point.offset = 1000 * 0x1p-18f;
    starts.set(i, point);
  }
  float here[48], light[48];
  for (int i = 0; i < 16; ++i) {
    here[i] = here[16 + i] = 0;
    here[32 + i] = 1000.0f + float(i);
    light[i] = float(i + 1);
    light[16 + i] = 5;
    light[32 + i] = 0;
  }
  AskedRays rays;
  makeShadowRays(starts, 0, 16, light, here, rays); // from a light to the point
  for (uint32_t i = 0; i < 16; ++i) {
    Ray ray = rays.ray(i, 0);
    CHECK(rays.valid[i]);
    CHECK(ray.far * ray.direction.z + ray.origin.z < here[32 + i] - 0.5f * starts.offset[i]);
  }
  makeShadowRays(starts, 0, 16, here, light, rays);
  for (uint32_t i = 0; i < 16; ++i) {
    CHECK(rays.origin[2][i] < here[32 + i]); // on the side that the light is on
    AskedRays single;
    float from[3] = {here[i], here[16 + i], here[32 + i]},
          to[3] = {light[i], light[16 + i], light[32 + i]};
    makeShadowRays(starts, i, 1, from, to, single);
    CHECK(single.ray(0, 0).origin == rays.ray(i, 0).origin);
    CHECK(single.ray(0, 0).direction == rays.ray(i, 0).direction);
    CHECK(single.far[0] == rays.far[i]);
  }
  makeShadowRays(starts, 0, 16, light, light, rays);
  CHECK_FALSE(rays.valid[3]);

  float directions[48] = {};
  directions[0] = 1e30f;  // long
  directions[1] = 1e-30f; // short
  directions[2] = NAN;    // none, as all that follow
  makeTraceRays(starts, 0, 16, light, directions, rays);
  CHECK(rays.valid[0]);
  CHECK(rays.ray(0, 0).direction == Vec3f(1, 0, 0));
  CHECK(rays.ray(0, 0).origin == Vec3f(1, 5, 0)); // no shader's point: not moved
  CHECK(rays.ray(1, 0).direction == Vec3f(1, 0, 0));
  for (uint32_t i = 2; i < 16; ++i)
    CHECK_FALSE(rays.valid[i]);
}

TEST_CASE("a tessellated sphere with normals has no steps at the shadow terminator", "[geometry]") {
  const double pi = 3.14159265358979323846;
  std::string counts, vertices, points;
  const int columns = 24, rows = 12;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      double theta = 2 * pi * column / columns, phi = pi * (double(row) / rows - 0.5);
      for (double x :
           {std::cos(phi) * std::cos(theta), std::cos(phi) * std::sin(theta), std::sin(phi)})
        points += std::to_string(x) + " ";
    }
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      int corner = row * (columns + 1) + column;
      counts += "3 3 ";
      for (int vertex : {corner, corner + 1, corner + columns + 2, corner, corner + columns + 2,
                         corner + columns + 1})
        vertices += std::to_string(vertex) + " ";
    }
  TestScene scene("WorldBegin Translate 0 0 4 PointsPolygons [" + counts + "] [" + vertices +
                  "] \"P\" [" + points + "] \"N\" [" + points + "] WorldEnd");
  Arena arena;
  double darkest = 0;
  int tried = 0;
  for (uint32_t i = 0; i < 40000; ++i) {
    Ray ray;
    ray.direction = Vec3f(normalized(
        Vec3d(unitNumber(hash(i, 1)) * 0.5 - 0.25, unitNumber(hash(i, 2)) * 0.5 - 0.25, 1)));
    Hit hit = scene.shoot(ray);
    if (!hit.isHit())
      continue;
    SurfacePoint point;
    scene.geometry->evaluate(hit, ray.origin, ray.direction, 0, point);
    // Directions near the terminator, on its lit side.
    Vec3d toLight = randomDirection(i);
    toLight = normalized(toLight - point.normal * dot(toLight, point.normal));
    toLight = normalized(toLight + point.normal * (0.25 * unitNumber(hash(i, 3))));
    Arena::Scope scope(arena);
    RayStarts starts(arena, 1);
    starts.set(0, point);
    float from[3], to[3];
    for (int k = 0; k < 3; ++k) {
      from[k] = float(point.frame.P[k]);
      to[k] = from[k] + float(100 * toLight[k]);
    }
    AskedRays rays;
    makeShadowRays(starts, 0, 1, from, to, rays);
    REQUIRE(rays.valid[0]);
    ++tried;
    if (scene.shoot(rays.ray(0, 0), OpaqueShadowRays).isHit())
      darkest = std::max(darkest, dot(point.normal, toLight));
  }
  CHECK(tried > 10000);
  // What a white surface loses there, in parts of full light.
  CHECK(darkest < 1.0 / 255);
}

TEST_CASE("shapes without extent and of enormous size do no harm", "[geometry]") {
  for (const char *shape :
       {"Polygon \"P\" [-1e30 0 0 1e30 0 0 0 1e30 0]", "Polygon \"P\" [0 0 0 0 0 0 0 0 0]",
        "Polygon \"P\" [-1e300 0 0 1e300 0 0 0 1e300 0]",
        "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-1e30 0 0 1e30 0 0] \"constantwidth\" [1e30]",
        "Curves \"cubic\" [4] \"nonperiodic\" \"P\" [0 0 0 0 0 0 0 0 0 0 0 0] \"constantwidth\" "
        "[0]",
        "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-1 0 0 1 0 0] \"constantwidth\" [-1]",
        "Points \"P\" [1e30 0 0 0 0 0] \"constantwidth\" [1e30]",
        "Points \"P\" [0 0 0] \"constantwidth\" [1] \"N\" [0 0 0]",
        "SubdivisionMesh \"catmull-clark\" [4] [0 1 2 3] [\"interpolateboundary\"] [0 0] [] [] "
        "\"P\" [-1e30 -1 0 1 -1 0 1 1 0 -1 1 0]",
        "SubdivisionMesh \"catmull-clark\" [3 3 3] [0 1 2 0 1 3 0 1 4] [\"interpolateboundary\"] "
        "[0 0] [] [] \"P\" [0 0 0 1 0 0 0 1 0 0 0 1 1 1 1]",
        "SubdivisionMesh \"catmull-clark\" [4] [0 1 2 3] [\"interpolateboundary\"] [0 0] [] [] "
        "\"P\" [0 0 0 0 0 0 0 0 0 0 0 0]",
        "Patch \"bilinear\" \"P\" [0 0 0 0 0 0 0 0 0 0 0 0]",
        "Patch \"bilinear\" \"Pw\" [0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0]",
        "Patch \"bilinear\" \"P\" [-1e200 0 0 1 0 0 0 1 0 1e200 1 0]"}) {
    INFO(shape);
    TestScene scene(std::string("WorldBegin Translate 0 0 5 ") + shape + " WorldEnd");
    for (double x : {-0.2, 0.0, 0.1})
      if (auto point = scene.look({x, 0.05, 1}))
        CHECK(isFinite(point->frame.P));
  }
}
