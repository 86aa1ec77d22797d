//===-- tools/anysl-render/MeshCorners.h - slopes at the corners of a mesh --------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_MESHCORNERS_H
#define ANYSL_RENDER_MESHCORNERS_H

#include "tools/anysl-render/Mesh.h"

namespace anysl::render {

/// A mesh whose hits are corners of facets. Facets that meet in one disagree about how normals and
/// variables change with u and v; what is told here is the mean, weighted by the facets' sizes.
/// Those with parameters of their own must share the corner; polygons, whose u and v are x and y of
/// the object, only the point, with normals that are about the same.
class MeshCorners final : public SurfaceSet {
public:
  /// The mesh must stay as it is for as long as this lives, but for what `values` says.
  explicit MeshCorners(const Mesh &mesh);

  RTCGeometry make(RTCDevice) override { return nullptr; } ///< no ray meets it
  const SurfaceOwner &owner(uint32_t primitive) const override { return mesh.owner(primitive); }
  const SurfaceVariables &variables(uint32_t primitive) const override {
    return mesh.variables(primitive);
  }
  bool hasUnitParameters() const override { return mesh.hasUnitParameters(); }
  void evaluate(const Hit &hit, Vec3f origin, Vec3f direction, const SurfaceNeeds &needs,
                SurfacePoint &point) const override;
  void interpolate(const Variable &variable, const Hit &hit, const SurfacePoint &point,
                   float *value) const override {
    mesh.interpolate(variable, hit, point, value);
  }
  void differentiate(const Variable &variable, uint32_t component, const Hit &hit,
                     const SurfacePoint &point, double &byU, double &byV) const override;

  /// The hit of a place: three times a triangle, and which of its corners.
  static Hit hitOf(uint32_t place);

private:
  static uint32_t placeOf(const Hit &hit) {
    return 3 * hit.primitive + (hit.u == 1 ? 1 : hit.v == 1 ? 2 : 0);
  }
  template <typename Add>
  void forEachAround(const Hit &hit, const Add &add) const;

  const Mesh &mesh;
  std::vector<std::vector<uint32_t>> around; ///< places by corner, or by point of polygons
  std::vector<Vec3d> normals;                ///< by place, of polygons
};

} // namespace anysl::render

#endif
