//===-- tools/anysl-render/AreaLights.cpp - points of shapes that shine -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/AreaLights.h"

#include "lib/Rib/PrimitiveVariables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace anysl::render;

namespace {

constexpr unsigned gridSide = 4;     ///< samples of a quadric along u and v
constexpr size_t mostSubdivided = 8; ///< triangles in a shape, for four samples each
constexpr double radians = std::numbers::pi / 180;

/// The point (u, v) of a quadric in its own space, as the RenderMan Interface defines them.
Vec3d pointOf(const QuadricShape &shape, double u, double v) {
  double theta = u * shape.thetaMax * radians;
  auto turned = [&](double x, double y, double z) {
    return Vec3d(x * std::cos(theta) - y * std::sin(theta),
                 x * std::sin(theta) + y * std::cos(theta), z);
  };
  double r = shape.radius, z = shape.zmin + v * (shape.zmax - shape.zmin);
  switch (shape.kind) {
  case QuadricShape::Sphere: {
    auto latitude = [&](double height) { return std::asin(std::clamp(height / r, -1., 1.)); };
    double phi = latitude(shape.zmin) + v * (latitude(shape.zmax) - latitude(shape.zmin));
    return turned(r * std::cos(phi), 0, r * std::sin(phi));
  }
  case QuadricShape::Cone:
    return turned(r * (1 - v), 0, v * shape.height);
  case QuadricShape::Cylinder:
    return turned(r, 0, z);
  case QuadricShape::Hyperboloid: {
    Vec3d p = lerp(shape.point1, shape.point2, v);
    return turned(p.x, p.y, p.z);
  }
  case QuadricShape::Paraboloid:
    return turned(r * std::sqrt(std::max(0., z / shape.zmax)), 0, z);
  case QuadricShape::Disk:
    return turned(r * (1 - v), 0, shape.height);
  case QuadricShape::Torus: {
    double phi = (shape.phiMin + v * (shape.phiMax - shape.phiMin)) * radians;
    return turned(r + shape.minorRadius * std::cos(phi), 0, shape.minorRadius * std::sin(phi));
  }
  }
  return Vec3d();
}

class Sampler {
public:
  Sampler(const Shape &shape, const Appearance &appearance)
      : shape(shape), placement(shape.objectToCamera, appearance) {}

  std::vector<AreaSample> samples;

  void add(const QuadricShape &quadric) {
    constexpr double step = 1. / gridSide, near = 1e-4;
    for (unsigned i = 0; i < gridSide; ++i)
      for (unsigned j = 0; j < gridSide; ++j) {
        auto at = [&](double du, double dv) {
          return placement.toCamera.point(
              pointOf(quadric, (i + 0.5) * step + du, (j + 0.5) * step + dv));
        };
        Vec3d byU = at(near, 0) - at(-near, 0), byV = at(0, near) - at(0, -near);
        put(at(0, 0), cross(byU, byV));
      }
  }

  void add(const PolygonShape &polygons) {
    std::vector<Vec3d> points = positions(shape.variables);
    for (Vec3d &p : points)
      p = placement.toCamera.point(p);
    size_t triangles = 0;
    for (uint32_t count : polygons.vertexCounts)
      triangles += count < 3 ? 0 : count - 2;
    size_t loop = 0, vertex = 0;
    for (uint32_t loops : polygons.loopCounts)
      for (uint32_t i = 0; i < loops; ++i) {
        uint32_t count = polygons.vertexCounts[loop++];
        // Holes are small beside what they are in.
        for (uint32_t k = 2; i == 0 && k < count; ++k)
          addTriangle(points[polygons.vertices[vertex]], points[polygons.vertices[vertex + k - 1]],
                      points[polygons.vertices[vertex + k]], triangles <= mostSubdivided);
        vertex += count;
      }
  }

  /// Of other shapes the middle of what they are given by.
  template <class Other>
  void add(const Other &) {
    std::vector<Vec3d> points = positions(shape.variables);
    Vec3d sum;
    for (Vec3d p : points)
      sum = sum + placement.toCamera.point(p);
    if (!points.empty())
      samples.push_back({sum * (1. / double(points.size())), Vec3d(), 1});
  }

private:
  void addTriangle(Vec3d a, Vec3d b, Vec3d c, bool subdivide) {
    Vec3d normal = cross(b - a, c - a) * 0.5;
    if (!subdivide)
      return put((a + b + c) * (1. / 3), normal);
    Vec3d ab = (a + b) * 0.5, bc = (b + c) * 0.5, ca = (c + a) * 0.5;
    for (const auto &part : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      put((part[0] + part[1] + part[2]) * (1. / 3), normal * 0.25);
  }

  void put(Vec3d P, Vec3d normal) {
    double area = length(normal);
    if (area > 0 && std::isfinite(area) && isFinite(P))
      samples.push_back({P, normal * (placement.normalSign / area), area});
  }

  const Shape &shape;
  Placement placement;
};

} // namespace

std::vector<AreaSample> anysl::render::areaSamples(const Shape &shape,
                                                   const Appearance &appearance) {
  Sampler sampler(shape, appearance);
  std::visit([&](const auto &geometry) { sampler.add(geometry); }, shape.geometry);
  return std::move(sampler.samples);
}
