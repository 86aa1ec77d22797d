//===-- test/unit/render/CameraTest.cpp - camera rays and named spaces
//-------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

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
