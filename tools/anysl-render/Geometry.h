//===-- tools/anysl-render/Geometry.h - surfaces and rays -------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_GEOMETRY_H
#define ANYSL_RENDER_GEOMETRY_H

#include "tools/anysl-render/Camera.h"
#include "tools/anysl-render/Mesh.h"

#include <embree3/rtcore.h>

#include <memory>
#include <span>

namespace anysl::render {

/// Kinds of ray, as bits of Embree's mask.
enum RayMask : unsigned {
  CameraRays = 1,
  TraceRays = 2,
  OpaqueShadowRays = 4,  ///< surfaces that stop all light
  PartialShadowRays = 8, ///< surfaces that stop a part of it
};

/// Where a ray met a surface.
struct Hit {
  float t = 0, u = 0, v = 0;
  uint32_t geometry = RTC_INVALID_GEOMETRY_ID, primitive = 0;
  bool isHit() const { return geometry != RTC_INVALID_GEOMETRY_ID; }
};

/// What a shader may ask about a hit, in camera space.
struct SurfacePoint {
  SurfaceFrame frame; ///< frame.normal is the geometric normal, of unit length
  Vec3d normal;       ///< the shading normal, of unit length
  double s = 0, t = 0;
  Vec3d color, opacity;
  float offset = 0; ///< how far a ray has to start off the surface not to meet it again
  Vec3d lift;       ///< from a facet to the smooth surface that it stands for
};

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

/// All surfaces of a scene.
class Geometry {
public:
  /// `groupOfShape` says for each shape of the description which group its hits belong to.
  Geometry(const SceneDescription &description, std::span<const uint32_t> groupOfShape);
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
  /// Fills in what the bits of `needed` (1 << ANYSL_P ...) ask for; P, Ng and offset always.
  void evaluate(const Hit &hit, Vec3f origin, Vec3f direction, uint64_t needed,
                SurfacePoint &point) const;
  /// The opacity at a hit, as a shadow ray asks for it.
  Vec3d opacityAt(const Hit &hit) const;

private:
  struct Surface {
    uint32_t shape, group;
    const Appearance *appearance;
  };
  /// The quadrics that the same kinds of ray see: one geometry of Embree's.
  struct QuadricSet {
    std::vector<Quadric> quadrics;
    std::vector<Surface> surfaces;
  };
  struct MeshSurface {
    Mesh mesh;
    Surface surface;
  };
  struct Entry {
    const QuadricSet *quadrics = nullptr; ///< one of these two
    const MeshSurface *mesh = nullptr;
  };

  const Surface &surfaceOf(const Hit &hit) const;
  void addQuadrics(QuadricSet &set, unsigned mask);
  void addMesh(MeshSurface &mesh, unsigned mask);
  void attach(RTCGeometry geometry, unsigned mask, Entry entry);
  template <bool IsOccluded>
  static void intersectQuadrics(void *userData, unsigned primitive, unsigned geometry,
                                RTCIntersectContext *context, int *valid, float *rays,
                                unsigned count);

  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  bool partialShadows = false;
  std::map<unsigned, QuadricSet> quadricSets; ///< by ray mask
  std::vector<std::unique_ptr<MeshSurface>> meshes;
  std::vector<Entry> entries; ///< by Embree's geometry number
};

} // namespace anysl::render

#endif
