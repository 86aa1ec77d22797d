//===-- tools/anysl-render/Curves.h - tubes and ribbons along curves --------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_CURVES_H
#define ANYSL_RENDER_CURVES_H

#include "tools/anysl-render/Dicing.h"

namespace anysl::render {

/// The curves of a shape as Bézier segments in camera space, whatever their basis.
class CurveSegments {
public:
  CurveSegments(const CurvesShape &shape, const ParameterList &variables,
                const Placement &placement);

  struct Segment {
    uint32_t curve;
    uint32_t index, count;       ///< of the segments of its curve
    uint32_t vertices[4];        ///< two for a linear one
    uint32_t varying[2];         ///< values at its ends
    std::array<Vec3d, 4> points; ///< of a Bézier curve
    std::array<double, 4> radii; ///< likewise, half the widths
  };
  const std::vector<Segment> &all() const { return segments; }

  /// A place on a segment, with its radius, and the derivative by t.
  static Vec3d place(const Segment &segment, double t, Vec3d &tangent, double &radius);
  /// The value of a variable, and the derivative of each component by t, which may be null.
  void value(const Variable &variable, StorageClass storage, const Segment &segment, double t,
             float *value, double *derivative) const;

private:
  const CurvesShape shape;
  std::vector<Segment> segments;
};

/// Thin tubes, which Embree intersects. They have the widths of ribbons that face each ray, but a
/// ray that leaves one does not meet it again, as it would where such a ribbon turns with the ray.
class CurveSet : public ShapeSurface {
public:
  CurveSet(const CurvesShape &shape, const ParameterList &variables, const Placement &placement);

  RTCGeometry make(RTCDevice device) override;
  void evaluate(const Hit &hit, Vec3f origin, Vec3f direction, const SurfaceNeeds &needs,
                SurfacePoint &point) const override;
  void interpolate(const Variable &variable, const Hit &hit, const SurfacePoint &point,
                   float *value) const override;
  void differentiate(const Variable &variable, uint32_t component, const Hit &hit,
                     const SurfacePoint &point, double &byU, double &byV) const override;

private:
  StorageClass storageOf(const Variable &variable) const {
    return storages[size_t(&variable - values.list.data())];
  }

  Placement placement;
  CurveSegments curves;
  std::vector<StorageClass> storages; ///< as the list of variables
  std::vector<std::array<float, 4>> vertices;
  std::vector<uint32_t> firstVertices;
};

} // namespace anysl::render

#endif
