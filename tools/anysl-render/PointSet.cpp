//===-- tools/anysl-render/PointSet.cpp - particles -------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/PointSet.h"

#include <algorithm>

using namespace anysl::render;

PointSet::PointSet(const ParameterList &variables, const Placement &placement)
    : placement(placement) {
  std::vector<Variable> list;
  const Variable *width = nullptr, *normal = nullptr;
  for (const Parameter &parameter : variables) {
    if (isPosition(parameter.name) || parameter.declaration->type == ValueType::String)
      continue;
    list.push_back(cameraVariable(parameter, placement));
    StorageClass storage = parameter.declaration->storage;
    bool same = storage == StorageClass::Constant || storage == StorageClass::Uniform;
    list.back().domain = same ? Domain::Constant : Domain::Point;
  }
  for (const Variable &variable : list) {
    if (variable.name == "width" || (variable.name == "constantwidth" && !width))
      width = &variable;
    if (variable.name == "N" && variable.components == 3)
      normal = &variable;
  }
  double scale = 0.5 * placement.lengthScale();
  std::vector<Vec3d> places = positions(variables);
  for (size_t i = 0; i < places.size(); ++i) {
    auto at = [&](const Variable &v) { return v.at(v.domain == Domain::Constant ? 0 : i); };
    Vec3d p = placement.toCamera.point(places[i]);
    double radius = scale * (width ? std::fabs(double(*at(*width))) : 1.0);
    vertices.push_back({float(p.x), float(p.y), float(p.z), float(radius)});
    if (normal) {
      const float *n = at(*normal);
      normals.push_back({n[0], n[1], n[2]});
    }
  }
  values = SurfaceVariables(std::move(list));
}

RTCGeometry PointSet::make(RTCDevice device) {
  vertices.emplace_back(); // Embree may read past the end
  RTCGeometry geometry =
      rtcNewGeometry(device, normals.empty() ? RTC_GEOMETRY_TYPE_SPHERE_POINT
                                             : RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                             vertices.data(), 0, sizeof(vertices[0]), vertices.size() - 1);
  if (!normals.empty()) {
    normals.emplace_back();
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_NORMAL, 0, RTC_FORMAT_FLOAT3,
                               normals.data(), 0, sizeof(Vec3f), normals.size() - 1);
  }
  return geometry;
}

void PointSet::evaluate(const Hit &hit, Vec3f origin, Vec3f direction, const SurfaceNeeds &,
                        SurfacePoint &point) const {
  const auto &[x, y, z, r] = vertices[hit.primitive];
  Vec3d center(x, y, z);
  SurfaceFrame &frame = point.frame;
  frame.P = Vec3d(origin) + Vec3d(direction) * double(hit.t);
  if (normals.empty()) {
    Vec3d out = normalized(frame.P - center);
    frame.P = center + out * double(r); // onto the sphere exactly
    frame.normal = placement.reverse ? -out : out;
  } else {
    frame.normal = Vec3d(normals[hit.primitive]);
  }
  point.normal = frame.normal;
  // A point has no parameters of its own: u and v are 0, their directions any two across it.
  Vec3d axis = std::fabs(frame.normal.x) < 0.6 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  frame.dPdu = normalized(cross(axis, frame.normal)) * double(r);
  frame.dPdv = cross(frame.normal, frame.dPdu) * placement.normalSign;
  point.offset = float(maxAbs(center) + double(r));
}

void PointSet::interpolate(const Variable &variable, const Hit &hit, const SurfacePoint &,
                           float *value) const {
  size_t index = variable.domain == Domain::Constant ? 0 : hit.primitive;
  std::copy_n(variable.at(index), variable.components, value);
}
