//===-- tools/anysl-render/Geometry.cpp - surfaces and rays -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Geometry.h"

#include <anysl/abi.h>

#include <algorithm>
#include <limits>

using namespace anysl::render;

namespace {

/// Component k of ray i of Embree's N rays is rays[k * N + i]; these are the k.
enum RayComponent {
  OriginX,
  Near = 3,
  DirectionX = 4,
  Far = 8,
  HitNormal = 12,
  HitU = 15,
  HitV,
  HitPrimitive,
  HitGeometry,
  HitInstance
};

unsigned rayMask(const Appearance &appearance, bool opacityVaries) {
  unsigned mask = 0;
  if (appearance.visibility.camera)
    mask |= CameraRays;
  if (appearance.visibility.trace)
    mask |= TraceRays;
  const Vec3d &o = appearance.opacity;
  if (appearance.visibility.transmission == Visibility::Opaque)
    mask |= OpaqueShadowRays;
  else if (appearance.visibility.transmission == Visibility::ByOpacity) {
    if (opacityVaries || !(o.x >= 1 && o.y >= 1 && o.z >= 1))
      mask |= opacityVaries || !(o == Vec3d()) ? PartialShadowRays : 0;
    else
      mask |= OpaqueShadowRays;
  }
  return mask;
}

void reportEmbreeError(void *, RTCError code, const char *message) {
  std::fprintf(stderr, "anysl-render: Embree: %s (error %d)\n", message, int(code));
}

} // namespace

Geometry::Geometry(const SceneDescription &description, std::span<const uint32_t> groupOfShape) {
  device = rtcNewDevice(nullptr);
  if (!device)
    throw UserError("Embree cannot start on this machine");
  rtcSetDeviceErrorFunction(device, reportEmbreeError, nullptr);
  scene = rtcNewScene(device);
  // Watertight edges, and distances good enough for the offsets of secondary rays.
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);

  std::vector<unsigned> meshMasks;
  for (uint32_t i = 0; i < description.shapes.size(); ++i) {
    const Shape &shape = description.shapes[i];
    const Appearance &appearance = description.appearances[shape.appearance];
    Surface surface{i, groupOfShape[i], &appearance};
    const auto *swept = std::get_if<QuadricShape>(&shape.geometry);
    if (swept && Quadric::isQuadric(*swept)) {
      QuadricSet &set = quadricSets[rayMask(appearance, false)];
      set.quadrics.emplace_back(*swept, shape.objectToCamera, appearance);
      set.surfaces.push_back(surface);
      continue;
    }
    Mesh mesh = swept ? Mesh::fromSweep(*swept, shape.objectToCamera, appearance)
                      : Mesh::fromPolygons(std::get<PolygonShape>(shape.geometry),
                                           shape.objectToCamera, appearance);
    meshMasks.push_back(rayMask(appearance, mesh.hasOpacity()));
    meshes.push_back(std::make_unique<MeshSurface>(MeshSurface{std::move(mesh), surface}));
  }
  for (auto &[mask, set] : quadricSets)
    addQuadrics(set, mask);
  for (size_t i = 0; i < meshes.size(); ++i)
    addMesh(*meshes[i], meshMasks[i]);
  rtcCommitScene(scene);
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
    throw UserError("Embree cannot hold this scene");
}

Geometry::~Geometry() {
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

void Geometry::attach(RTCGeometry geometry, unsigned mask, Entry entry) {
  rtcSetGeometryMask(geometry, mask);
  rtcCommitGeometry(geometry);
  unsigned id = rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  if (entries.size() <= id)
    entries.resize(id + 1);
  entries[id] = entry;
  partialShadows |= (mask & PartialShadowRays) != 0;
}

//===-- Quadrics ------------------------------------------------------------//

template <bool IsOccluded>
void Geometry::intersectQuadrics(void *userData, unsigned primitive, unsigned geometry,
                                 RTCIntersectContext *context, int *valid, float *rays,
                                 unsigned count) {
  const Quadric &quadric = static_cast<QuadricSet *>(userData)->quadrics[primitive];
  constexpr unsigned most = 16;
  double nearer[most], farther[most];
  for (unsigned begin = 0; begin < count; begin += most) {
    unsigned end = std::min(count, begin + most);
    quadric.roots(rays + begin, count, end - begin, nearer, farther);
    for (unsigned i = begin; i < end; ++i) {
      auto component = [&](unsigned k) -> float & { return rays[k * count + i]; };
      auto index = [&](unsigned k) -> unsigned & {
        return reinterpret_cast<unsigned *>(rays)[k * count + i];
      };
      double t0 = nearer[i - begin], t1 = farther[i - begin];
      // Written so that NaN fails.
      if (!valid[i] || !(float(t1) > component(Near)) || !(float(t0) < component(Far)))
        continue;
      Vec3f origin(component(OriginX), component(OriginX + 1), component(OriginX + 2));
      Vec3f direction(component(DirectionX), component(DirectionX + 1), component(DirectionX + 2));
      double t = t0;
      if (!(float(t0) > component(Near)) || !quadric.accepts(origin, direction, t0)) {
        t = t1;
        if (!(float(t1) < component(Far)) || !quadric.accepts(origin, direction, t1))
          continue;
      }
      if constexpr (IsOccluded) {
        component(Far) = -std::numeric_limits<float>::infinity();
        continue;
      }
      component(Far) = float(t);
      for (unsigned k = HitNormal; k < HitNormal + 3; ++k)
        component(k) = 0; // computed by evaluate() for the one hit that stays
      component(HitU) = component(HitV) = 0;
      index(HitPrimitive) = primitive;
      index(HitGeometry) = geometry;
      index(HitInstance) = context->instID[0];
    }
  }
}

void Geometry::addQuadrics(QuadricSet &set, unsigned mask) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, unsigned(set.quadrics.size()));
  rtcSetGeometryUserData(geometry, &set);
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments *arguments) {
        const auto *set = static_cast<const QuadricSet *>(arguments->geometryUserPtr);
        Vec3f lower, upper;
        set->quadrics[arguments->primID].bounds(lower, upper);
        RTCBounds &b = *arguments->bounds_o;
        b.lower_x = lower.x, b.lower_y = lower.y, b.lower_z = lower.z;
        b.upper_x = upper.x, b.upper_y = upper.y, b.upper_z = upper.z;
      },
      nullptr);
  rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments *a) {
    intersectQuadrics<false>(a->geometryUserPtr, a->primID, a->geomID, a->context, a->valid,
                             reinterpret_cast<float *>(a->rayhit), a->N);
  });
  rtcSetGeometryOccludedFunction(geometry, [](const RTCOccludedFunctionNArguments *a) {
    intersectQuadrics<true>(a->geometryUserPtr, a->primID, a->geomID, a->context, a->valid,
                            reinterpret_cast<float *>(a->ray), a->N);
  });
  attach(geometry, mask, {&set, nullptr});
}

//===-- Meshes --------------------------------------------------------------//

void Geometry::addMesh(MeshSurface &surface, unsigned mask) {
  Mesh &mesh = surface.mesh;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             mesh.points.data(), 0, sizeof(Vec3f), mesh.points.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.triangles.data(), 0, sizeof(mesh.triangles[0]),
                             mesh.triangles.size());
  if (mesh.oneSided) {
    rtcSetGeometryUserData(geometry, &surface);
    auto filter = [](const RTCFilterFunctionNArguments *a) {
      const Mesh &mesh = static_cast<const MeshSurface *>(a->geometryUserPtr)->mesh;
      for (unsigned i = 0; i < a->N; ++i) {
        Vec3d ignored,
            normal = mesh.evaluate(RTCHitN_primID(a->hit, a->N, i), 0, 0, false, ignored).normal;
        Vec3d direction(RTCRayN_dir_x(a->ray, a->N, i), RTCRayN_dir_y(a->ray, a->N, i),
                        RTCRayN_dir_z(a->ray, a->N, i));
        if (a->valid[i] && dot(normal, direction) > 0)
          a->valid[i] = 0;
      }
    };
    rtcSetGeometryIntersectFilterFunction(geometry, filter);
    rtcSetGeometryOccludedFilterFunction(geometry, filter);
  }
  attach(geometry, mask, {nullptr, &surface});
}

//===-- Rays ----------------------------------------------------------------//

namespace anysl::render {

template <unsigned W>
void Geometry::intersect(const int *valid, typename RayPacketType<W>::RayHit &rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  // Rays that neighbouring points trace are alike enough: a tenth faster for them as well.
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  if constexpr (W == 1)
    rtcIntersect1(scene, &context, &rays);
  else if constexpr (W == 4)
    rtcIntersect4(valid, scene, &context, &rays);
  else if constexpr (W == 8)
    rtcIntersect8(valid, scene, &context, &rays);
  else
    rtcIntersect16(valid, scene, &context, &rays);
}

Hit Geometry::intersect(const Ray &ray, unsigned mask) const {
  RTCRayHit query;
  const Vec3f &o = ray.origin, &d = ray.direction;
  query.ray = {o.x, o.y, o.z, ray.near, d.x, d.y, d.z, 0, ray.far, mask, 0, 0};
  query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersect<1>(nullptr, query);
  return {query.ray.tfar, query.hit.u, query.hit.v, query.hit.geomID, query.hit.primID};
}

template <unsigned W>
void Geometry::occluded(const int *valid, typename RayPacketType<W>::Ray &rays) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if constexpr (W == 1)
    rtcOccluded1(scene, &context, &rays);
  else if constexpr (W == 4)
    rtcOccluded4(valid, scene, &context, &rays);
  else if constexpr (W == 8)
    rtcOccluded8(valid, scene, &context, &rays);
  else
    rtcOccluded16(valid, scene, &context, &rays);
}

#define ANYSL_RENDER_WIDTH(W)                                                                      \
  template void Geometry::intersect<W>(const int *, RayPacketType<W>::RayHit &) const;             \
  template void Geometry::occluded<W>(const int *, RayPacketType<W>::Ray &) const;
ANYSL_RENDER_WIDTH(1)
ANYSL_RENDER_WIDTH(4)
ANYSL_RENDER_WIDTH(8)
ANYSL_RENDER_WIDTH(16)
#undef ANYSL_RENDER_WIDTH

} // namespace anysl::render

//===-- Hits ----------------------------------------------------------------//

const Geometry::Surface &Geometry::surfaceOf(const Hit &hit) const {
  const Entry &entry = entries[hit.geometry];
  return entry.quadrics ? entry.quadrics->surfaces[hit.primitive] : entry.mesh->surface;
}

uint32_t Geometry::groupOf(const Hit &hit) const { return surfaceOf(hit).group; }
uint32_t Geometry::shapeOf(const Hit &hit) const { return surfaceOf(hit).shape; }

Vec3d Geometry::opacityAt(const Hit &hit) const {
  Vec3d opacity = surfaceOf(hit).appearance->opacity;
  if (const MeshSurface *mesh = entries[hit.geometry].mesh)
    mesh->mesh.opacity(hit.primitive, hit.u, hit.v, opacity);
  return opacity;
}

void Geometry::evaluate(const Hit &hit, Vec3f origin, Vec3f direction, uint64_t needed,
                        SurfacePoint &point) const {
  const Entry &entry = entries[hit.geometry];
  const Appearance &appearance = *surfaceOf(hit).appearance;
  point.color = appearance.color;
  point.opacity = appearance.opacity;
  double magnitude = 0;
  constexpr auto bits = [](auto... globals) { return ((uint64_t(1) << globals) | ...); };
  constexpr uint64_t texture = bits(ANYSL_s, ANYSL_t);
  bool parametric = (needed & (texture | bits(ANYSL_u, ANYSL_v, ANYSL_dPdu, ANYSL_dPdv))) != 0;
  if (entry.quadrics) {
    const Quadric &quadric = entry.quadrics->quadrics[hit.primitive];
    point.frame = quadric.evaluate(origin, direction, hit.t, parametric);
    point.frame.normal = point.normal = normalized(point.frame.normal);
  } else {
    const Mesh &mesh = entry.mesh->mesh;
    point.frame = mesh.evaluate(hit.primitive, hit.u, hit.v, parametric, point.normal);
    point.frame.normal = normalized(point.frame.normal);
    point.normal = normalized(point.normal);
    magnitude = mesh.magnitude(hit.primitive);
    // Along the shading normal, so that it tells on which side of the smooth surface a ray goes.
    point.lift = point.normal * length(mesh.lift(hit.primitive, hit.u, hit.v, point.frame.P));
  }
  if (needed & texture) {
    double u = point.frame.u, v = point.frame.v;
    const auto &st = appearance.textureCoordinates;
    bool quadric = entry.quadrics != nullptr;
    // The corners are those of a quadric; a polygon's default is its u and v.
    point.s =
        quadric ? (1 - v) * ((1 - u) * st[0] + u * st[2]) + v * ((1 - u) * st[4] + u * st[6]) : u;
    point.t =
        quadric ? (1 - v) * ((1 - u) * st[1] + u * st[3]) + v * ((1 - u) * st[5] + u * st[7]) : v;
  }
  if (entry.mesh) {
    const Mesh &mesh = entry.mesh->mesh;
    mesh.texture(hit.primitive, hit.u, hit.v, point.s, point.t);
    mesh.color(hit.primitive, hit.u, hit.v, point.color);
    mesh.opacity(hit.primitive, hit.u, hit.v, point.opacity);
  }
  // P is rounded by half an ulp of each of its coordinates, and Embree computes with the corners of
  // a triangle relative to the ray's origin. 32 ulps leave room for the rounding of the ray's
  // start.
  magnitude = std::max({magnitude, maxAbs(point.frame.P), 1e-30});
  point.offset = float(magnitude * 0x1p-18);
}
