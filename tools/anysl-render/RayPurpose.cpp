//===-- tools/anysl-render/RayPurpose.cpp - what rays are traced for --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/RayPurpose.h"

#include <algorithm>

using namespace anysl::render;

RayPurpose anysl::render::tracedFrom(const RayPath &from, RayKind kind) {
  RayPurpose purpose;
  purpose.path = from.then(kind);
  purpose.mask = kind == RayKind::Diffuse ? DiffuseRays : SpecularRays;
  return purpose;
}

RayPurpose anysl::render::askedFrom(const RayPath &from, const AnyslHits &hits) {
  std::string_view kind = hits.kind, sides = hits.sides;
  RayPurpose purpose = tracedFrom(from, kind == "diffuse"        ? RayKind::Diffuse
                                        : kind == "transmission" ? RayKind::Shadow
                                                                 : RayKind::Traced);
  purpose.layers = hits.shades == ANYSL_SHADE_ALL ? maxLayers : 1;
  purpose.subset = hits.subset;
  purpose.sides = sides == "front"  ? RayPurpose::Front
                  : sides == "back" ? RayPurpose::Back
                                    : RayPurpose::Both;
  return purpose;
}

bool anysl::render::isWithinDepth(const Scene &scene, const ShadingGroup &group,
                                  const RayPath &path) {
  return path.depth <= scene.description.maxDepth &&
         (path.kind == RayKind::Diffuse ? path.diffuse <= group.maxDiffuseDepth
                                        : path.specular() <= group.maxSpecularDepth);
}

bool anysl::render::isInSubset(const std::vector<std::string> &sets, std::string_view subset) {
  bool isWanted = false, wantsSome = false;
  while (!subset.empty()) {
    auto [sign, name] = takeSetName(subset);
    if (name.empty())
      continue;
    bool isExcluded = sign == '-';
    bool isMember = std::find(sets.begin(), sets.end(), name) != sets.end();
    if (isExcluded && isMember)
      return false;
    isWanted |= !isExcluded && isMember;
    wantsSome |= !isExcluded;
  }
  return isWanted || !wantsSome;
}

static bool sees(const Scene &scene, const Ray &ray, const Hit &hit, const RayPurpose &purpose) {
  const Geometry &geometry = scene.geometry();
  if (purpose.sides != RayPurpose::Both) {
    SurfacePoint point;
    geometry.evaluate(hit, ray.origin, ray.direction, 0, point);
    bool isFront = dot(point.frame.normal, Vec3d(ray.direction)) < 0;
    if (isFront != (purpose.sides == RayPurpose::Front))
      return false;
  }
  const SceneDescription &description = scene.description;
  return isInSubset(
      description.appearances[description.shapes[geometry.shapeOf(hit)].appearance].sets,
      purpose.subset);
}

Hit anysl::render::nearestHit(const Scene &scene, Ray ray, const RayPurpose &purpose) {
  return firstSeen(scene, ray, scene.geometry().intersect(ray, purpose.mask), purpose);
}

Hit anysl::render::firstSeen(const Scene &scene, Ray ray, Hit hit, const RayPurpose &purpose) {
  while (purpose.chooses() && hit.isHit() && !sees(scene, ray, hit, purpose)) {
    ray.near = afterHit(hit.t);
    hit = scene.geometry().intersect(ray, purpose.mask);
  }
  return hit;
}
