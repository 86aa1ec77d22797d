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
void solve(const SurfaceFrame &frame, Vec3d step, double &du, double &dv) {
  double uu = dot(frame.dPdu, frame.dPdu), uv = dot(frame.dPdu, frame.dPdv);
  double vv = dot(frame.dPdv, frame.dPdv), determinant = uu * vv - uv * uv;
  double a = dot(frame.dPdu, step), b = dot(frame.dPdv, step);
  bool isSurface = determinant > 1e-12 * uu * vv;
  du = isSurface ? (a * vv - b * uv) / determinant : 0;
  dv = isSurface ? (b * uu - a * uv) / determinant : 0;
}

} // namespace

void findFootprint(const Camera &camera, bool isFromEye, Vec3f origin, Vec3f direction,
                   SurfacePoint &point) {
  const SurfaceFrame &frame = point.frame;
  Vec3d d(direction), steps[2];
  if (isFromEye) {
    double depth = camera.isPerspective() ? frame.P.z : 1;
    steps[0] = {camera.pixelWidth() * depth, 0, 0};
    steps[1] = {0, camera.pixelHeight() * depth, 0};
  } else {
    double travelled = length(Vec3d(origin)) + length(frame.P - Vec3d(origin));
    double grown = camera.isPerspective() ? travelled : 1;
    basis(d, steps[0], steps[1]);
    steps[0] = steps[0] * (std::abs(camera.pixelWidth()) * grown);
    steps[1] = steps[1] * (std::abs(camera.pixelHeight()) * grown);
  }
  double facing = dot(frame.normal, d);
  // A surface seen edge on goes on for ever; a hundred pixels' worth is enough.
  facing = std::copysign(std::max(std::abs(facing), 0.01), facing);
  double du[2], dv[2];
  for (int i = 0; i < 2; ++i)
    solve(frame, steps[i] - d * (dot(frame.normal, steps[i]) / facing), du[i], dv[i]);
  point.du = std::hypot(du[0], du[1]);
  point.dv = std::hypot(dv[0], dv[1]);
}

} // namespace anysl::render
