//===-- tools/anysl-render/AreaLights.cpp - points of shapes that shine -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/AreaLights.h"

#include "lib/Rib/PrimitiveVariables.h"
#include "tools/anysl-render/Curves.h"
#include "tools/anysl-render/PointSet.h"
#include "tools/anysl-render/Tessellate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace anysl::render;

namespace {

constexpr unsigned gridSide = 4;     ///< samples of a quadric along u and v
constexpr size_t mostSubdivided = 8; ///< triangles in a shape, for four samples each
constexpr size_t most = 32;          ///< samples of a shape that has more triangles, or points
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
  Sampler(const Shape &shape, const Appearance &appearance, const Camera &camera)
      : shape(shape), camera(camera), placement(shape.objectToCamera, appearance) {}

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
        Vec3d normal = cross(byU, byV) * placement.normalSign;
        put(at(0, 0), normal, length(normal));
      }
  }

  /// Spheres have points all round, of equal areas; discs one in the middle.
  void add(const PointsShape &) {
    const PointSet set(shape.variables, placement);
    const size_t count = set.vertices.size();
    const size_t each =
        set.normals.empty() ? std::max<size_t>(1, most / std::max<size_t>(1, count)) : 1;
    const size_t drawn = std::min(count, most);
    for (size_t i = 0; i < drawn; ++i) {
      const size_t point = i * count / drawn;
      const auto [x, y, z, radius] = set.vertices[point];
      const double area = std::numbers::pi * radius * radius * double(count) / double(drawn);
      for (size_t k = 0; k < each; ++k)
        if (set.normals.empty()) {
          Vec3d direction = onSphere(i * each + k, drawn * each);
          put(Vec3d(x, y, z) + direction * double(radius), direction, 4 * area / double(each));
        } else {
          put(Vec3d(x, y, z), Vec3d(set.normals[point]), area);
        }
    }
  }

  /// Tubes have points all round and all along; ribbons are facets.
  void add(const CurvesShape &curves) {
    if (findParameter(shape.variables, "N"))
      return addFacets();
    const CurveSegments tubes(curves, shape.variables, placement);
    std::vector<double> ends; ///< lengths up to each segment's end
    for (const CurveSegments::Segment &segment : tubes.all())
      ends.push_back((ends.empty() ? 0 : ends.back()) + lengthOf(segment));
    for (size_t i = 0; !ends.empty() && i < most; ++i) {
      const double at = ends.back() * (double(i) + 0.5) / double(most);
      const auto end = std::upper_bound(ends.begin(), ends.end() - 1, at);
      const auto &segment = tubes.all()[size_t(end - ends.begin())];
      const double begin = end == ends.begin() ? 0 : end[-1];
      Vec3d tangent;
      double radius;
      Vec3d middle = CurveSegments::place(segment, (at - begin) / (*end - begin), tangent, radius);
      Vec3d across = normalized(cross(tangent, leastAlong(tangent)));
      Vec3d up = normalized(cross(tangent, across));
      const double turn = 2 * std::numbers::pi * std::numbers::phi * double(i);
      Vec3d out = across * std::cos(turn) + up * std::sin(turn);
      put(middle + out * radius, out, 2 * std::numbers::pi * radius * ends.back() / double(most));
    }
  }

  /// Of other shapes facets: their middles, or places spread evenly over many.
  template <class Other>
  void add(const Other &) {
    addFacets();
  }

private:
  void addFacets() {
    const std::unique_ptr<Mesh> mesh = tessellate(shape, placement, Dicing(camera));
    std::vector<Facet> facets;
    double total = 0;
    for (const auto &[a, b, c] : mesh->triangles) {
      facets.push_back({Vec3d(mesh->points[a]), Vec3d(mesh->points[b]), Vec3d(mesh->points[c])});
      if (double area = length(facets.back().normal()); area > 0 && std::isfinite(area))
        total += area;
      else
        facets.pop_back();
    }
    if (facets.size() <= most) {
      for (const Facet &facet : facets)
        facets.size() <= mostSubdivided ? putParts(facet)
                                        : putMiddle(facet, length(facet.normal()));
      return;
    }
    double passed = 0; // the area of all facets before
    for (const Facet &facet : facets) {
      auto rank = [&](double area) { return std::floor(area / total * double(most) + 0.5); };
      const double area = length(facet.normal());
      if (rank(passed + area) > rank(passed))
        putMiddle(facet, (rank(passed + area) - rank(passed)) * total / double(most));
      passed += area;
    }
  }

  struct Facet {
    Vec3d a, b, c;
    /// As long as it is large.
    Vec3d normal() const { return cross(b - a, c - a) * 0.5; }
    Vec3d middle() const { return (a + b + c) * (1. / 3); }
  };

  void putMiddle(const Facet &facet, double area) {
    put(facet.middle(), facet.normal() * placement.normalSign, area);
  }

  void putParts(const Facet &facet) {
    const auto &[a, b, c] = facet;
    Vec3d ab = (a + b) * 0.5, bc = (b + c) * 0.5, ca = (c + a) * 0.5;
    for (const Facet &part : {Facet{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
      putMiddle(part, length(part.normal()));
  }

  static double lengthOf(const CurveSegments::Segment &segment) {
    double result = 0, radius;
    Vec3d tangent, last = segment.points[0];
    for (int i = 1; i <= 8; ++i) {
      Vec3d next = CurveSegments::place(segment, i / 8., tangent, radius);
      result += length(next - last);
      last = next;
    }
    return result;
  }

  /// The axis that a direction runs along least.
  static Vec3d leastAlong(Vec3d v) {
    double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
    return x <= y && x <= z ? Vec3d(1, 0, 0) : y <= z ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
  }

  /// One of some directions that are spread evenly, on a spiral whose turns are golden sections.
  static Vec3d onSphere(size_t number, size_t count) {
    double z = 1 - (2 * double(number) + 1) / double(count), r = std::sqrt(1 - z * z);
    double turn = 2 * std::numbers::pi * std::numbers::phi * double(number);
    return Vec3d(r * std::cos(turn), r * std::sin(turn), z);
  }

  void put(Vec3d P, Vec3d normal, double area) {
    double its = length(normal);
    if (its > 0 && area > 0 && std::isfinite(its) && std::isfinite(area) && isFinite(P))
      samples.push_back({P, normal * (1 / its), area});
  }

  const Shape &shape;
  const Camera &camera;
  Placement placement;
};

} // namespace

std::vector<AreaSample> anysl::render::areaSamples(const Shape &shape, const Appearance &appearance,
                                                   const Camera &camera) {
  Sampler sampler(shape, appearance, camera);
  std::visit([&](const auto &geometry) { sampler.add(geometry); }, shape.geometry);
  return std::move(sampler.samples);
}
