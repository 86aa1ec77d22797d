//===-- tools/anysl-render/ScalarHost.cpp - one ray, one point at a time ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A plain recursive ray tracer. A point is one structure of numbers; a shader's trace() is a call
// of the same function that shades camera rays, one level deeper.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Host.h"

using namespace anysl::render;

namespace {

/// What AnyslShadeArgs::batch points to.
struct PointBatch {
  const class ScalarHost *host;
  ThreadState *state;
  const ShadingGroup *group;
  RayStarts starts;
  unsigned depth;
  uint32_t seed;
  uint32_t rays = 0; ///< how many the shader has traced from this point
};

class ScalarHost : public Host {
public:
  ScalarHost(const SceneDescription &description, const ShaderCache &cache, Warnings &warnings)
      : theScene(description, cache, services, ANYSL_LAYOUT_AOS, 1, warnings) {}

  void trace(ThreadState &state, const Ray *rays, uint32_t count,
             Radiance *radiance) const override {
    for (uint32_t i = 0; i < count; ++i)
      radiance[i] = follow(state, rays[i], CameraRays, 0);
    state.counts.cameraRays += count;
  }
  uint32_t preferredCount() const override { return 1; }
  const Scene &scene() const override { return theScene; }

private:
  Radiance follow(ThreadState &state, Ray ray, unsigned mask, unsigned depth) const;
  Vec3f transmission(ThreadState &state, const Ray &ray) const;
  template <typename Real>
  void shade(PointBatch &batch, const SurfacePoint &point, Vec3f rayOrigin, Vec3f &Ci,
             Vec3f &Oi) const;

  static void serveTrace(void *, const AnyslShadeArgs *, uint32_t, const double *, const double *,
                         double *);
  static double serveDistance(void *, const AnyslShadeArgs *, uint32_t, const double *,
                              const double *);
  static void serveTransmission(void *, const AnyslShadeArgs *, uint32_t, const double *,
                                const double *, double *);
  static int serveMatrix(void *renderer, const AnyslShadeArgs *args, const char *from,
                         const char *to, double *matrix) {
    const auto *batch = static_cast<const PointBatch *>(args->batch);
    return serveSpaceMatrix(renderer, batch ? &batch->group->object : nullptr, from, to, matrix);
  }
  static const AnyslServices services;

  Scene theScene;
};

const AnyslServices ScalarHost::services = {
    sizeof(AnyslServices), serveTrace, nullptr,    serveDistance, nullptr,
    serveTransmission,     nullptr,    serveMatrix};

/// Three numbers of a shader's, as the shared code takes the vectors of one point.
struct Triple {
  explicit Triple(const double *v) : value{float(v[0]), float(v[1]), float(v[2])} {}
  float value[3];
};

Radiance ScalarHost::follow(ThreadState &state, Ray ray, unsigned mask, unsigned depth) const {
  const Geometry &geometry = theScene.geometry();
  Radiance radiance;
  Vec3f passing(1);
  for (unsigned layer = 0; layer < maxLayers; ++layer) {
    Hit hit = geometry.intersect(ray, mask);
    if (!hit.isHit()) {
      radiance.color += passing * theScene.background.color(ray.direction);
      break;
    }
    const ShadingGroup &group = theScene.group(geometry.groupOf(hit));
    SurfacePoint point;
    geometry.evaluate(hit, ray.origin, ray.direction, group.shader ? group.shader->needed : 0,
                      point);
    Arena::Scope scope(state.arena);
    PointBatch batch{this, &state, &group, RayStarts(state.arena, 1), depth, ray.seed};
    batch.starts.set(0, point);
    Vec3f Ci, Oi;
    if (!group.shader) {
      Ci = defaultSurface(point, ray.direction);
      Oi = Vec3f(point.opacity);
    } else if (theScene.real() == ANYSL_REAL_DOUBLE) {
      shade<double>(batch, point, ray.origin, Ci, Oi);
    } else {
      shade<float>(batch, point, ray.origin, Ci, Oi);
    }
    radiance.color += passing * Ci;
    passing *= Vec3f(1) - Oi;
    if (!(maxAbs(passing) > 0x1p-12f)) {
      passing = Vec3f();
      break;
    }
    ray = batch.starts.behind(0, ray.direction, ray.seed);
  }
  radiance.alpha = 1 - (passing.x + passing.y + passing.z) / 3;
  return radiance;
}

template <typename Real>
void ScalarHost::shade(PointBatch &batch, const SurfacePoint &point, Vec3f rayOrigin, Vec3f &Ci,
                       Vec3f &Oi) const {
  const Shader &shader = *batch.group->shader;
  Arena::Scope scope(batch.state->arena);
  // The interface promises room for 16 points; only the first is ever written.
  Real *globals = batch.state->arena.allocate<Real>(16 * ANYSL_COMPONENT_COUNT);
  constexpr uint64_t outputs = uint64_t(1) << ANYSL_Ci | uint64_t(1) << ANYSL_Oi;
  auto store = [globals](int component, double value) { globals[component] = Real(value); };
  storeGlobals(shader.globals | outputs, point, rayOrigin, store);
  storeUniformGlobals(shader.globals, theScene, store);

  AnyslShadeArgs args = makeShadeArgs(*batch.group, 1, &batch);
  void *const arrays[1] = {globals};
  args.globals = arrays;
  args.seeds = &batch.seed;
  ++batch.state->counts.points;
  ++batch.state->counts.batches;
  batch.state->startShading();
  shader.shade(&args, 0, 1);
  batch.state->stopShading();
  for (int k = 0; k < 3; ++k) {
    Ci[k] = float(globals[ANYSL_COMPONENT_Ci + k]);
    Oi[k] = float(globals[ANYSL_COMPONENT_Oi + k]);
  }
}

Vec3f ScalarHost::transmission(ThreadState &state, const Ray &ray) const {
  const Geometry &geometry = theScene.geometry();
  RTCRay query = {ray.origin.x,
                  ray.origin.y,
                  ray.origin.z,
                  ray.near,
                  ray.direction.x,
                  ray.direction.y,
                  ray.direction.z,
                  0,
                  ray.far,
                  OpaqueShadowRays,
                  0,
                  0};
  ++state.counts.shadowRays;
  geometry.occluded<1>(nullptr, query);
  if (query.tfar < 0)
    return Vec3f();
  Vec3f passing(1);
  Ray rest = ray;
  for (unsigned layer = 0; geometry.hasPartialShadows() && layer < maxLayers; ++layer) {
    Hit hit = geometry.intersect(rest, PartialShadowRays);
    if (!hit.isHit())
      break;
    passing *= Vec3f(Vec3d(1) - geometry.opacityAt(hit, rest.origin, rest.direction));
    rest.near = afterHit(hit.t);
  }
  return passing;
}

//===-- Services ------------------------------------------------------------//

void ScalarHost::serveTrace(void *, const AnyslShadeArgs *args, uint32_t, const double *P,
                            const double *R, double *color) {
  auto &batch = *static_cast<PointBatch *>(args->batch);
  ServiceScope scope(*batch.state);
  Vec3f result;
  uint32_t seed = hash(batch.seed, ++batch.rays);
  AskedRays asked;
  makeTraceRays(batch.starts, 0, 1, Triple(P).value, Triple(R).value, asked);
  if (batch.depth < batch.host->theScene.description.maxDepth && asked.valid[0]) {
    ++batch.state->counts.traceRays;
    result = batch.host->follow(*batch.state, asked.ray(0, seed), TraceRays, batch.depth + 1).color;
  }
  for (int k = 0; k < 3; ++k)
    color[k] = result[k];
}

double ScalarHost::serveDistance(void *, const AnyslShadeArgs *args, uint32_t, const double *P,
                                 const double *R) {
  auto &batch = *static_cast<PointBatch *>(args->batch);
  ServiceScope scope(*batch.state);
  AskedRays asked;
  makeTraceRays(batch.starts, 0, 1, Triple(P).value, Triple(R).value, asked);
  if (!asked.valid[0])
    return 1e30;
  ++batch.state->counts.traceRays;
  return batch.host->theScene.geometry().intersect(asked.ray(0, 0), TraceRays).t;
}

void ScalarHost::serveTransmission(void *, const AnyslShadeArgs *args, uint32_t, const double *from,
                                   const double *to, double *color) {
  auto &batch = *static_cast<PointBatch *>(args->batch);
  ServiceScope scope(*batch.state);
  Vec3f result(1);
  AskedRays asked;
  makeShadowRays(batch.starts, 0, 1, Triple(from).value, Triple(to).value, asked);
  if (asked.valid[0])
    result = batch.host->transmission(*batch.state, asked.ray(0, 0));
  for (int k = 0; k < 3; ++k)
    color[k] = result[k];
}

} // namespace

std::unique_ptr<Host> anysl::render::makeScalarHost(const SceneDescription &description,
                                                    const ShaderCache &cache, Warnings &warnings) {
  return std::make_unique<ScalarHost>(description, cache, warnings);
}
