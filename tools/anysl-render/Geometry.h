//===-- tools/anysl-render/Geometry.h - surfaces and rays -------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_GEOMETRY_H
#define ANYSL_RENDER_GEOMETRY_H

#include "lib/Rib/Camera.h"
#include "tools/anysl-render/Mesh.h"
#include "tools/anysl-render/PointSet.h"

#include <functional>
#include <memory>
#include <span>
#include <variant>

namespace anysl::render {

/// What a displacement shader moves, and what lets it do so by the number of the shape.
using DisplacedSurface = std::variant<Mesh *, PointSet *>;
using Displace = std::function<void(uint32_t shape, DisplacedSurface surface)>;

/// Kinds of ray, as bits of Embree's mask.
enum RayMask : unsigned {
  CameraRays = 1,
  SpecularRays = 2,
  OpaqueShadowRays = 4,  ///< surfaces that stop all light
  PartialShadowRays = 8, ///< surfaces that stop a part of it
  DiffuseRays = 16,
};

/// The bit of Geometry::evaluate()'s `needed` that asks for the derivatives of N, s and t.
constexpr uint64_t derivativesBit = uint64_t(1) << 63;

/// W rays at once in Embree's layout; one ray for W = 1.
template <unsigned W>
struct RayPacketType;
template <>
struct RayPacketType<1> {
  using RayHit = RTCRayHit;
  using Ray = RTCRay;
};
template <>
struct RayPacketType<4> {
  using RayHit = RTCRayHit4;
  using Ray = RTCRay4;
};
template <>
struct RayPacketType<8> {
  using RayHit = RTCRayHit8;
  using Ray = RTCRay8;
};
template <>
struct RayPacketType<16> {
  using RayHit = RTCRayHit16;
  using Ray = RTCRay16;
};

/// Fills in what the bits of `needed` (1 << ANYSL_P ..., derivativesBit) ask for about a hit on a
/// surface; P, Ng and offset always.
void evaluateSurface(const SurfaceSet &set, const Hit &hit, Vec3f origin, Vec3f direction,
                     uint64_t needed, SurfacePoint &point);

/// All surfaces of a scene.
class Geometry {
public:
  /// `groupOfShape` says for each shape of the description which group its hits belong to.
  /// `displace` moves the facets or particles of a shape that has a displacement shader.
  Geometry(const SceneDescription &description, const Camera &camera,
           std::span<const uint32_t> groupOfShape, const Displace &displace = nullptr);
  ~Geometry();
  Geometry(const Geometry &) = delete;
  Geometry &operator=(const Geometry &) = delete;

  /// Finds the nearest hit of each valid ray (-1: valid, 0: not), at a width of W.
  template <unsigned W>
  void intersect(const int *valid, typename RayPacketType<W>::RayHit &rays) const;
  /// The nearest hit of one ray among the surfaces of a mask.
  Hit intersect(const Ray &ray, unsigned mask) const;
  /// Sets tfar of each valid ray to -infinity where anything is in its way.
  template <unsigned W>
  void occluded(const int *valid, typename RayPacketType<W>::Ray &rays) const;

  /// Whether some surface lets a part of the light through to shadow rays.
  bool hasPartialShadows() const { return partialShadows; }

  uint32_t groupOf(const Hit &hit) const;
  /// The shape that was hit: an index into the description.
  uint32_t shapeOf(const Hit &hit) const;
  /// The same for one that a ray has met.
  void evaluate(const Hit &hit, Vec3f origin, Vec3f direction, uint64_t needed,
                SurfacePoint &point) const {
    evaluateSurface(*sets[hit.geometry], hit, origin, direction, needed, point);
  }
  /// The opacity at a hit, as a shadow ray asks for it.
  Vec3d opacityAt(const Hit &hit, Vec3f origin, Vec3f direction) const;
  /// The variables of the shape that was hit.
  const SurfaceVariables &variablesOf(const Hit &hit) const {
    return sets[hit.geometry]->variables(hit.primitive);
  }
  /// Their values at a hit that was evaluated; both must outlive the result.
  VariablesAt variablesAt(const Hit &hit, const SurfacePoint &point) const {
    return {*sets[hit.geometry], hit, point};
  }

private:
  void attach(std::unique_ptr<SurfaceSet> set, unsigned mask);

  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  bool partialShadows = false;
  std::vector<std::unique_ptr<SurfaceSet>> sets; ///< by Embree's geometry number
};

} // namespace anysl::render

#endif
