//===-- tools/anysl-render/Curves.cpp - tubes and ribbons along curves ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Curves.h"
#include "tools/anysl-render/Tessellate.h"

#include <algorithm>
#include <numbers>

using namespace anysl::render;

namespace {

/// The control values of a Bézier curve that runs as another basis has it.
template <typename T>
std::array<T, 4> toBezier(const Basis &basis, const std::array<T, 4> &g) {
  std::array<T, 4> power; // of t³, t², t, 1
  for (size_t row = 0; row < 4; ++row) {
    power[row] = g[0] * basis.m[4 * row];
    for (size_t k = 1; k < 4; ++k)
      power[row] += g[k] * basis.m[4 * row + k];
  }
  return {power[3], power[3] + power[2] * (1. / 3),
          power[3] + power[2] * (2. / 3) + power[1] * (1. / 3),
          power[3] + power[2] + power[1] + power[0]};
}

template <typename T>
std::array<T, 4> straight(T a, T b) {
  return {a, a * (2. / 3) + b * (1. / 3), a * (1. / 3) + b * (2. / 3), b};
}

std::vector<Variable> curveVariables(const ParameterList &variables, const Placement &placement,
                                     std::vector<StorageClass> &storages) {
  std::vector<Variable> list;
  for (const Parameter &parameter : variables) {
    if (isPosition(parameter.name) || parameter.declaration->type == ValueType::String)
      continue;
    list.push_back(cameraVariable(parameter, placement));
    storages.push_back(parameter.declaration->storage);
  }
  return list;
}

} // namespace

CurveSegments::CurveSegments(const CurvesShape &given, const ParameterList &variables,
                             const Placement &placement)
    : shape(given) {
  std::vector<Vec3d> points = positions(variables);
  const Parameter *width = findParameter(variables, "width");
  if (!width)
    width = findParameter(variables, "constantwidth");
  double scale = 0.5 * placement.lengthScale();
  uint32_t firstVertex = 0, firstVarying = 0;
  for (uint32_t curve = 0; curve < shape.counts.size(); ++curve) {
    uint32_t vertices = shape.counts[curve], count = shape.segments(vertices);
    uint32_t varying = count + !shape.wraps;
    for (uint32_t i = 0; i < count; ++i) {
      Segment segment{curve, i, count, {}, {}, {}, {}};
      uint32_t begin = shape.cubic ? i * shape.basis.step : i;
      for (uint32_t k = 0; k < (shape.cubic ? 4u : 2u); ++k)
        segment.vertices[k] = firstVertex + (begin + k) % vertices;
      segment.varying[0] = firstVarying + i;
      segment.varying[1] = firstVarying + (i + 1) % varying;
      auto place = [&](size_t k) { return points[segment.vertices[k]]; };
      segment.points = shape.cubic
                           ? toBezier<Vec3d>(shape.basis, {place(0), place(1), place(2), place(3)})
                           : straight(place(0), place(1));
      for (Vec3d &p : segment.points)
        p = placement.toCamera.point(p);
      auto radius = [&](size_t index) { return scale * std::fabs(width->numbers[index]); };
      StorageClass storage = width ? width->declaration->storage : StorageClass::Constant;
      if (!width)
        segment.radii = straight(scale, scale);
      else if (storage == StorageClass::Constant || storage == StorageClass::Uniform)
        segment.radii = straight(radius(storage == StorageClass::Uniform ? curve : 0),
                                 radius(storage == StorageClass::Uniform ? curve : 0));
      else if (storage == StorageClass::Vertex && shape.cubic)
        segment.radii = toBezier<double>(
            shape.basis, {radius(segment.vertices[0]), radius(segment.vertices[1]),
                          radius(segment.vertices[2]), radius(segment.vertices[3])});
      else if (storage == StorageClass::Vertex)
        segment.radii = straight(radius(segment.vertices[0]), radius(segment.vertices[1]));
      else
        segment.radii = straight(radius(segment.varying[0]), radius(segment.varying[1]));
      segments.push_back(segment);
    }
    firstVertex += vertices;
    firstVarying += varying;
  }
}

Vec3d CurveSegments::place(const Segment &segment, double t, Vec3d &tangent, double &radius) {
  double weights[4], derivatives[4];
  Basis::bezier.weights(t, weights, derivatives);
  Vec3d result;
  tangent = Vec3d();
  radius = 0;
  for (size_t k = 0; k < 4; ++k) {
    result += segment.points[k] * weights[k];
    tangent += segment.points[k] * derivatives[k];
    radius += segment.radii[k] * weights[k];
  }
  return result;
}

void CurveSegments::value(const Variable &variable, StorageClass storage, const Segment &segment,
                          double t, float *value, double *derivative) const {
  double weights[4] = {1}, derivatives[4] = {};
  uint32_t count = 1;
  size_t index[4] = {storage == StorageClass::Uniform ? segment.curve : 0};
  if (storage == StorageClass::Vertex && shape.cubic) {
    count = 4;
    shape.basis.weights(t, weights, derivatives);
    std::copy_n(segment.vertices, 4, index);
  } else if (storage != StorageClass::Constant && storage != StorageClass::Uniform) {
    count = 2;
    weights[0] = 1 - t, weights[1] = t;
    derivatives[0] = -1, derivatives[1] = 1;
    std::copy_n(storage == StorageClass::Vertex ? segment.vertices : segment.varying, 2, index);
  }
  for (uint32_t c = 0; c < variable.components; ++c) {
    double sum = 0, slope = 0;
    for (uint32_t k = 0; k < count; ++k) {
      double each = variable.at(index[k])[c];
      sum += weights[k] * each;
      slope += derivatives[k] * each;
    }
    value[c] = float(sum);
    if (derivative)
      derivative[c] = slope;
  }
}

//===-- Round curves --------------------------------------------------------//

CurveSet::CurveSet(const CurvesShape &shape, const ParameterList &variables,
                   const Placement &placement)
    : placement(placement), curves(shape, variables, placement) {
  values = SurfaceVariables(curveVariables(variables, placement, storages));
  for (const auto &segment : curves.all()) {
    firstVertices.push_back(uint32_t(vertices.size()));
    for (size_t k = 0; k < 4; ++k) {
      const Vec3d &p = segment.points[k];
      vertices.push_back({float(p.x), float(p.y), float(p.z), float(segment.radii[k])});
    }
  }
}

RTCGeometry CurveSet::make(RTCDevice device) {
  vertices.emplace_back(); // Embree may read past the end
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ROUND_BEZIER_CURVE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                             vertices.data(), 0, sizeof(vertices[0]), vertices.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                             firstVertices.data(), 0, sizeof(uint32_t), firstVertices.size());
  return geometry;
}

void CurveSet::evaluate(const Hit &hit, Vec3f origin, Vec3f direction, const SurfaceNeeds &,
                        SurfacePoint &point) const {
  const CurveSegments::Segment &segment = curves.all()[hit.primitive];
  Vec3d tangent, d(direction);
  double radius;
  Vec3d middle = CurveSegments::place(segment, hit.u, tangent, radius);
  SurfaceFrame &frame = point.frame;
  frame.P = Vec3d(origin) + d * double(hit.t);
  Vec3d along = normalized(tangent);
  Vec3d towards = normalized(along * dot(along, d) - d);
  if (towards == Vec3d()) // seen along the curve
    towards = normalized(-d);
  Vec3d out = frame.P - middle;
  out = normalized(out - along * dot(along, out));
  if (out == Vec3d())
    out = towards;
  frame.P = middle + out * radius; // round exactly
  frame.normal = point.normal = out;
  // u runs across the half that the ray sees, and v along the curve, from its begin to its end.
  Vec3d across = normalized(cross(along, towards)) * placement.normalSign;
  constexpr double pi = std::numbers::pi;
  frame.u = std::clamp(0.5 + std::atan2(dot(out, across), dot(out, towards)) / pi, 0.0, 1.0);
  frame.v = (segment.index + double(hit.u)) / segment.count;
  frame.dPdu = normalized(cross(along, out)) * (placement.normalSign * pi * radius);
  frame.dPdv = tangent * double(segment.count);
  // Embree finds the tube to a thousandth of its radius.
  point.offset = float(std::max(maxAbs(middle) + radius, radius * 0x1p8));
}

void CurveSet::interpolate(const Variable &variable, const Hit &hit, const SurfacePoint &,
                           float *value) const {
  curves.value(variable, storageOf(variable), curves.all()[hit.primitive], hit.u, value, nullptr);
}

void CurveSet::differentiate(const Variable &variable, uint32_t component, const Hit &hit,
                             const SurfacePoint &, double &byU, double &byV) const {
  const CurveSegments::Segment &segment = curves.all()[hit.primitive];
  std::vector<float> value(variable.components);
  std::vector<double> derivative(variable.components);
  curves.value(variable, storageOf(variable), segment, hit.u, value.data(), derivative.data());
  byU = 0;
  byV = derivative[component] * segment.count;
}

//===-- Ribbons with normals ------------------------------------------------//

std::unique_ptr<Mesh> anysl::render::tessellate(const CurvesShape &shape,
                                                const ParameterList &variables,
                                                const Placement &placement, const Dicing &dicing) {
  CurveSegments curves(shape, variables, placement);
  std::vector<StorageClass> storages;
  std::vector<Variable> given = curveVariables(variables, placement, storages);
  std::vector<Variable> diced = given;
  for (Variable &variable : diced) {
    variable.values.clear();
    variable.domain = Domain::Corner;
  }
  size_t normalIndex = given.size();
  for (size_t i = 0; i < given.size(); ++i)
    if (given[i].name == "N")
      normalIndex = i;

  auto mesh = std::make_unique<Mesh>(placement);
  mesh->normals.name = "N";
  mesh->normals.type = ValueType::Normal;
  mesh->normals.domain = Domain::Corner;
  mesh->normals.components = 3;
  std::vector<float> value;
  for (const CurveSegments::Segment &segment : curves.all()) {
    auto evaluate = [&](double t, double &radius) {
      SurfaceFrame frame;
      frame.P = CurveSegments::place(segment, t, frame.dPdv, radius);
      Vec3d normal;
      if (normalIndex < given.size()) {
        float n[3];
        curves.value(given[normalIndex], storages[normalIndex], segment, t, n, nullptr);
        normal = {n[0], n[1], n[2]};
      } else {
        normal = -frame.P; // to the eye
      }
      frame.dPdu = normalized(cross(frame.dPdv, normal)) * (placement.normalSign * 2 * radius);
      frame.dPdv = frame.dPdv * double(segment.count);
      frame.v = (segment.index + t) / segment.count;
      return frame;
    };
    uint32_t pieces = dicing.segments([&](double t) {
      double radius;
      return evaluate(t, radius);
    });
    for (uint32_t j = 0; j <= pieces; ++j) {
      double radius, t = double(j) / pieces;
      SurfaceFrame frame = evaluate(t, radius);
      Vec3d n = normalized(cross(frame.dPdu, frame.dPdv)) * placement.normalSign;
      for (int side = 0; side < 2; ++side) {
        uint32_t corner = uint32_t(mesh->points.size());
        mesh->points.push_back(Vec3f(frame.P + frame.dPdu * (side - 0.5)));
        mesh->parameters.push_back({float(side), float(frame.v)});
        mesh->dPdu.push_back(Vec3f(frame.dPdu));
        mesh->dPdv.push_back(Vec3f(frame.dPdv));
        for (int k = 0; k < 3; ++k)
          mesh->normals.values.push_back(float(n[k]));
        for (size_t i = 0; i < given.size(); ++i) {
          value.resize(given[i].components);
          curves.value(given[i], storages[i], segment, t, value.data(), nullptr);
          diced[i].values.insert(diced[i].values.end(), value.begin(), value.end());
        }
        if (j == 0)
          continue;
        // The strip's triangles turn as (u, v) does.
        if (side == 0)
          mesh->addTriangle(corner - 2, corner - 1, corner);
        else
          mesh->addTriangle(corner - 1, corner - 2, corner);
        mesh->faces.push_back(segment.curve);
      }
    }
  }
  mesh->values = SurfaceVariables(std::move(diced));
  return mesh;
}
