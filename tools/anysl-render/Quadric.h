//===-- tools/anysl-render/Quadric.h - exact quadrics -----------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_QUADRIC_H
#define ANYSL_RENDER_QUADRIC_H

#include "tools/anysl-render/Surface.h"

namespace anysl::render {

/// A quadric swept about z: the points of A (x² + y²) + B z² + C z + D = 0 within limits of z (or
/// of the radius, for a disk) and of the sweep. All kinds share one intersection and one
/// refinement.
///
/// Rays are given in single precision and answered in double, so that the distance is as good as a
/// float can be, from any distance: the quadratic is solved about the ray's point that is nearest
/// to the object's origin, which keeps b² - 4ac from cancelling (after Haines et al., Ray Tracing
/// Gems, chapter 7).
class Quadric {
public:
  /// Any kind but Torus, and Hyperboloid only where isQuadric() holds.
  Quadric(const QuadricShape &shape, const Matrix4 &objectToCamera, const Appearance &appearance);
  static bool isQuadric(const QuadricShape &shape);

  /// The box around the surface in camera space.
  void bounds(Vec3f &lower, Vec3f &upper) const;

  /// For each of `count` <= 16 rays, the two distances at which it meets the unlimited surface, the
  /// nearer first; NaN where it does not. Component k of ray i is rays[k * stride + i], in the
  /// order origin x y z, one unused, direction x y z.
  void roots(const float *__restrict rays, unsigned stride, unsigned count,
             double *__restrict first, double *__restrict second) const;

  /// Whether the point at distance t lies within the limits, on a side that is to be seen.
  bool accepts(Vec3f origin, Vec3f direction, double t) const;

  /// The surface at the hit at distance t, moved onto the surface exactly. Parameters and
  /// derivatives are computed only if asked for.
  SurfaceFrame evaluate(Vec3f origin, Vec3f direction, double t, bool parametric = true) const;

  /// The derivatives of evaluate()'s normal by u and v.
  void normalDerivatives(const SurfaceFrame &frame, Vec3d &byU, Vec3d &byV) const;

private:
  Vec3d refine(Vec3d p) const;
  Vec3d gradient(Vec3d p) const;
  double angle(Vec3d p) const;
  /// Everything but P's own transformation, in object space; the normal from the derivatives.
  SurfaceFrame objectFrame(Vec3d p) const;

  QuadricShape shape;
  Matrix4 toCamera, toObject;
  double a = 0, b = 0, c = 0, d = 0;
  double zmin, zmax;             ///< limits in order, infinite where there are none
  double maxRadius = 0;          ///< of any point
  double thetaMax;               ///< radians, with its sign
  double phiMin = 0, phiMax = 0; ///< sphere: latitude
  double normalSign = 1;         ///< gradient to the normal dPdu x dPdv
  bool limitedZ = false, limitedRadius = false, limitedSweep = false;
  bool reverse, oneSided;
};

} // namespace anysl::render

#endif
