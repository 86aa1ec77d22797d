//===-- tools/anysl-render/Mesh.cpp - triangles -----------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Mesh.h"

#include <algorithm>

using namespace anysl::render;

namespace {

/// Solves d = x toU + y toV for the derivatives of something whose changes along two edges of a
/// triangle are b and c, where u and v change by `toB` and `toC`.
template <typename T>
void solve(Vec3d toB, Vec3d toC, T b, T c, T &byU, T &byV) {
  double scale = 1 / (toB.x * toC.y - toC.x * toB.y);
  byU = (b * toC.y - c * toB.y) * scale;
  byV = (c * toB.x - b * toC.x) * scale;
}

} // namespace

RTCGeometry Mesh::make(RTCDevice device) {
  points.emplace_back(); // Embree may read past the end
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, points.data(),
                             0, sizeof(Vec3f), points.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, triangles.data(),
                             0, sizeof(triangles[0]), triangles.size());
  if (!placement.oneSided && !trim)
    return geometry;
  rtcSetGeometryUserData(geometry, this);
  auto filter = [](const RTCFilterFunctionNArguments *a) {
    const auto &mesh = *static_cast<const Mesh *>(a->geometryUserPtr);
    for (unsigned i = 0; i < a->N; ++i)
      if (a->valid[i] &&
          !mesh.isSolid(RTCHitN_primID(a->hit, a->N, i), RTCHitN_u(a->hit, a->N, i),
                        RTCHitN_v(a->hit, a->N, i),
                        {RTCRayN_dir_x(a->ray, a->N, i), RTCRayN_dir_y(a->ray, a->N, i),
                         RTCRayN_dir_z(a->ray, a->N, i)}))
        a->valid[i] = 0;
  };
  rtcSetGeometryIntersectFilterFunction(geometry, filter);
  rtcSetGeometryOccludedFilterFunction(geometry, filter);
  return geometry;
}

bool Mesh::isSolid(uint32_t triangle, float u, float v, Vec3d direction) const {
  if (placement.oneSided) {
    const auto &corner = triangles[triangle];
    Vec3d p(points[corner[0]]);
    Vec3d normal = cross(Vec3d(points[corner[1]]) - p, Vec3d(points[corner[2]]) - p);
    if (dot(normal, direction) * placement.normalSign > 0)
      return false;
  }
  if (!trim)
    return true;
  const auto &a = parameters[index(Domain::Corner, triangle, 0)],
             &b = parameters[index(Domain::Corner, triangle, 1)],
             &c = parameters[index(Domain::Corner, triangle, 2)];
  double wa = 1.0 - u - v;
  return trim->contains(a[0] * wa + b[0] * double(u) + c[0] * double(v),
                        a[1] * wa + b[1] * double(u) + c[1] * double(v));
}

size_t Mesh::index(Domain domain, uint32_t triangle, size_t corner) const {
  switch (domain) {
  case Domain::Constant:
    return 0;
  case Domain::Face:
    return faces.empty() ? 0 : faces[triangle];
  case Domain::Point:
    return triangles[triangle][corner];
  case Domain::Corner:
    return (corners.empty() ? triangles : corners)[triangle][corner];
  }
  return 0;
}

Vec3d Mesh::normalAt(uint32_t triangle, size_t corner) const {
  const float *n = normals.at(index(normals.domain, triangle, corner));
  return {n[0], n[1], n[2]};
}

bool Mesh::parameterEdges(uint32_t triangle, Vec3d &toB, Vec3d &toC) const {
  Vec3d at[3];
  for (size_t i = 0; i < 3; ++i) {
    if (parameters.empty()) {
      at[i] = placement.toObject.affinePoint(Vec3d(points[triangles[triangle][i]]));
      at[i].z = 0;
    } else {
      const auto &uv = parameters[index(Domain::Corner, triangle, i)];
      at[i] = {uv[0], uv[1], 0};
    }
  }
  toB = at[1] - at[0];
  toC = at[2] - at[0];
  double determinant = toB.x * toC.y - toC.x * toB.y;
  return std::fabs(determinant) >
         1e-9 * std::max(maxAbs(toB), 1e-30) * std::max(maxAbs(toC), 1e-30);
}

void Mesh::planarFrame(uint32_t triangle, SurfaceFrame &frame) const {
  Vec3d p = placement.toObject.affinePoint(frame.P);
  frame.u = p.x;
  frame.v = p.y;
  // Along x and y of object space within the plane; where it stands on edge, any two directions.
  Vec3d n = placement.toCamera.normalByInverse(frame.normal);
  if (std::fabs(n.z) > 1e-6 * maxAbs(n)) {
    frame.dPdu = placement.toCamera.vector({1, 0, -n.x / n.z});
    frame.dPdv = placement.toCamera.vector({0, 1, -n.y / n.z});
  } else {
    const auto &corner = triangles[triangle];
    frame.dPdu = normalized(Vec3d(points[corner[1]]) - Vec3d(points[corner[0]]));
    frame.dPdv = normalized(cross(frame.normal, frame.dPdu));
  }
}

SurfaceFrame Mesh::planarFrameAt(uint32_t triangle) const {
  const auto &corner = triangles[triangle];
  Vec3d p0(points[corner[0]]), p1(points[corner[1]]), p2(points[corner[2]]);
  SurfaceFrame frame;
  frame.P = p0;
  frame.normal = cross(p1 - p0, p2 - p0) * placement.normalSign;
  planarFrame(triangle, frame);
  return frame;
}

void Mesh::dropUnusedPoints() {
  std::vector<bool> isUsed(points.size());
  for (const std::array<uint32_t, 3> &triangle : triangles)
    for (uint32_t point : triangle)
      isUsed[point] = true;
  std::vector<uint32_t> place(points.size());
  uint32_t kept = 0;
  for (uint32_t i = 0; i < points.size(); ++i) {
    place[i] = kept;
    points[kept] = points[i];
    kept += isUsed[i];
  }
  points.resize(kept);
  for (std::array<uint32_t, 3> &triangle : triangles)
    for (uint32_t &point : triangle)
      point = place[point];
}

double Mesh::tangents(uint32_t triangle, Vec3d &byU, Vec3d &byV) const {
  const auto &corner = triangles[triangle];
  Vec3d p0(points[corner[0]]), p1(points[corner[1]]), p2(points[corner[2]]);
  Vec3d toB, toC;
  if (!parameterEdges(triangle, toB, toC))
    return 0;
  solve(toB, toC, p1 - p0, p2 - p0, byU, byV);
  return length(cross(p1 - p0, p2 - p0));
}

void Mesh::evaluate(const Hit &hit, Vec3f, Vec3f, const SurfaceNeeds &needs,
                    SurfacePoint &point) const {
  uint32_t triangle = hit.primitive;
  const auto &corner = triangles[triangle];
  Vec3d p0(points[corner[0]]), p1(points[corner[1]]), p2(points[corner[2]]);
  double wa = 1.0 - hit.u - hit.v, wb = hit.u, wc = hit.v;
  SurfaceFrame &frame = point.frame;
  frame.P = p0 * wa + p1 * wb + p2 * wc;
  frame.normal = cross(p1 - p0, p2 - p0) * placement.normalSign;
  point.normal = frame.normal;
  point.offset = float(std::max({maxAbs(p0), maxAbs(p1), maxAbs(p2)}));
  bool smooth = !normals.values.empty();
  if (smooth) {
    Vec3d a = normalAt(triangle, 0), b = normalAt(triangle, 1), c = normalAt(triangle, 2);
    Vec3d mean = a * wa + b * wb + c * wc;
    if (mean == Vec3d())
      mean = frame.normal;
    point.normal = mean;
    // Along the shading normal, so that it tells on which side of the smooth surface a ray goes.
    point.lift = normalized(mean) * length(lift(triangle, hit.u, hit.v, frame.P));
    Vec3d toB, toC;
    if (needs.derivatives && parameterEdges(triangle, toB, toC))
      solve(toB, toC, b - a, c - a, point.dNdu, point.dNdv);
  }
  if (!needs.parametric)
    return;
  if (parameters.empty())
    return planarFrame(triangle, frame);
  size_t a = index(Domain::Corner, triangle, 0), b = index(Domain::Corner, triangle, 1),
         c = index(Domain::Corner, triangle, 2);
  frame.u = parameters[a][0] * wa + parameters[b][0] * wb + parameters[c][0] * wc;
  frame.v = parameters[a][1] * wa + parameters[b][1] * wb + parameters[c][1] * wc;
  frame.dPdu = Vec3d(dPdu[a]) * wa + Vec3d(dPdu[b]) * wb + Vec3d(dPdu[c]) * wc;
  frame.dPdv = Vec3d(dPdv[a]) * wa + Vec3d(dPdv[b]) * wb + Vec3d(dPdv[c]) * wc;
}

Vec3d Mesh::atCorners(const Variable &variable, uint32_t component, uint32_t triangle) const {
  Vec3d result;
  for (size_t i = 0; i < 3; ++i)
    result[int(i)] = variable.at(index(variable.domain, triangle, i))[component];
  return result;
}

void Mesh::interpolate(const Variable &variable, const Hit &hit, const SurfacePoint &,
                       float *value) const {
  Vec3d weights(1.0 - hit.u - hit.v, hit.u, hit.v);
  for (uint32_t k = 0; k < variable.components; ++k)
    value[k] = float(dot(weights, atCorners(variable, k, hit.primitive)));
}

void Mesh::differentiate(const Variable &variable, uint32_t component, const Hit &hit,
                         const SurfacePoint &, double &byU, double &byV) const {
  Vec3d toB, toC, at = atCorners(variable, component, hit.primitive);
  if (parameterEdges(hit.primitive, toB, toC))
    solve(toB, toC, at.y - at.x, at.z - at.x, byU, byV);
}

/// The way from a point P of a triangle to the smooth surface that the normals at its corners tell
/// of; zero where the surface is hollow there. Shadow rays that start there instead are not stopped
/// by the neighbouring facets (after Hanika, Hacking the Shadow Terminator, Ray Tracing Gems II,
/// chapter 4).
Vec3d Mesh::lift(uint32_t triangle, float u, float v, Vec3d P) const {
  Vec3d result;
  // Each corner's tangent plane, as far as it lies above P, weighted as the corner is.
  const double weights[3] = {1.0 - u - v, u, v};
  for (size_t i = 0; i < 3; ++i) {
    Vec3d normal = normalAt(triangle, i);
    double height = dot(P - Vec3d(points[triangles[triangle][i]]), normal);
    result += normal * (weights[i] * std::max(0.0, -height));
  }
  return result;
}
