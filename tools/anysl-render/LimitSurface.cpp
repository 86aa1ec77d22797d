//===-- tools/anysl-render/LimitSurface.cpp - what subdivision leads to -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/LimitSurface.h"

#include <algorithm>

using namespace anysl::render;

namespace {

/// One device for all surfaces, for as long as the program runs.
RTCDevice sharedDevice() {
  struct Device {
    RTCDevice handle = rtcNewDevice(nullptr);
    ~Device() { rtcReleaseDevice(handle); }
  };
  static const Device device;
  if (!device.handle)
    throw UserError("Embree cannot start on this machine");
  return device.handle;
}

/// Larger numbers Embree does not take.
constexpr double mostValue = 1e18;

RTCSubdivisionMode mode(SubdivisionShape::Boundary boundary) {
  switch (boundary) {
  case SubdivisionShape::Boundary::None:
    return RTC_SUBDIVISION_MODE_NO_BOUNDARY;
  case SubdivisionShape::Boundary::EdgesAndCorners:
    return RTC_SUBDIVISION_MODE_PIN_CORNERS;
  case SubdivisionShape::Boundary::Edges:
    return RTC_SUBDIVISION_MODE_SMOOTH_BOUNDARY;
  }
  return RTC_SUBDIVISION_MODE_NO_BOUNDARY;
}

} // namespace

template <typename T>
void LimitSurface::fill(RTCBufferType type, RTCFormat format, const std::vector<T> &values) {
  if (values.empty())
    return;
  void *buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), values.size());
  if (!buffer)
    throw UserError("Embree has no memory for a subdivision surface");
  std::copy(values.begin(), values.end(), static_cast<T *>(buffer));
}

float *LimitSurface::makeValues(RTCBufferType type, unsigned slot, unsigned width, size_t count) {
  // Embree computes with four at a time, and wants all of them to be numbers.
  size_t stride = (width + 3) / 4 * 4;
  auto *values = static_cast<float *>(
      rtcSetNewGeometryBuffer(geometry, type, slot, RTCFormat(RTC_FORMAT_FLOAT + width - 1),
                              stride * sizeof(float), count));
  if (!values)
    throw UserError("Embree has no memory for a subdivision surface");
  std::fill_n(values, stride * count, 0.0f);
  return values;
}

LimitSurface::LimitSurface(const SubdivisionShape &given, std::span<const Vec3d> points,
                           std::span<const Variable> variables)
    : shape(given), scene(rtcNewScene(sharedDevice())),
      geometry(rtcNewGeometry(sharedDevice(), RTC_GEOMETRY_TYPE_SUBDIVISION)) {
  fill(RTC_BUFFER_TYPE_FACE, RTC_FORMAT_UINT, shape.vertexCounts);
  fill(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, shape.vertices);
  auto *place = makeValues(RTC_BUFFER_TYPE_VERTEX, 0, 3, points.size());
  for (const Vec3d &p : points) {
    for (int k = 0; k < 3; ++k)
      place[k] = float(std::clamp(p[k], -mostValue, mostValue));
    place += 4;
  }

  std::vector<std::array<uint32_t, 2>> edges;
  std::vector<uint32_t> corners;
  std::vector<float> sharpness;
  for (const auto &[a, b, weight] : shape.creases) {
    edges.push_back({a, b});
    sharpness.push_back(float(weight));
  }
  fill(RTC_BUFFER_TYPE_EDGE_CREASE_INDEX, RTC_FORMAT_UINT2, edges);
  fill(RTC_BUFFER_TYPE_EDGE_CREASE_WEIGHT, RTC_FORMAT_FLOAT, sharpness);
  sharpness.clear();
  for (const auto &[vertex, weight] : shape.corners) {
    corners.push_back(vertex);
    sharpness.push_back(float(weight));
  }
  fill(RTC_BUFFER_TYPE_VERTEX_CREASE_INDEX, RTC_FORMAT_UINT, corners);
  fill(RTC_BUFFER_TYPE_VERTEX_CREASE_WEIGHT, RTC_FORMAT_FLOAT, sharpness);
  rtcSetGeometrySubdivisionMode(geometry, 0, mode(shape.boundary));

  unsigned slots = 0;
  for (const Variable &variable : variables) {
    parts.emplace_back();
    for (unsigned first = 0; first < variable.components; first += 16)
      parts.back().push_back({slots++, first, std::min(16u, variable.components - first)});
  }
  rtcSetGeometryVertexAttributeCount(geometry, slots);
  for (size_t i = 0; i < parts.size(); ++i)
    for (const Part &part : parts[i]) {
      float *values =
          makeValues(RTC_BUFFER_TYPE_VERTEX_ATTRIBUTE, part.slot, part.width, points.size());
      for (size_t vertex = 0; vertex < points.size(); ++vertex) {
        for (unsigned k = 0; k < part.width; ++k)
          values[k] = std::clamp(variables[i].at(vertex)[part.first + k], float(-mostValue),
                                 float(mostValue));
        values += (part.width + 3) / 4 * 4;
      }
    }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcCommitScene(scene);
}

LimitSurface::~LimitSurface() {
  rtcReleaseGeometry(geometry);
  rtcReleaseScene(scene);
}

std::pair<float, float> LimitSurface::place(uint32_t face, uint32_t corner, double x,
                                            double y) const {
  if (shape.vertexCounts[face] == 4)
    return {float(x), float(y)};
  // Embree's way to tell the quarters apart.
  return {float(2 * (corner % 4) + 0.5 + x), float(2 * (corner / 4) + 0.5 + y)};
}

SurfaceFrame LimitSurface::evaluate(uint32_t face, uint32_t corner, double x, double y) const {
  auto [u, v] = place(face, corner, x, y);
  float p[3], du[3], dv[3];
  rtcInterpolate1(geometry, face, u, v, RTC_BUFFER_TYPE_VERTEX, 0, p, du, dv, 3);
  SurfaceFrame frame;
  frame.P = {p[0], p[1], p[2]};
  frame.dPdu = {du[0], du[1], du[2]};
  frame.dPdv = {dv[0], dv[1], dv[2]};
  frame.u = x;
  frame.v = y;
  return frame;
}

void LimitSurface::value(size_t variable, uint32_t face, uint32_t corner, double x, double y,
                         float *result) const {
  auto [u, v] = place(face, corner, x, y);
  for (const Part &part : parts[variable])
    rtcInterpolate0(geometry, face, u, v, RTC_BUFFER_TYPE_VERTEX_ATTRIBUTE, part.slot,
                    result + part.first, part.width);
}
