//===-- tools/anysl-render/Mesh.h - triangles -------------------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_MESH_H
#define ANYSL_RENDER_MESH_H

#include "tools/anysl-render/Surface.h"
#include "tools/anysl-render/TrimRegion.h"

namespace anysl::render {

/// Triangles in camera space with values at their corners: polygons as they are given, or the fine
/// facets of a smooth surface. Facets that meet share points, so that no ray slips between them;
/// where something else than the place differs from one side to the other, such as a normal at a
/// crease or a texture coordinate at a seam, they have corners of their own at a shared point.
class Mesh : public ShapeSurface {
public:
  explicit Mesh(const Placement &placement) : placement(placement) {}

  RTCGeometry make(RTCDevice device) override;
  bool hasUnitParameters() const override { return unitParameters && !parameters.empty(); }
  void evaluate(const Hit &hit, Vec3f origin, Vec3f direction, const SurfaceNeeds &needs,
                SurfacePoint &point) const override;
  void interpolate(const Variable &variable, const Hit &hit, const SurfacePoint &point,
                   float *value) const override;
  void differentiate(const Variable &variable, uint32_t component, const Hit &hit,
                     const SurfacePoint &point, double &byU, double &byV) const override;

  /// Adds a triangle of points that are at the same time its corners.
  void addTriangle(uint32_t a, uint32_t b, uint32_t c) { triangles.push_back({a, b, c}); }

  /// Keeps the points of triangles alone.
  void dropUnusedPoints();

  /// dPdu and dPdv of a triangle, as its corners' places and parameters have them, and how much it
  /// weighs among others; 0 where its parameters tell nothing.
  double tangents(uint32_t triangle, Vec3d &byU, Vec3d &byV) const;
  /// The frame of a triangle whose parameters are x and y of the object.
  SurfaceFrame planarFrameAt(uint32_t triangle) const;

  Placement placement;
  bool unitParameters = true; ///< they run over the unit square, if there are any
  std::vector<Vec3f> points;
  std::vector<std::array<uint32_t, 3>> triangles; ///< indices into points
  std::vector<std::array<uint32_t, 3>> corners;   ///< of each triangle; empty: as `triangles`
  std::vector<uint32_t> faces;                    ///< of each triangle; empty: all the same
  Variable normals;                               ///< shading normals; no values: none
  std::vector<std::array<float, 2>> parameters; ///< u and v by corner; none: x and y of the object
  std::vector<Vec3f> dPdu, dPdv;                ///< by corner, if there are parameters
  std::optional<TrimRegion> trim;               ///< where in its parameters the surface is

private:
  /// Whether a ray that meets a triangle meets a side and a part of it that are there.
  bool isSolid(uint32_t triangle, float u, float v, Vec3d direction) const;
  /// The three values of a variable's component at a triangle's corners.
  Vec3d atCorners(const Variable &variable, uint32_t component, uint32_t triangle) const;
  size_t index(Domain domain, uint32_t triangle, size_t corner) const;
  Vec3d normalAt(uint32_t triangle, size_t corner) const;
  Vec3d lift(uint32_t triangle, float u, float v, Vec3d P) const;
  /// Derivatives by u and v of something that runs linearly over a triangle.
  bool parameterEdges(uint32_t triangle, Vec3d &toB, Vec3d &toC) const;
  void planarFrame(uint32_t triangle, SurfaceFrame &frame) const;
};

} // namespace anysl::render

#endif
