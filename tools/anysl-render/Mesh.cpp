//===-- tools/anysl-render/Mesh.cpp - triangles -----------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Mesh.h"

#include <algorithm>
#include <numbers>

using namespace anysl::render;

namespace {

std::vector<Vec3d> triples(const Parameter *parameter) {
  std::vector<Vec3d> result;
  if (parameter)
    for (size_t i = 0; i + 2 < parameter->numbers.size(); i += 3)
      result.emplace_back(parameter->numbers[i], parameter->numbers[i + 1],
                          parameter->numbers[i + 2]);
  return result;
}

/// Whether a matrix mirrors: then the order of a polygon's vertices turns round.
bool mirrors(const Matrix4 &m) {
  return dot(cross(m.vector({1, 0, 0}), m.vector({0, 1, 0})), m.vector({0, 0, 1})) < 0;
}

} // namespace

Mesh Mesh::fromPolygons(const PolygonShape &shape, const Matrix4 &objectToCamera,
                        const Appearance &appearance) {
  Mesh mesh;
  mesh.toCamera = objectToCamera;
  mesh.toObject = objectToCamera.inverse();
  mesh.oneSided = appearance.sides == 1;
  mesh.normalSign = mirrors(objectToCamera) != appearance.reverseOrientation ? -1 : 1;
  mesh.points.reserve(shape.points.size() + 1);
  for (const Vec3d &p : shape.points)
    mesh.points.push_back(Vec3f(objectToCamera.point(p)));
  mesh.points.emplace_back();

  size_t begin = 0;
  for (uint32_t count : shape.vertexCounts) {
    for (uint32_t i = 2; i < count; ++i)
      mesh.triangles.push_back(
          {shape.vertices[begin], shape.vertices[begin + i - 1], shape.vertices[begin + i]});
    begin += count;
  }

  mesh.colors = triples(findParameter(shape.parameters, "Cs"));
  mesh.opacities = triples(findParameter(shape.parameters, "Os"));
  mesh.normals = triples(findParameter(shape.parameters, "N"));
  for (Vec3d &normal : mesh.normals)
    normal = normalized(mesh.toObject.normalByInverse(normal)) *
             (appearance.reverseOrientation ? -1.0 : 1.0);
  const Parameter *st = findParameter(shape.parameters, "st");
  const Parameter *s = findParameter(shape.parameters, "s"),
                  *t = findParameter(shape.parameters, "t");
  for (size_t i = 0; i < shape.points.size() && (st || s || t); ++i) {
    Vec3d value(shape.points[i].x, shape.points[i].y, 0);
    if (st)
      value = {st->numbers[2 * i], st->numbers[2 * i + 1], 0};
    if (s)
      value.x = s->numbers[i];
    if (t)
      value.y = t->numbers[i];
    mesh.textures.push_back(value);
  }
  return mesh;
}

Mesh Mesh::fromSweep(const QuadricShape &shape, const Matrix4 &objectToCamera,
                     const Appearance &appearance) {
  constexpr uint32_t columns = 192, rows = 96;
  const double degrees = std::numbers::pi / 180;
  Mesh mesh;
  mesh.toCamera = objectToCamera;
  mesh.toObject = objectToCamera.inverse();
  mesh.oneSided = appearance.sides == 1;
  mesh.planar = false;
  mesh.normalSign = mirrors(objectToCamera) != appearance.reverseOrientation ? -1 : 1;
  for (uint32_t row = 0; row <= rows; ++row) {
    for (uint32_t column = 0; column <= columns; ++column) {
      double u = double(column) / columns, v = double(row) / rows;
      double theta = u * shape.thetaMax * degrees, cosine = std::cos(theta), sine = std::sin(theta);
      Vec3d profile, tangent; // in the plane y = 0, before the sweep
      if (shape.kind == QuadricShape::Torus) {
        double range = (shape.phiMax - shape.phiMin) * degrees;
        double phi = shape.phiMin * degrees + v * range;
        profile = {shape.radius + shape.minorRadius * std::cos(phi), 0,
                   shape.minorRadius * std::sin(phi)};
        tangent = Vec3d(-std::sin(phi), 0, std::cos(phi)) * (shape.minorRadius * range);
      } else {
        profile = lerp(shape.point1, shape.point2, v);
        tangent = shape.point2 - shape.point1;
      }
      auto sweep = [&](Vec3d p) {
        return Vec3d(p.x * cosine - p.y * sine, p.x * sine + p.y * cosine, p.z);
      };
      Vec3d p = sweep(profile), dPdv = sweep(tangent);
      Vec3d dPdu = Vec3d(-p.y, p.x, 0) * (shape.thetaMax * degrees);
      Vec3d normal = normalized(cross(dPdu, dPdv));
      mesh.points.push_back(Vec3f(objectToCamera.point(p)));
      mesh.normals.push_back(normalized(mesh.toObject.normalByInverse(normal)) *
                             (appearance.reverseOrientation ? -1.0 : 1.0));
      mesh.parameters.emplace_back(u, v, 0);
    }
  }
  for (uint32_t row = 0; row < rows; ++row)
    for (uint32_t column = 0; column < columns; ++column) {
      uint32_t corner = row * (columns + 1) + column, above = corner + columns + 1;
      mesh.triangles.push_back({corner, corner + 1, above + 1});
      mesh.triangles.push_back({corner, above + 1, above});
    }
  mesh.points.emplace_back();
  return mesh;
}

SurfaceFrame Mesh::evaluate(uint32_t triangle, float u, float v, bool parametric,
                            Vec3d &shadingNormal) const {
  const auto &corner = triangles[triangle];
  Vec3d p0(points[corner[0]]), p1(points[corner[1]]), p2(points[corner[2]]);
  SurfaceFrame frame;
  frame.P = p0 * (1.0 - u - v) + p1 * double(u) + p2 * double(v);
  frame.normal = cross(p1 - p0, p2 - p0) * normalSign;
  shadingNormal = normals.empty() ? frame.normal : interpolate(normals, triangle, u, v);
  if (!parametric)
    return frame;
  if (planar) {
    Vec3d p = toObject.affinePoint(frame.P);
    frame.u = p.x;
    frame.v = p.y;
    // Along x and y of object space within the plane; where it stands on edge, any two directions.
    Vec3d n = toCamera.normalByInverse(frame.normal);
    if (std::fabs(n.z) > 1e-6 * maxAbs(n)) {
      frame.dPdu = toCamera.vector({1, 0, -n.x / n.z});
      frame.dPdv = toCamera.vector({0, 1, -n.y / n.z});
    } else {
      frame.dPdu = normalized(p1 - p0);
      frame.dPdv = normalized(cross(frame.normal, frame.dPdu));
    }
  } else {
    Vec3d a = parameters[corner[0]], b = parameters[corner[1]], c = parameters[corner[2]];
    Vec3d uv = a * (1.0 - u - v) + b * double(u) + c * double(v);
    frame.u = uv.x;
    frame.v = uv.y;
    // Solve P(u, v) = p0 + dPdu (u - a.x) + dPdv (v - a.y) at the two other corners.
    Vec3d e1 = b - a, e2 = c - a, d1 = p1 - p0, d2 = p2 - p0;
    double determinant = e1.x * e2.y - e2.x * e1.y;
    frame.dPdu = (d1 * e2.y - d2 * e1.y) * (1 / determinant);
    frame.dPdv = (d2 * e1.x - d1 * e2.x) * (1 / determinant);
  }
  return frame;
}

void Mesh::color(uint32_t triangle, float u, float v, Vec3d &result) const {
  if (!colors.empty())
    result = interpolate(colors, triangle, u, v);
}

void Mesh::opacity(uint32_t triangle, float u, float v, Vec3d &result) const {
  if (!opacities.empty())
    result = interpolate(opacities, triangle, u, v);
}

void Mesh::texture(uint32_t triangle, float u, float v, double &s, double &t) const {
  if (textures.empty())
    return;
  Vec3d st = interpolate(textures, triangle, u, v);
  s = st.x;
  t = st.y;
}

Vec3d Mesh::lift(uint32_t triangle, float u, float v, Vec3d P) const {
  Vec3d result;
  if (normals.empty())
    return result;
  // Each corner's tangent plane, as far as it lies above P, weighted as the corner is.
  const auto &corner = triangles[triangle];
  const double weights[3] = {1.0 - u - v, u, v};
  for (size_t i = 0; i < 3; ++i) {
    Vec3d normal = normals[corner[i]];
    double height = dot(P - Vec3d(points[corner[i]]), normal);
    result += normal * (weights[i] * std::max(0.0, -height));
  }
  return result;
}

double Mesh::magnitude(uint32_t triangle) const {
  double result = 0;
  for (uint32_t corner : triangles[triangle])
    result = std::max(result, double(maxAbs(points[corner])));
  return result;
}
