//===-- tools/anysl-render/Mesh.h - triangles -------------------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_MESH_H
#define ANYSL_RENDER_MESH_H

#include "tools/anysl-render/Quadric.h"

namespace anysl::render {

/// Triangles in camera space with values at their corners.
class Mesh {
public:
  /// Cuts polygons into triangles; they must be convex, as the standard says they are.
  static Mesh fromPolygons(const PolygonShape &shape, const Matrix4 &objectToCamera,
                           const Appearance &appearance);
  /// A swept surface that is no quadric, as a fine grid with smooth normals.
  static Mesh fromSweep(const QuadricShape &shape, const Matrix4 &objectToCamera,
                        const Appearance &appearance);

  /// The surface at the barycentric coordinates (u, v) of a triangle, as Embree counts them. The
  /// frame's normal is the geometric one; `shadingNormal` is interpolated where the mesh has
  /// normals. Parameters and derivatives are computed only if asked for.
  SurfaceFrame evaluate(uint32_t triangle, float u, float v, bool parametric,
                        Vec3d &shadingNormal) const;
  /// Values at the corners, if the mesh has them; otherwise they leave `result` alone.
  void color(uint32_t triangle, float u, float v, Vec3d &result) const;
  void opacity(uint32_t triangle, float u, float v, Vec3d &result) const;
  void texture(uint32_t triangle, float u, float v, double &s, double &t) const;
  /// The way from a point P of a triangle to the smooth surface that the normals at its corners
  /// tell of; zero where the mesh has none or the surface is hollow there. Shadow rays that start
  /// there instead are not stopped by the neighbouring facets (after Hanika, Hacking the Shadow
  /// Terminator, Ray Tracing Gems II, chapter 4).
  Vec3d lift(uint32_t triangle, float u, float v, Vec3d P) const;
  /// The size of the numbers that a hit on the triangle was computed from.
  double magnitude(uint32_t triangle) const;

  std::vector<Vec3f> points; ///< Embree reads these two; one more point is
                             ///< there, since it may read past the end
  std::vector<std::array<uint32_t, 3>> triangles;
  bool hasOpacity() const { return !opacities.empty(); }
  bool oneSided = false;

private:
  template <typename T>
  T interpolate(const std::vector<T> &values, uint32_t triangle, double u, double v) const {
    const auto &corner = triangles[triangle];
    return values[corner[0]] * (1 - u - v) + values[corner[1]] * u + values[corner[2]] * v;
  }

  Matrix4 toCamera, toObject;
  double normalSign = 1;
  bool planar = true; ///< u and v are x and y in object space; otherwise given at the corners
  std::vector<Vec3d> normals, colors, opacities, textures, parameters;
};

} // namespace anysl::render

#endif
