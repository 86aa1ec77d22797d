//===-- tools/anysl-render/Geometry.cpp - surfaces and rays -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Geometry.h"
#include "tools/anysl-render/Curves.h"
#include "tools/anysl-render/PointSet.h"
#include "tools/anysl-render/QuadricSet.h"
#include "tools/anysl-render/Tessellate.h"

#include <anysl/abi.h>

#include <algorithm>

using namespace anysl::render;

namespace {

unsigned rayMask(const Appearance &appearance, bool opacityVaries) {
  unsigned mask = 0;
  if (appearance.visibility.camera)
    mask |= CameraRays;
  if (appearance.visibility.specular)
    mask |= SpecularRays;
  if (appearance.visibility.diffuse)
    mask |= DiffuseRays;
  const Vec3d &o = appearance.opacity;
  if (appearance.visibility.transmission == Visibility::Opaque)
    mask |= OpaqueShadowRays;
  else if (appearance.visibility.transmission == Visibility::ByShader)
    mask |= PartialShadowRays;
  else if (appearance.visibility.transmission == Visibility::ByOpacity) {
    if (opacityVaries || !(o.x >= 1 && o.y >= 1 && o.z >= 1))
      mask |= opacityVaries || !(o == Vec3d()) ? PartialShadowRays : 0;
    else
      mask |= OpaqueShadowRays;
  }
  return mask;
}

Vec3d triple(const SurfaceSet &set, const Variable &variable, const Hit &hit,
             const SurfacePoint &point) {
  float value[3];
  set.interpolate(variable, hit, point, value);
  return {value[0], value[1], value[2]};
}

/// Makes a normal one of unit length, and its derivatives those of that.
void normalize(Vec3d &normal, Vec3d &byU, Vec3d &byV) {
  double size = length(normal);
  normal = normalized(normal);
  for (Vec3d *derivative : {&byU, &byV})
    if (size > 0)
      *derivative = (*derivative - normal * dot(normal, *derivative)) * (1 / size);
}

void reportEmbreeError(void *, RTCError code, const char *message) {
  std::fprintf(stderr, "anysl-render: Embree: %s (error %d)\n", message, int(code));
}

} // namespace

Geometry::Geometry(const SceneDescription &description, const Camera &camera,
                   std::span<const uint32_t> groupOfShape, const Displace &displace) {
  device = rtcNewDevice(nullptr);
  if (!device)
    throw UserError("Embree cannot start on this machine");
  rtcSetDeviceErrorFunction(device, reportEmbreeError, nullptr);
  scene = rtcNewScene(device);
  // Watertight edges, and distances good enough for the offsets of secondary rays.
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);

  Dicing dicing(camera);
  std::map<unsigned, std::unique_ptr<QuadricSet>> quadrics;
  for (uint32_t i = 0; i < description.shapes.size(); ++i) {
    const Shape &shape = description.shapes[i];
    const Appearance &appearance = description.appearances[shape.appearance];
    SurfaceOwner owner{i, groupOfShape[i], &appearance};
    Placement placement(shape.objectToCamera, appearance);
    unsigned mask = rayMask(appearance, findParameter(shape.variables, "Os") != nullptr);
    if (appearance.displacement >= 0 && displace) {
      // Micropolygons, as other kinds of renderer have them: of ShadingRate pixels each.
      Dicing fine = dicing;
      fine.edge = std::sqrt(std::max(0.01, appearance.shadingRate));
      if (std::unique_ptr<Mesh> mesh = tessellate(shape, placement, fine)) {
        if (std::holds_alternative<PolygonShape>(shape.geometry))
          refine(*mesh, fine);
        mesh->itsOwner = owner;
        displace(i, mesh.get());
        attach(std::move(mesh), mask);
        continue;
      }
    }
    const auto *swept = std::get_if<QuadricShape>(&shape.geometry);
    if (swept && Quadric::isQuadric(*swept)) {
      auto &set = quadrics[mask];
      if (!set)
        set = std::make_unique<QuadricSet>();
      set->add(*swept, shape.variables, placement, owner);
      continue;
    }
    std::unique_ptr<ShapeSurface> surface;
    const auto *curves = std::get_if<CurvesShape>(&shape.geometry);
    if (curves && !findParameter(shape.variables, "N"))
      surface = std::make_unique<CurveSet>(*curves, shape.variables, placement);
    else if (std::holds_alternative<PointsShape>(shape.geometry)) {
      auto points = std::make_unique<PointSet>(shape.variables, placement);
      points->itsOwner = owner;
      if (appearance.displacement >= 0 && displace)
        displace(i, points.get());
      surface = std::move(points);
    } else
      surface = tessellate(shape, placement, dicing);
    surface->itsOwner = owner;
    attach(std::move(surface), mask);
  }
  for (auto &[mask, set] : quadrics)
    attach(std::move(set), mask);
  rtcCommitScene(scene);
  if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
    throw UserError("Embree cannot hold this scene");
}

Geometry::~Geometry() {
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

void Geometry::attach(std::unique_ptr<SurfaceSet> set, unsigned mask) {
  RTCGeometry geometry = set->make(device);
  rtcSetGeometryMask(geometry, mask);
  rtcCommitGeometry(geometry);
  unsigned id = rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  if (sets.size() <= id)
    sets.resize(id + 1);
  sets[id] = std::move(set);
  partialShadows |= (mask & PartialShadowRays) != 0;
}

//===-- Rays ----------------------------------------------------------------//

/// Makes rays that are not valid such that they meet nothing: where the processor has no vectors of
/// 16 numbers, Embree takes packets of 16 apart and looks at the rays alone.
static void disable(const int *valid, RTCRay16 &rays) {
  for (size_t i = 0; i < 16; ++i)
    if (!valid[i])
      rays.tnear[i] = 0, rays.tfar[i] = -1;
}

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
  else {
    disable(valid, rays.ray);
    rtcIntersect16(valid, scene, &context, &rays);
  }
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
  else {
    disable(valid, rays);
    rtcOccluded16(valid, scene, &context, &rays);
  }
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

uint32_t Geometry::groupOf(const Hit &hit) const {
  return sets[hit.geometry]->owner(hit.primitive).group;
}
uint32_t Geometry::shapeOf(const Hit &hit) const {
  return sets[hit.geometry]->owner(hit.primitive).shape;
}

Vec3d Geometry::opacityAt(const Hit &hit, Vec3f origin, Vec3f direction) const {
  const SurfaceSet &set = *sets[hit.geometry];
  Vec3d opacity = set.owner(hit.primitive).appearance->opacity;
  const SurfaceVariables &variables = set.variables(hit.primitive);
  if (variables.opacity >= 0) {
    SurfacePoint point;
    set.evaluate(hit, origin, direction, {.parametric = true}, point);
    opacity = triple(set, variables.list[size_t(variables.opacity)], hit, point);
  }
  return opacity;
}

namespace {

/// s and t where the shape has none of its own: those at the corners of the parameters' square.
void cornerTexture(const std::array<double, 8> &st, SurfacePoint &point) {
  double u = point.frame.u, v = point.frame.v;
  auto between = [&](size_t k) {
    return (1 - v) * ((1 - u) * st[k] + u * st[2 + k]) + v * ((1 - u) * st[4 + k] + u * st[6 + k]);
  };
  auto byU = [&](size_t k) { return (1 - v) * (st[2 + k] - st[k]) + v * (st[6 + k] - st[4 + k]); };
  auto byV = [&](size_t k) { return (1 - u) * (st[4 + k] - st[k]) + u * (st[6 + k] - st[2 + k]); };
  point.s = between(0), point.t = between(1);
  point.dsdu = byU(0), point.dtdu = byU(1);
  point.dsdv = byV(0), point.dtdv = byV(1);
}

void evaluateTexture(const SurfaceSet &set, const Hit &hit, bool derivatives, SurfacePoint &point) {
  if (set.hasUnitParameters()) {
    cornerTexture(set.owner(hit.primitive).appearance->textureCoordinates, point);
  } else { // a polygon's are its u and v
    point.s = point.frame.u, point.t = point.frame.v;
    point.dsdu = point.dtdv = 1;
    point.dsdv = point.dtdu = 0;
  }
  const SurfaceVariables &variables = set.variables(hit.primitive);
  auto replace = [&](int index, uint32_t component, double &value, double &byU, double &byV) {
    if (index < 0)
      return;
    const Variable &variable = variables.list[size_t(index)];
    float values[2];
    set.interpolate(variable, hit, point, values);
    value = values[component];
    if (derivatives)
      set.differentiate(variable, component, hit, point, byU, byV);
  };
  replace(variables.st, 0, point.s, point.dsdu, point.dsdv);
  replace(variables.st, 1, point.t, point.dtdu, point.dtdv);
  replace(variables.s, 0, point.s, point.dsdu, point.dsdv);
  replace(variables.t, 0, point.t, point.dtdu, point.dtdv);
}

} // namespace

void anysl::render::evaluateSurface(const SurfaceSet &set, const Hit &hit, Vec3f origin,
                                    Vec3f direction, uint64_t needed, SurfacePoint &point) {
  constexpr auto bits = [](auto... globals) { return ((uint64_t(1) << globals) | ...); };
  const Appearance &appearance = *set.owner(hit.primitive).appearance;
  const SurfaceVariables &variables = set.variables(hit.primitive);
  point.color = appearance.color;
  point.opacity = appearance.opacity;
  SurfaceNeeds needs;
  needs.texture = (needed & bits(ANYSL_s, ANYSL_t)) != 0;
  needs.derivatives = (needed & derivativesBit) != 0;
  needs.parametric = needs.texture || needs.derivatives || !variables.list.empty() ||
                     (needed & bits(ANYSL_u, ANYSL_v, ANYSL_dPdu, ANYSL_dPdv)) != 0;
  set.evaluate(hit, origin, direction, needs, point);
  normalize(point.frame.normal, point.dNgdu, point.dNgdv);
  normalize(point.normal, point.dNdu, point.dNdv);
  if (needs.texture || needs.derivatives)
    evaluateTexture(set, hit, needs.derivatives, point);
  auto replace = [&](int index, Vec3d &value, Vec3d &byU, Vec3d &byV) {
    if (index < 0)
      return;
    const Variable &variable = variables.list[size_t(index)];
    value = triple(set, variable, hit, point);
    for (uint32_t k = 0; needs.derivatives && k < 3; ++k)
      set.differentiate(variable, k, hit, point, byU[int(k)], byV[int(k)]);
  };
  replace(variables.color, point.color, point.dCsdu, point.dCsdv);
  replace(variables.opacity, point.opacity, point.dOsdu, point.dOsdv);
  // P is rounded by half an ulp of each of its coordinates, and Embree computes with the corners of
  // a triangle relative to the ray's origin. 32 ulps leave room for the rounding of the ray's
  // start.
  double magnitude = std::max({double(point.offset), maxAbs(point.frame.P), 1e-30});
  point.offset = float(magnitude * 0x1p-18);
}
