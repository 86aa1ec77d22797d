//===-- tools/anysl-render/PointSet.h - particles ---------------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_POINTSET_H
#define ANYSL_RENDER_POINTSET_H

#include "tools/anysl-render/Surface.h"

namespace anysl::render {

/// Points as Embree intersects them: small spheres, or discs where they have normals.
class PointSet : public ShapeSurface {
public:
  PointSet(const ParameterList &variables, const Placement &placement);

  RTCGeometry make(RTCDevice device) override;
  void evaluate(const Hit &hit, Vec3f origin, Vec3f direction, const SurfaceNeeds &needs,
                SurfacePoint &point) const override;
  void interpolate(const Variable &variable, const Hit &hit, const SurfacePoint &point,
                   float *value) const override;
  void differentiate(const Variable &, uint32_t, const Hit &, const SurfacePoint &, double &byU,
                     double &byV) const override {
    byU = byV = 0; // one value for the whole of a point
  }

  std::vector<std::array<float, 4>> vertices; ///< place and radius
  std::vector<Vec3f> normals;                 ///< none: spheres

private:
  Placement placement;
};

} // namespace anysl::render

#endif
