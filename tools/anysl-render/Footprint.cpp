//===-- tools/anysl-render/Footprint.cpp - how much of a surface a pixel sees -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Footprint.h"
#include <cmath>

namespace anysl::render {
namespace {

/// Two directions that are orthogonal to a unit vector and to each other (after Duff et al.,
/// Building an Orthonormal Basis, Revisited, 2017).
void basis(Vec3d n, Vec3d &x, Vec3d &y) {
  double sign = std::copysign(1.0, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  x = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  y = {b, sign + n.y * n.y * a, -n.y};
}

/// The least changes of u and v that bring dPdu and dPdv nearest to a step; 0 where the two lie on
/// a line.
ParameterStep solve(const SurfaceFrame &frame, Vec3d step) {
  double uu = dot(frame.dPdu, frame.dPdu), uv = dot(frame.dPdu, frame.dPdv);
  double vv = dot(frame.dPdv, frame.dPdv), determinant = uu * vv - uv * uv;
  double a = dot(frame.dPdu, step), b = dot(frame.dPdv, step);
  if (!(determinant > 1e-12 * uu * vv))
    return {};
  return {(a * vv - b * uv) / determinant, (b * uu - a * uv) / determinant};
}

RaySpread unknownSpread(const Camera &camera, const Ray &ray) {
  Vec3d right, down;
  basis(Vec3d(ray.direction), right, down);
  right = right * std::abs(camera.pixelWidth());
  down = down * std::abs(camera.pixelHeight());
  if (!camera.isPerspective())
    return {{right, down}, {}};
  double before = length(Vec3d(ray.origin));
  return {{right * before, down * before}, {right, down}};
}

/// What u and v change by where a neighbour of the ray meets the surface's plane.
ParameterStep transfer(const SurfaceFrame &frame, Vec3d direction, Vec3d step, double leastFacing) {
  double facing = dot(frame.normal, direction);
  facing = std::copysign(std::max(std::abs(facing), leastFacing), facing);
  return solve(frame, step - direction * (dot(frame.normal, step) / facing));
}

/// I reaches from the ray's origin to P, and changes with both.
void differentiateIncident(const RaySpread &spread, SurfacePoint &point) {
  ParameterStep x = point.toRight, y = point.down;
  double inverse = 1 / (x.u * y.v - x.v * y.u);
  point.dIdu = point.frame.dPdu;
  point.dIdv = point.frame.dPdv;
  if (!std::isfinite(inverse))
    return;
  point.dIdu = point.dIdu - (spread.origin[0] * y.v - spread.origin[1] * x.v) * inverse;
  point.dIdv = point.dIdv - (spread.origin[1] * x.u - spread.origin[0] * y.u) * inverse;
}

} // namespace

void findFootprint(const Camera &camera, bool isFromEye, const Ray &ray, SurfacePoint &point) {
  RaySpread spread = ray.spread  ? *ray.spread
                     : isFromEye ? camera.spread(ray.direction)
                                 : unknownSpread(camera, ray);
  const SurfaceFrame &frame = point.frame;
  Vec3d d(ray.direction);
  double t = double(ray.travelled) + dot(frame.P - Vec3d(ray.origin), d);
  Vec3d right = spread.origin[0] + spread.direction[0] * t;
  Vec3d down = spread.origin[1] + spread.direction[1] * t;
  point.toRight = transfer(frame, d, right, 1e-6);
  point.down = transfer(frame, d, down, 1e-6);
  // A surface seen edge on goes on for ever; for filters a hundred pixels' worth is enough.
  ParameterStep x = transfer(frame, d, right, 0.01), y = transfer(frame, d, down, 0.01);
  point.du = std::hypot(x.u, y.u);
  point.dv = std::hypot(x.v, y.v);
  differentiateIncident(spread, point);
}

} // namespace anysl::render
