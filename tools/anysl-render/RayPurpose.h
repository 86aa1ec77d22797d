//===-- tools/anysl-render/RayPurpose.h - what rays are traced for ----------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_RAYPURPOSE_H
#define ANYSL_RENDER_RAYPURPOSE_H

#include "tools/anysl-render/Scene.h"

namespace anysl::render {

/// How many surfaces in a row may let a camera ray or traced ray pass.
constexpr unsigned maxLayers = 64;

/// What all rays of a list have in common.
struct RayPurpose {
  RayPath path;                ///< of the points that they lead to
  unsigned mask = CameraRays;  ///< which surfaces they see
  unsigned layers = maxLayers; ///< how many of them, one behind the other
  std::string_view subset;     ///< of the surfaces, by the names of sets
  enum { Both, Front, Back } sides = Both;

  /// Whether they may pass by a surface that the mask lets them see.
  bool chooses() const { return !subset.empty() || sides != Both; }
};

/// The rays that shaders trace from points which a path has led to.
RayPurpose tracedFrom(const RayPath &from, RayKind kind);
/// The same as the shader wants them.
RayPurpose askedFrom(const RayPath &from, const AnyslHits &hits);

/// Whether light along such rays still counts, which start on surfaces of a group.
bool isWithinDepth(const Scene &scene, const ShadingGroup &group, const RayPath &path);

/// Whether a surface that is in these sets is in a subset.
bool isInSubset(const std::vector<std::string> &sets, std::string_view subset);

/// The nearest surface that a ray sees.
Hit nearestHit(const Scene &scene, Ray ray, const RayPurpose &purpose);
/// The same where the nearest of the mask's is known already.
Hit firstSeen(const Scene &scene, Ray ray, Hit hit, const RayPurpose &purpose);

/// Where a shadow ray goes on that has passed a surface at distance t.
inline float afterHit(float t) { return std::nextafter(t * (1 + 0x1p-20f), 1e30f); }

} // namespace anysl::render

#endif
