//===-- test/unit/render/TestScene.h - surfaces from a line of RIB ----------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_RENDER_TESTSCENE_H
#define ANYSL_TEST_RENDER_TESTSCENE_H

#include "lib/Rib/RibReader.h"
#include "tools/anysl-render/Geometry.h"
#include "tools/anysl-render/Tessellate.h"

#include <cstring>
#include <optional>

namespace anysl::render {

struct TestScene {
  explicit TestScene(const std::string &rib) {
    auto file = std::make_shared<SourceFile>();
    file->name = "test.rib";
    file->text = rib;
    description = readRib(file, warnings).at(0);
    groups.resize(description.shapes.size());
    geometry = std::make_unique<Geometry>(description, Camera(description.camera), groups);
  }
  Hit shoot(const Ray &ray, unsigned mask = CameraRays) const {
    return geometry->intersect(ray, mask);
  }
  /// What is met in a direction from the eye, with everything that a shader may ask.
  std::optional<SurfacePoint> look(Vec3d direction, Hit *hit = nullptr) const {
    Ray ray;
    ray.direction = Vec3f(normalized(direction));
    return look(ray, hit);
  }
  std::optional<SurfacePoint> look(const Ray &ray, Hit *hit = nullptr) const {
    Hit found = shoot(ray);
    if (hit)
      *hit = found;
    if (!found.isHit())
      return std::nullopt;
    SurfacePoint point;
    geometry->evaluate(found, ray.origin, ray.direction, ~uint64_t(0), point);
    return point;
  }
  /// The value of a variable where a ray meets the scene; at most 16 numbers.
  std::vector<float> value(Vec3d direction, const std::string &name) const {
    Hit hit;
    std::optional<SurfacePoint> point = look(direction, &hit);
    std::vector<float> result;
    if (!point)
      return result;
    const auto &list = geometry->variablesOf(hit).list;
    for (uint32_t i = 0; i < list.size(); ++i)
      if (list[i].name == name) {
        result.resize(list[i].components);
        geometry->variablesAt(hit, *point).value(i, result.data());
      }
    return result;
  }
  Warnings warnings;
  SceneDescription description;
  std::vector<uint32_t> groups;
  std::unique_ptr<Geometry> geometry;
};

/// The facets of a scene's first shape.
inline std::unique_ptr<Mesh> facets(const TestScene &scene) {
  const Shape &shape = scene.description.shapes.at(0);
  Camera camera(scene.description.camera);
  return tessellate(shape, Placement(shape.objectToCamera, scene.description.appearances.at(0)),
                    Dicing(camera));
}

inline double area(const Mesh &mesh) {
  double sum = 0;
  for (const auto &[a, b, c] : mesh.triangles) {
    Vec3d p(mesh.points[a]), q(mesh.points[b]), r(mesh.points[c]);
    sum += 0.5 * length(cross(q - p, r - p));
  }
  return sum;
}

/// How many edges do not belong to two facets.
inline size_t openEdges(const Mesh &mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  for (const auto &triangle : mesh.triangles)
    for (size_t k = 0; k < 3; ++k)
      ++edges[std::minmax(triangle[k], triangle[(k + 1) % 3])];
  size_t open = 0;
  for (const auto &[edge, count] : edges)
    open += count != 2;
  return open;
}

} // namespace anysl::render

#endif
