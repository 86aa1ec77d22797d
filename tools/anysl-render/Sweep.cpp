//===-- tools/anysl-render/Sweep.cpp - swept surfaces that are no quadrics --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Tessellate.h"

#include <algorithm>
#include <numbers>

using namespace anysl::render;

namespace {

/// A curve in the plane y = 0, swept about z: any quadric, and what is none, the torus.
class Sweep : public PatchGrid {
public:
  Sweep(const QuadricShape &shape, const Matrix4 &toCamera)
      : PatchGrid(1, 1, false, false), shape(shape), toCamera(toCamera) {}

  SurfaceFrame evaluate(uint32_t, uint32_t, double u, double v) const override;
  void vertexValue(const Variable &variable, uint32_t, uint32_t, double u, double v,
                   float *value) const override {
    interpolateCorners(variable, u, v, value);
  }

private:
  /// The curve's point and tangent at v.
  void profile(double v, Vec3d &point, Vec3d &tangent) const;

  const QuadricShape &shape;
  const Matrix4 &toCamera;
};

constexpr double degrees = std::numbers::pi / 180;

void Sweep::profile(double v, Vec3d &point, Vec3d &tangent) const {
  switch (shape.kind) {
  case QuadricShape::Torus: {
    double range = (shape.phiMax - shape.phiMin) * degrees;
    double phi = shape.phiMin * degrees + v * range;
    point = {shape.radius + shape.minorRadius * std::cos(phi), 0,
             shape.minorRadius * std::sin(phi)};
    tangent = Vec3d(-std::sin(phi), 0, std::cos(phi)) * (shape.minorRadius * range);
    return;
  }
  case QuadricShape::Sphere: {
    double r = std::fabs(shape.radius);
    auto latitude = [&](double z) { return std::asin(std::clamp(z / r, -1.0, 1.0)); };
    double low = latitude(shape.zmin), range = latitude(shape.zmax) - low, phi = low + v * range;
    point = Vec3d(std::cos(phi), 0, std::sin(phi)) * r;
    tangent = Vec3d(-std::sin(phi), 0, std::cos(phi)) * (r * range);
    return;
  }
  case QuadricShape::Paraboloid: {
    double range = shape.zmax - shape.zmin, z = shape.zmin + v * range;
    double rho = std::fabs(shape.radius) * std::sqrt(std::max(0.0, z / shape.zmax));
    point = {rho, 0, z};
    tangent = Vec3d(z != 0 ? rho / (2 * z) : 0, 0, 1) * range;
    return;
  }
  case QuadricShape::Cylinder:
    point = {shape.radius, 0, shape.zmin + v * (shape.zmax - shape.zmin)};
    tangent = {0, 0, shape.zmax - shape.zmin};
    return;
  case QuadricShape::Cone:
    point = {shape.radius * (1 - v), 0, shape.height * v};
    tangent = {-shape.radius, 0, shape.height};
    return;
  case QuadricShape::Disk:
    point = {shape.radius * (1 - v), 0, shape.height};
    tangent = {-shape.radius, 0, 0};
    return;
  case QuadricShape::Hyperboloid:
    point = lerp(shape.point1, shape.point2, v);
    tangent = shape.point2 - shape.point1;
    return;
  }
}

SurfaceFrame Sweep::evaluate(uint32_t, uint32_t, double u, double v) const {
  double theta = u * shape.thetaMax * degrees;
  double cosine = std::cos(theta), sine = std::sin(theta);
  auto sweep = [&](Vec3d p) {
    return Vec3d(p.x * cosine - p.y * sine, p.x * sine + p.y * cosine, p.z);
  };
  Vec3d point, tangent;
  profile(v, point, tangent);
  Vec3d p = sweep(point);
  SurfaceFrame frame;
  frame.u = u;
  frame.v = v;
  frame.P = toCamera.point(p);
  frame.dPdu = toCamera.vector(Vec3d(-p.y, p.x, 0) * (shape.thetaMax * degrees));
  frame.dPdv = toCamera.vector(sweep(tangent));
  return frame;
}

} // namespace

std::unique_ptr<Mesh> anysl::render::tessellate(const QuadricShape &shape,
                                                const ParameterList &variables,
                                                const Placement &placement, const Dicing &dicing) {
  return dice(Sweep(shape, placement.toCamera), variables, placement, dicing);
}
