//===-- test/unit/render/CameraTest.cpp - camera rays and named spaces
//-------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Sampling.h"
#include "tools/anysl-render/Spaces.h"

#include <catch2/catch.hpp>

using namespace anysl::render;

namespace {
bool spaceMatrix(const SceneDescription &scene, const Camera &camera, const Matrix4 *shader,
                 const char *from, const char *to, Matrix4 &matrix) {
  Space space(shader ? *shader : Matrix4::identity());
  return Spaces(scene, camera).matrix(shader ? &space : nullptr, nullptr, from, to, matrix);
}

CameraDescription wide() {
  CameraDescription description;
  description.perspective = true;
  description.fov = 90;
  description.width = 200;
  description.height = 100;
  return description;
}
} // namespace

TEST_CASE("the field of view spans the picture's smaller side", "[camera]") {
  Camera camera(wide());
  Vec3f top = camera.ray(100, 0, 0).direction, left = camera.ray(0, 50, 0).direction;
  CHECK(top.y == Approx(std::sqrt(0.5)));
  CHECK(top.z == Approx(std::sqrt(0.5)));
  CHECK(left.x / left.z == Approx(-2));
  CHECK(camera.ray(100, 50, 7).direction == Vec3f(0, 0, 1));
  CHECK(camera.ray(100, 50, 7).seed == 7);
}

TEST_CASE("orthographic rays are parallel", "[camera]") {
  CameraDescription description = wide();
  description.perspective = false;
  Camera camera(description);
  CHECK(camera.ray(200, 0, 0).origin == Vec3f(2, 1, 0));
  CHECK(camera.ray(200, 0, 0).direction == Vec3f(0, 0, 1));
}

TEST_CASE("clipping planes cut rays at a depth, not at a distance", "[camera]") {
  CameraDescription description = wide();
  description.nearClip = 2;
  description.farClip = 10;
  Ray ray = Camera(description).ray(100, 0, 0);
  CHECK(ray.near * ray.direction.z == Approx(2));
  CHECK(ray.far * ray.direction.z == Approx(10));
}

TEST_CASE("raster space is where camera rays come from", "[camera]") {
  for (bool perspective : {true, false}) {
    SceneDescription scene;
    scene.camera = wide();
    scene.camera.perspective = perspective;
    scene.camera.nearClip = 0.1;
    scene.camera.farClip = 1000;
    Camera camera(scene.camera);
    Ray ray = camera.ray(30, 80, 0);
    Vec3d p = Vec3d(ray.origin) + Vec3d(ray.direction) * 3.0;
    Matrix4 toRaster;
    REQUIRE(spaceMatrix(scene, camera, nullptr, "current", "raster", toRaster));
    CHECK(toRaster.point(p).x == Approx(30).epsilon(1e-6));
    CHECK(toRaster.point(p).y == Approx(80).epsilon(1e-6));
    Matrix4 back;
    REQUIRE(spaceMatrix(scene, camera, nullptr, "raster", "camera", back));
    CHECK(maxAbs(back.point(toRaster.point(p)) - p) < 1e-6);
    Matrix4 toNDC;
    REQUIRE(spaceMatrix(scene, camera, nullptr, "camera", "NDC", toNDC));
    CHECK(toNDC.point(p).x == Approx(0.15).epsilon(1e-6));
    CHECK(toNDC.point(p).y == Approx(0.8).epsilon(1e-6));
  }
}

TEST_CASE("named spaces, and names that are none", "[camera]") {
  SceneDescription scene;
  scene.worldToCamera = Matrix4::translation({0, 0, 5});
  scene.spaces["wood"] = Matrix4::scaling({2, 2, 2});
  Camera camera(scene.camera);
  Matrix4 shader = Matrix4::translation({1, 0, 0}), matrix;
  REQUIRE(spaceMatrix(scene, camera, &shader, "current", "world", matrix));
  CHECK(matrix.point({1, 2, 3}) == Vec3d(1, 2, -2));
  REQUIRE(spaceMatrix(scene, camera, &shader, "shader", "wood", matrix));
  CHECK(matrix.point({1, 2, 3}) == Vec3d(1, 1, 1.5));
  matrix = Matrix4::scaling({7, 7, 7});
  CHECK_FALSE(spaceMatrix(scene, camera, &shader, "current", "object", matrix));
  CHECK_FALSE(spaceMatrix(scene, camera, &shader, "nowhere", "world", matrix));
  CHECK(matrix == Matrix4::scaling({7, 7, 7}));
}

TEST_CASE("crop windows that adjoin share no pixel and miss none", "[camera]") {
  CameraDescription description = wide();
  int previous = 0;
  for (int i = 0; i < 7; ++i) {
    description.cropWindow = {i / 7.0, (i + 1) / 7.0, 0, 1};
    int x0, x1, y0, y1;
    Camera(description).cropPixels(x0, x1, y0, y1);
    CHECK(x0 == previous);
    previous = x1;
    CHECK(y0 == 0);
    CHECK(y1 == 100);
  }
  CHECK(previous == 200);
}

TEST_CASE("an edge out of focus is blurred by a disk of the thin lens's size", "[camera]") {
  // A lens of radius 1/2 focused at 2 sees what is at depth 1 over 1/2 |1/1 - 1/2| = 1/4 of the
  // screen's unit: 8 of 32 pixels. A half-plane covers the share of the disk that lies on its side.
  CameraDescription description;
  description.perspective = true;
  description.width = description.height = 64;
  description.lensRadius = 0.5;
  description.focalDistance = 2;
  Camera camera(description);
  SceneDescription scene;
  scene.samplesX = scene.samplesY = 32;
  PixelSampler sampler(scene);
  auto share = [&](double pixels, double depth) {
    double hits = 0;
    for (unsigned i = 0; i < sampler.samplesPerPixel(); ++i) {
      PixelSample sample = sampler.sample(1, 2, i);
      Ray ray = camera.ray(32 + pixels, 32, 0, sample.lensX, sample.lensY);
      hits += ray.origin.x + ray.direction.x / ray.direction.z * depth > 0;
    }
    return hits / sampler.samplesPerPixel();
  };
  auto covered = [](double x, double r) {
    return 0.5 +
           (x * std::sqrt(r * r - x * x) + r * r * std::asin(x / r)) / (3.14159265358979 * r * r);
  };
  CHECK(share(-8.1, 1) == 0);
  CHECK(share(8.1, 1) == 1);
  for (double x : {-6.0, -2.0, 0.0, 4.0})
    CHECK(share(x, 1) == Approx(covered(x, 8)).margin(0.01));
  CHECK(share(-0.01, 2) == 0); // in focus
  CHECK(share(0.01, 2) == 1);
  // Behind it: 1/2 |1/4 - 1/2| = 1/8, 4 pixels.
  CHECK(share(-4.1, 4) == 0);
  CHECK(share(2, 4) == Approx(covered(2, 4)).margin(0.01));
}
