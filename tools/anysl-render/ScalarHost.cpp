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

#include "tools/anysl-render/HostServices.h"
#include "tools/anysl-render/ParameterArrays.h"

#include <algorithm>
#include <optional>

namespace stc = anysl::stc;
using namespace anysl::render;

namespace {

/// What AnyslShadeArgs::batch points to.
struct PointBatch {
  const class ScalarHost *host;
  ThreadState *state;
  const ShadingGroup *group;
  RayStarts starts;
  RayPath path;
  uint32_t seed;
  uint32_t rays = 0;              ///< how many the shader has traced from this point
  const Shader *volume = nullptr; ///< that the ray came through, or null
  const Hit *hit = nullptr;
  const AnyslShadeArgs *surface = nullptr; ///< while a volume is shaded, what the surface was with

  Asker asker(uint32_t) const { return {group, volume, surface, path, *hit}; }
};

/// What shaders make of a point.
struct PointColors {
  Vec3f passing; ///< how much of it arrives
  bool nearest;  ///< nothing before it counts
  Vec3f Ci, Oi;
};

class ScalarHost : public Host {
public:
  ScalarHost(const SceneDescription &description, const ShaderCache &cache, Warnings &warnings)
      : theScene(description, cache, services, ANYSL_LAYOUT_AOS, 1, warnings) {}

  void trace(ThreadState &state, const Ray *rays, uint32_t count, Radiance *radiance,
             float *channels) const override {
    const unsigned size = theScene.channels().size();
    for (uint32_t i = 0; i < count; ++i)
      radiance[i] = follow(state, rays[i], RayPurpose(), size > 0 ? channels + i * size : nullptr);
    state.counts.cameraRays += count;
  }
  uint32_t preferredCount() const override { return 1; }
  const Scene &scene() const override { return theScene; }

private:
  /// `values`: what else is asked of the first surface.
  Radiance follow(ThreadState &state, Ray ray, const RayPurpose &purpose, float *channels,
                  AnyslMessage *values = nullptr) const;
  /// How much light arrives along a ray that a point asks for. Where a shader is asked how opaque a
  /// surface is, those behind that shader's own shadow rays are as they are anyhow.
  Vec3f transmission(const PointBatch &from, const Ray &ray, RayPurpose purpose) const;
  /// Shades what a ray has met, and gives what rays start from there. The memory for that is of the
  /// caller's scope.
  RayStarts shade(ThreadState &state, const Hit &hit, const Ray &ray, const RayPath &path,
                  PointColors &colors, float *channels, AnyslMessage *values) const;
  template <typename Real>
  void shade(PointBatch &batch, const Hit &hit, const SurfacePoint &point, const Ray &ray,
             const Shader *volume, PointColors &colors, float *channels,
             AnyslMessage *values) const;
  template <typename Real>
  AnyslShadeArgs run(const Shader &shader, const ShadingGroup &group, PointBatch &batch,
                     Real *globals, const ParameterArrays<Real> *values) const;

  static void serveTrace(void *, const AnyslShadeArgs *, uint32_t, const double *, const double *,
                         double *);
  /// What arrives along a ray that a shader asks for; `change` may be null.
  static Vec3f traceAsked(PointBatch &batch, const float *P, const float *R,
                          const AnyslRayDerivatives *change);
  static void serveTraceDerivatives(void *, const AnyslShadeArgs *, uint32_t, uint32_t, uint32_t,
                                    const float *const *, const float *const *,
                                    const AnyslRayDerivatives *, float *const *);
  static double serveDistance(void *, const AnyslShadeArgs *, uint32_t, const double *,
                              const double *);
  static void serveTransmission(void *, const AnyslShadeArgs *, uint32_t, const double *,
                                const double *, double *);
  static void serveHits(void *, const AnyslShadeArgs *, uint32_t, uint32_t, uint32_t,
                        const float *const *, const float *const *, const float *,
                        const AnyslHits *);
  static const AnyslServices services;

  Scene theScene;
};

const AnyslServices ScalarHost::services = [] {
  AnyslServices offered = servicesOfBatch<PointBatch>();
  offered.trace = serveTrace;
  offered.trace_distance = serveDistance;
  offered.transmission = serveTransmission;
  offered.trace_hit = serveHits;
  offered.trace_derivatives = serveTraceDerivatives;
  return offered;
}();

/// Three numbers of a shader's, as the shared code takes the vectors of one point.
struct Triple {
  explicit Triple(const double *v) : value{float(v[0]), float(v[1]), float(v[2])} {}
  float value[3];
};

Radiance ScalarHost::follow(ThreadState &state, Ray ray, const RayPurpose &purpose, float *channels,
                            AnyslMessage *values) const {
  const Geometry &geometry = theScene.geometry();
  Radiance radiance;
  PointColors colors{Vec3f(1), true, {}, {}};
  for (unsigned layer = 0; layer < purpose.layers; ++layer) {
    Hit hit = nearestHit(theScene, ray, purpose);
    if (!hit.isHit()) {
      radiance.color += colors.passing * theScene.background.color(ray.direction);
      break;
    }
    const ShadingGroup &group = theScene.group(geometry.groupOf(hit));
    Arena::Scope scope(state.arena);
    RayStarts starts = shade(state, hit, ray, purpose.path, colors, channels, values);
    bool seen = !group.matte || purpose.path.depth > 0;
    if (seen)
      radiance.color += colors.passing * colors.Ci;
    Vec3f before = colors.passing;
    colors.passing *= Vec3f(1) - colors.Oi;
    colors.nearest &= maxAbs(colors.Oi) == 0;
    if (!(maxAbs(colors.passing) > 0x1p-12f))
      colors.passing = Vec3f();
    if (seen)
      radiance.opacity += before - colors.passing;
    if (colors.passing == Vec3f())
      break;
    ray = starts.behind(0, ray, hit.t, group);
  }
  radiance.alpha = (radiance.opacity.x + radiance.opacity.y + radiance.opacity.z) / 3;
  return radiance;
}

RayStarts ScalarHost::shade(ThreadState &state, const Hit &hit, const Ray &ray, const RayPath &path,
                            PointColors &colors, float *channels, AnyslMessage *values) const {
  const Geometry &geometry = theScene.geometry();
  const ShadingGroup &group = theScene.group(geometry.groupOf(hit));
  const Shader *shader = group.shaderFor(path.kind), *volume = nullptr;
  if (path.kind != RayKind::Shadow)
    volume = ray.medium ? ray.medium : group.atmosphere;
  uint64_t needed = group.globalsOfOthers() | (shader ? shader->needed : 0) |
                    (volume ? volume->needed : 0) | (channels ? theScene.channels().globals() : 0);
  SurfacePoint point;
  geometry.evaluate(hit, ray.origin, ray.direction, needed, point);
  if (needed & footprintBits)
    findFootprint(theScene.camera, path.depth == 0, ray, point);
  if (state.again)
    computeAgain(state, theScene, hit, ray, path, *state.again & needed);
  PointBatch batch{this, &state, &group, RayStarts(state.arena, 1), path, ray.seed};
  batch.starts.set(0, point);
  batch.volume = volume;
  batch.hit = &hit;
  if (theScene.real() == ANYSL_REAL_DOUBLE)
    shade<double>(batch, hit, point, ray, volume, colors, channels, values);
  else
    shade<float>(batch, hit, point, ray, volume, colors, channels, values);
  return batch.starts;
}

template <typename Real>
void ScalarHost::shade(PointBatch &batch, const Hit &hit, const SurfacePoint &point, const Ray &ray,
                       const Shader *volume, PointColors &colors, float *channels,
                       AnyslMessage *asked) const {
  const Shader *shader = batch.group->shaderFor(batch.path.kind);
  Arena &arena = batch.state->arena;
  Arena::Scope scope(arena);
  // The interface promises room for 16 points; only the first is ever written.
  Real *globals = arena.allocate<Real>(16 * ANYSL_COMPONENT_COUNT);
  auto store = [globals](int component, double value) { globals[component] = Real(value); };
  uint64_t lit = batch.group->globalsOfOthers();
  uint64_t wanted = colorOutputs | lit | (shader ? shader->globals : 0) |
                    (channels ? theScene.channels().globals() : 0);
  storeGlobals(wanted, point, ray, ray.travelled, store);
  std::optional<ParameterArrays<Real>> values;
  AnyslShadeArgs surface = {};
  if (shader) {
    storeUniformGlobals(wanted, theScene, store);
    values.emplace(arena, *shader, batch.group->bound, channels != nullptr,
                   (volume && volume->asksFor(stc::Service::Queries)) || asked, ANYSL_LAYOUT_AOS,
                   16);
    if (!batch.group->bound.empty())
      values->set(0, theScene.bindingsOf(theScene.geometry().shapeOf(hit)),
                  theScene.geometry().variablesAt(hit, point));
    surface = run(*shader, *batch.group, batch, globals, &*values);
  } else {
    Vec3f Ci = defaultSurface(point, ray.direction);
    for (int k = 0; k < 3; ++k)
      globals[ANYSL_COMPONENT_Ci + k] = Ci[k];
  }
  if (asked)
    answerValues(*asked, {&theScene, hit, ray, shader ? &surface : nullptr});
  auto color = [](const Real *from, int component) {
    return Vec3f(float(from[component]), float(from[component + 1]), float(from[component + 2]));
  };
  colors.Oi = color(globals, ANYSL_COMPONENT_Oi);
  if (channels)
    storeChannels(
        theScene.channels(), shader, point.frame.P.z, colors.passing,
        colors.nearest && maxAbs(colors.Oi) > 0, channels,
        [&](int component) { return float(globals[component]); },
        [&](size_t i, unsigned k) { return float(values->output(shader->outputs[i], k, 0)); });
  if (volume) {
    Real *inVolume = arena.allocate<Real>(16 * ANYSL_COMPONENT_COUNT);
    auto storeVolume = [inVolume](int component, double value) {
      inVolume[component] = Real(value);
    };
    storeGlobals((volume->globals | lit) & ~colorOutputs, point, ray, 0, storeVolume);
    storeUniformGlobals(volume->globals | lit, theScene, storeVolume);
    std::copy_n(globals + ANYSL_COMPONENT_Ci, 3, inVolume + ANYSL_COMPONENT_Ci);
    std::copy_n(globals + ANYSL_COMPONENT_Oi, 3, inVolume + ANYSL_COMPONENT_Oi);
    batch.seed = hash(batch.seed, throughVolume);
    batch.surface = shader ? &surface : nullptr;
    run<Real>(*volume, *batch.group, batch, inVolume, nullptr);
    globals = inVolume;
  }
  colors.Ci = color(globals, ANYSL_COMPONENT_Ci);
  colors.Oi = color(globals, ANYSL_COMPONENT_Oi);
}

template <typename Real>
AnyslShadeArgs ScalarHost::run(const Shader &shader, const ShadingGroup &group, PointBatch &batch,
                               Real *globals, const ParameterArrays<Real> *values) const {
  AnyslShadeArgs args = makeShadeArgs(shader, group, 1, &batch);
  void *const arrays[1] = {globals};
  args.globals = arrays;
  args.seeds = &batch.seed;
  if (values)
    values->fill(args);
  ++batch.state->counts.points;
  batch.state->counts.shadowPoints += batch.path.kind == RayKind::Shadow;
  ++batch.state->counts.batches;
  batch.state->record(shader, group, args);
  LightScope lights(args, *group.lights);
  batch.state->startShading();
  shader.shade(&args, 0, 1);
  batch.state->stopShading();
  args.globals = nullptr; // gone with this call
  return args;
}

Vec3f ScalarHost::transmission(const PointBatch &from, const Ray &ray, RayPurpose purpose) const {
  ThreadState &state = *from.state;
  const Geometry &geometry = theScene.geometry();
  purpose.mask = OpaqueShadowRays;
  RTCRay query = {ray.origin.x,
                  ray.origin.y,
                  ray.origin.z,
                  ray.near,
                  ray.direction.x,
                  ray.direction.y,
                  ray.direction.z,
                  0,
                  ray.far,
                  purpose.mask,
                  0,
                  0};
  ++state.counts.shadowRays;
  if (!purpose.chooses())
    geometry.occluded<1>(nullptr, query);
  else if (nearestHit(theScene, ray, purpose).isHit())
    return Vec3f();
  if (query.tfar < 0)
    return Vec3f();
  purpose.mask = PartialShadowRays;
  Vec3f passing(1);
  Ray rest = ray;
  for (unsigned layer = 0; geometry.hasPartialShadows() && layer < maxLayers; ++layer) {
    Hit hit = nearestHit(theScene, rest, purpose);
    if (!hit.isHit())
      break;
    const ShadingGroup &group = theScene.group(geometry.groupOf(hit));
    if (group.shadow && from.path.kind != RayKind::Shadow) {
      Arena::Scope scope(state.arena);
      PointColors colors{Vec3f(1), true, {}, {}};
      shade(state, hit, rest, purpose.path, colors, nullptr, nullptr);
      passing *= passedBy(colors.Oi);
    } else {
      passing *= passedAt(geometry, group, hit, rest.origin, rest.direction);
    }
    rest.near = afterHit(hit.t);
    rest.seed = hash(rest.seed, behindSurface);
  }
  return passing;
}

//===-- Services ------------------------------------------------------------//

Vec3f ScalarHost::traceAsked(PointBatch &batch, const float *P, const float *R,
                             const AnyslRayDerivatives *change) {
  ServiceScope scope(*batch.state);
  uint32_t seed = hash(batch.seed, ++batch.rays);
  AskedRays asked;
  makeTraceRays(batch.starts, 0, 1, P, R, asked);
  RayPurpose purpose = tracedFrom(batch.path, RayKind::Traced);
  if (!isWithinDepth(batch.host->theScene, *batch.group, purpose.path) || !asked.valid[0])
    return Vec3f();
  ++batch.state->counts.traceRays;
  Ray ray = asked.ray(0, seed);
  ray.medium = batch.starts.medium(0, ray.direction, *batch.group);
  RaySpread spread;
  const float *const along[3] = {R, R + 1, R + 2};
  if (change && spreadRay(batch.starts, 0, asked, 0, along, *change, spread))
    ray.spread = &spread;
  return batch.host->follow(*batch.state, ray, purpose, nullptr).color;
}

void ScalarHost::serveTrace(void *, const AnyslShadeArgs *args, uint32_t, const double *P,
                            const double *R, double *color) {
  auto &batch = *static_cast<PointBatch *>(args->batch);
  Vec3f result = traceAsked(batch, Triple(P).value, Triple(R).value, nullptr);
  for (int k = 0; k < 3; ++k)
    color[k] = double(result[k]);
}

void ScalarHost::serveTraceDerivatives(void *, const AnyslShadeArgs *args, uint32_t, uint32_t,
                                       uint32_t, const float *const *P, const float *const *R,
                                       const AnyslRayDerivatives *change, float *const color[3]) {
  auto &batch = *static_cast<PointBatch *>(args->batch);
  const float from[3] = {*P[0], *P[1], *P[2]}, along[3] = {*R[0], *R[1], *R[2]};
  Vec3f result = traceAsked(batch, from, along, change);
  for (int k = 0; k < 3; ++k)
    *color[k] = result[k];
}

void ScalarHost::serveHits(void *, const AnyslShadeArgs *args, uint32_t, uint32_t, uint32_t,
                           const float *const *P, const float *const *R, const float *reach,
                           const AnyslHits *hits) {
  auto &batch = *static_cast<PointBatch *>(args->batch);
  const Scene &scene = batch.host->theScene;
  ServiceScope scope(*batch.state);
  RayPurpose purpose = askedFrom(batch.path, *hits);
  bool isShadow = purpose.path.kind == RayKind::Shadow;
  uint32_t seed = hash(batch.seed, isShadow ? towardsLight : ++batch.rays);
  const float from[3] = {*P[0], *P[1], *P[2]}, along[3] = {*R[0], *R[1], *R[2]};
  AskedRays asked;
  makeAskedRays(batch.starts, 0, 1, from, along, reach, isShadow, asked);
  if (!asked.valid[0])
    return;
  Ray ray = asked.ray(0, seed);
  if (isShadow)
    return storeOpacity(Vec3f(1) - batch.host->transmission(batch, ray, purpose), 0, *hits);
  bool isWithin = isWithinDepth(scene, *batch.group, purpose.path);
  if (!isWithin && endsAtDepth(purpose, *hits))
    return storeOpacity(Vec3f(1), 0, *hits);
  ++batch.state->counts.traceRays;
  ray.medium = batch.starts.medium(0, ray.direction, *batch.group);
  RaySpread spread;
  if (hits->change && spreadRay(batch.starts, 0, asked, 0, R, *hits->change, spread))
    ray.spread = &spread;
  Hit hit = nearestHit(scene, ray, purpose);
  Radiance radiance{Vec3f(), Vec3f(1), 1};
  // Beyond the deepest level surfaces are black.
  if (hits->shades && isWithin)
    radiance = batch.host->follow(*batch.state, ray, purpose, nullptr, hits->values);
  else if (hits->values)
    answerValues(*hits->values, {&scene, hit, ray});
  storeHit(scene.geometry(), hit, ray, radiance, 0, *hits);
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
  return batch.host->theScene.geometry().intersect(asked.ray(0, 0), SpecularRays).t;
}

void ScalarHost::serveTransmission(void *, const AnyslShadeArgs *args, uint32_t, const double *from,
                                   const double *to, double *color) {
  auto &batch = *static_cast<PointBatch *>(args->batch);
  ServiceScope scope(*batch.state);
  Vec3f result(1);
  AskedRays asked;
  makeShadowRays(batch.starts, 0, 1, Triple(from).value, Triple(to).value, asked);
  if (asked.valid[0])
    result = batch.host->transmission(batch, asked.ray(0, hash(batch.seed, towardsLight)),
                                      tracedFrom(batch.path, RayKind::Shadow));
  for (int k = 0; k < 3; ++k)
    color[k] = result[k];
}

} // namespace

std::unique_ptr<Host> anysl::render::makeScalarHost(const SceneDescription &description,
                                                    const ShaderCache &cache, Warnings &warnings) {
  return std::make_unique<ScalarHost>(description, cache, warnings);
}
