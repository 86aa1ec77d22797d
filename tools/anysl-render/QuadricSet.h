//===-- tools/anysl-render/QuadricSet.h - exact quadrics in Embree ----------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_QUADRICSET_H
#define ANYSL_RENDER_QUADRICSET_H

#include "tools/anysl-render/Quadric.h"

namespace anysl::render {

/// The quadrics that the same kinds of ray see, as primitives of Embree's that this intersects.
class QuadricSet : public SurfaceSet {
public:
  void add(const QuadricShape &shape, const ParameterList &variables, const Placement &placement,
           const SurfaceOwner &owner);

  RTCGeometry make(RTCDevice device) override;
  const SurfaceOwner &owner(uint32_t primitive) const override { return owners[primitive]; }
  const SurfaceVariables &variables(uint32_t primitive) const override;
  void evaluate(const Hit &hit, Vec3f origin, Vec3f direction, const SurfaceNeeds &needs,
                SurfacePoint &point) const override;
  void interpolate(const Variable &variable, const Hit &hit, const SurfacePoint &point,
                   float *value) const override;
  void differentiate(const Variable &variable, uint32_t component, const Hit &hit,
                     const SurfacePoint &point, double &byU, double &byV) const override;

private:
  template <bool IsOccluded>
  static void intersect(void *userData, unsigned primitive, unsigned geometry,
                        RTCIntersectContext *context, int *valid, float *rays, unsigned count);

  std::vector<Quadric> quadrics;
  std::vector<SurfaceOwner> owners;
  std::map<uint32_t, SurfaceVariables> values; ///< of those that have any
};

} // namespace anysl::render

#endif
