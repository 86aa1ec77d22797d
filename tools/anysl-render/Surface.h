//===-- tools/anysl-render/Surface.h - what every kind of geometry offers ---------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_SURFACE_H
#define ANYSL_RENDER_SURFACE_H

#include "lib/Rib/PrimitiveVariables.h"

#include <embree3/rtcore.h>

namespace anysl::render {

/// Where a ray met a surface.
struct Hit {
  float t = 0, u = 0, v = 0;
  uint32_t geometry = RTC_INVALID_GEOMETRY_ID, primitive = 0;
  bool isHit() const { return geometry != RTC_INVALID_GEOMETRY_ID; }
};

/// Position, normal and derivatives at a point of a surface; the normal is not of unit length.
struct SurfaceFrame {
  Vec3d P, normal, dPdu, dPdv;
  double u = 0, v = 0;
};

/// How far u and v go in a step.
struct ParameterStep {
  double u = 0, v = 0;
};

/// What a shader may ask about a hit, in camera space.
struct SurfacePoint {
  SurfaceFrame frame; ///< frame.normal is the geometric normal, of unit length
  Vec3d normal;       ///< the shading normal, of unit length
  double s = 0, t = 0;
  Vec3d color, opacity;
  float offset = 0; ///< how far a ray has to start off the surface not to meet it again
  Vec3d lift;       ///< from a facet to the smooth surface that it stands for
  // Only where they are asked for:
  Vec3d dNdu, dNdv;   ///< of the shading normal
  Vec3d dNgdu, dNgdv; ///< of the geometric normal
  double dsdu = 0, dsdv = 0, dtdu = 0, dtdv = 0;
  Vec3d dCsdu, dCsdv, dOsdu, dOsdv;
  // The footprint of a pixel (Footprint.h):
  double du = 0, dv = 0;
  ParameterStep toRight, down; ///< from pixel to pixel
  Vec3d dIdu, dIdv;
};

/// What to find out about a hit.
struct SurfaceNeeds {
  bool parametric = false;  ///< u, v, dPdu and dPdv
  bool texture = false;     ///< s and t
  bool derivatives = false; ///< of normals, s and t, colour and opacity by u and v
};

/// The shape that a piece of surface belongs to.
struct SurfaceOwner {
  uint32_t shape = 0; ///< index into the description
  uint32_t group = 0;
  const Appearance *appearance = nullptr;
};

/// Text that a shader has put out, the same all over a surface.
struct TextVariable {
  std::string name;
  bool isArray;
  std::vector<const char *> elements;
};

/// The variables of a shape, and where among them those are that a renderer looks for.
struct SurfaceVariables {
  SurfaceVariables() = default;
  explicit SurfaceVariables(std::vector<Variable> all);

  std::vector<Variable> list;
  std::vector<TextVariable> texts;
  int color = -1, opacity = -1, s = -1, t = -1, st = -1;
};

/// One geometry of Embree's: surfaces of one kind that the same rays see.
class SurfaceSet {
public:
  virtual ~SurfaceSet() = default;

  /// Makes Embree's geometry, not yet committed. The set stays where it is from then on.
  virtual RTCGeometry make(RTCDevice device) = 0;
  virtual const SurfaceOwner &owner(uint32_t primitive) const = 0;
  virtual const SurfaceVariables &variables(uint32_t primitive) const = 0;
  /// Whether u and v run over the unit square, so that TextureCoordinates tell s and t.
  virtual bool hasUnitParameters() const { return true; }

  /// Fills in the frame, both normals with their derivatives, lift, and, as `offset`, the size
  /// of the numbers that the hit was computed from. Normals need not be of unit length; derivatives
  /// are of the normal as it is handed out.
  virtual void evaluate(const Hit &hit, Vec3f origin, Vec3f direction, const SurfaceNeeds &needs,
                        SurfacePoint &point) const = 0;
  /// The value of a variable at a point that evaluate() has found, with its parameters.
  virtual void interpolate(const Variable &variable, const Hit &hit, const SurfacePoint &point,
                           float *value) const = 0;
  /// The derivatives of one of its components by u and v.
  virtual void differentiate(const Variable &variable, uint32_t component, const Hit &hit,
                             const SurfacePoint &point, double &byU, double &byV) const = 0;
};

/// The variables of a surface at a point that evaluate() has found.
struct VariablesAt {
  const SurfaceSet &set;
  const Hit &hit;
  const SurfacePoint &point;

  void value(uint32_t variable, float *result) const {
    set.interpolate(at(variable), hit, point, result);
  }
  /// The derivatives of one component.
  void slope(uint32_t variable, uint32_t component, double &byU, double &byV) const {
    byU = byV = 0;
    set.differentiate(at(variable), component, hit, point, byU, byV);
  }

private:
  const Variable &at(uint32_t variable) const {
    return set.variables(hit.primitive).list[variable];
  }
};

/// All of one shape.
class ShapeSurface : public SurfaceSet {
public:
  const SurfaceOwner &owner(uint32_t) const override { return itsOwner; }
  const SurfaceVariables &variables(uint32_t) const override { return values; }

  SurfaceOwner itsOwner;
  SurfaceVariables values;
};

} // namespace anysl::render

#endif
