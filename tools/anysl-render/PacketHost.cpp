//===-- tools/anysl-render/PacketHost.cpp - packets of rays, batches of points ----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Rays are followed many at a time. A list of rays goes through Embree in packets of W; the hits
// are sorted by shading group, and each group's points are laid out as structure of arrays and
// shaded by one call of the shader's W-wide code. Where that code traces, the rays of W points come
// back here as a new, shorter list one level deeper: the same function follows camera rays and all
// others.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Host.h"
#include "tools/anysl-render/ParameterArrays.h"
#include "tools/anysl-render/Pictures.h"
#include "tools/anysl-render/Queries.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

using namespace anysl::render;

namespace {

/// Rays and what they meet, one array for each number.
struct RayList {
  uint32_t count = 0, capacity = 0;
  float *origin[3], *direction[3], *near, *far, *travelled;
  const Shader **medium;
  uint32_t *seed;
  uint32_t *target; ///< where the ray's light goes to: an index into the caller's arrays
  float *t, *u, *v;
  uint32_t *geometry, *primitive;

  RayList(Arena &arena, uint32_t capacity) : capacity(capacity) {
    // Packets are loaded whole, so that the arrays reach beyond the last ray.
    size_t size = (capacity + 15) / 16 * 16;
    for (float **array : {&origin[0], &origin[1], &origin[2], &direction[0], &direction[1],
                          &direction[2], &near, &far, &travelled, &t, &u, &v})
      *array = arena.allocate<float>(size);
    medium = arena.allocate<const Shader *>(size);
    for (uint32_t **array : {&seed, &target, &geometry, &primitive})
      *array = arena.allocate<uint32_t>(size);
  }

  void add(const Ray &ray, uint32_t toTarget) {
    for (int k = 0; k < 3; ++k) {
      origin[k][count] = ray.origin[k];
      direction[k][count] = ray.direction[k];
    }
    near[count] = ray.near;
    far[count] = ray.far;
    travelled[count] = ray.travelled;
    medium[count] = ray.medium;
    seed[count] = ray.seed;
    target[count++] = toTarget;
  }
  Vec3f originOf(uint32_t i) const { return {origin[0][i], origin[1][i], origin[2][i]}; }
  Vec3f directionOf(uint32_t i) const {
    return {direction[0][i], direction[1][i], direction[2][i]};
  }
  Ray rayOf(uint32_t i) const {
    return {originOf(i), directionOf(i), near[i], far[i], seed[i], travelled[i], medium[i]};
  }
  Hit hitOf(uint32_t i) const { return {t[i], u[i], v[i], geometry[i], primitive[i]}; }
};

/// The arrays of a batch's globals, one for each component.
struct GlobalArrays {
  float *component[ANYSL_COMPONENT_COUNT] = {};

  GlobalArrays(Arena &arena, uint64_t wanted, size_t size, const Scene &scene) {
    storeGlobals(wanted, SurfacePoint(), Ray(), 0,
                 [&](int number, double) { component[number] = arena.allocate<float>(size); });
    storeUniformGlobals(wanted, scene, [&](int number, double value) {
      // One value is enough, but code for a whole group of points may read it as if varying.
      component[number] = arena.allocate<float>(16);
      std::fill_n(component[number], 16, float(value));
    });
  }
  void set(uint32_t i, uint64_t wanted, const SurfacePoint &point, const Ray &ray,
           float travelled) {
    storeGlobals(wanted, point, ray, travelled,
                 [&](int number, double value) { component[number][i] = float(value); });
  }
  Vec3f triple(int first, uint32_t i) const {
    return {component[first][i], component[first + 1][i], component[first + 2][i]};
  }
};

/// Rays that met surfaces whose points share a batch.
struct Members {
  const RayList &rays;
  const uint32_t *numbers; ///< of the rays
  uint32_t count;
  const ShadingGroup &group;
  const Shader *volume; ///< that they came through, or null
  unsigned depth;
  float *channels; ///< of all targets, or null
};

/// What becomes of rays: the light so far, and what goes on.
struct Outcome {
  Vec3f *passing;
  bool *covered; ///< whether some surface counts already for what the nearest one gives
  Radiance *radiance;
  RayList *behind;
  AnyslMessage *values; ///< what else the targets ask of the surfaces, or null
};

/// What AnyslShadeArgs::batch points to.
struct PacketBatch {
  const class PacketHostBase *host;
  ThreadState *state;
  const ShadingGroup *group;
  const RayStarts *starts;
  const uint32_t *seeds;
  uint32_t *rays; ///< how many rays each point has traced so far
  unsigned depth;
  const Shader *volume; ///< that the rays came through, or null
  const Members *members;
  const AnyslShadeArgs *surface = nullptr; ///< while a volume is shaded, what the surface was with
};

class PacketHostBase : public Host {
public:
  /// Follows rays through at most `layers` surfaces.
  virtual void follow(ThreadState &state, RayList &rays, unsigned mask, unsigned depth,
                      unsigned layers, Radiance *radiance, float *channels,
                      AnyslMessage *values = nullptr) const = 0;
  virtual void findNearest(RayList &rays, unsigned mask) const = 0;
  /// Sets t to -infinity where a ray is blocked.
  virtual void findBlocked(RayList &rays) const = 0;
  void transmission(ThreadState &state, RayList &rays, Vec3f *passing) const;
};

template <unsigned W>
class PacketHost final : public PacketHostBase {
public:
  PacketHost(const SceneDescription &description, const ShaderCache &cache,
             const AnyslServices &services, Warnings &warnings)
      : theScene(description, cache, services, ANYSL_LAYOUT_SOA, W, warnings) {}

  void trace(ThreadState &state, const Ray *rays, uint32_t count, Radiance *radiance,
             float *channels) const override {
    Arena::Scope scope(state.arena);
    RayList list(state.arena, count);
    for (uint32_t i = 0; i < count; ++i)
      list.add(rays[i], i);
    state.counts.cameraRays += count;
    follow(state, list, CameraRays, 0, maxLayers, radiance,
           theScene.channels().size() > 0 ? channels : nullptr, nullptr);
  }
  // Enough points for full packets after sorting, few enough for their arrays to stay in cache.
  uint32_t preferredCount() const override { return 256; }
  const Scene &scene() const override { return theScene; }

  void follow(ThreadState &state, RayList &rays, unsigned mask, unsigned depth, unsigned layers,
              Radiance *radiance, float *channels, AnyslMessage *values) const override;
  void findNearest(RayList &rays, unsigned mask) const override;
  void findBlocked(RayList &rays) const override;

private:
  void shade(ThreadState &state, const Members &members, const Outcome &outcome) const;
  /// Runs a shader; `values` may be null.
  /// Shades, and gives back what with.
  AnyslShadeArgs run(const Shader &shader, PacketBatch &batch, uint32_t count,
                     const GlobalArrays &globals, const ParameterArrays<float> *values) const;

  Scene theScene;
};

//===-- Packets -------------------------------------------------------------//

template <unsigned W>
void PacketHost<W>::findNearest(RayList &rays, unsigned mask) const {
  const Geometry &geometry = theScene.geometry();
  for (uint32_t first = 0; first < rays.count; first += W) {
    uint32_t count = std::min(W, rays.count - first);
    if (W == 1 || count == 1) {
      RTCRayHit query;
      Vec3f o = rays.originOf(first), d = rays.directionOf(first);
      query.ray = {o.x, o.y, o.z, rays.near[first], d.x, d.y, d.z, 0, rays.far[first], mask, 0, 0};
      query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      geometry.intersect<1>(nullptr, query);
      rays.t[first] = query.ray.tfar;
      rays.u[first] = query.hit.u;
      rays.v[first] = query.hit.v;
      rays.geometry[first] = query.hit.geomID;
      rays.primitive[first] = query.hit.primID;
      continue;
    }
    if constexpr (W > 1) {
      typename RayPacketType<W>::RayHit query;
      alignas(64) int valid[W];
      constexpr size_t bytes = W * sizeof(float);
      float *const origin[] = {query.ray.org_x, query.ray.org_y, query.ray.org_z};
      float *const direction[] = {query.ray.dir_x, query.ray.dir_y, query.ray.dir_z};
      for (int k = 0; k < 3; ++k) {
        std::memcpy(origin[k], rays.origin[k] + first, bytes);
        std::memcpy(direction[k], rays.direction[k] + first, bytes);
      }
      std::memcpy(query.ray.tnear, rays.near + first, bytes);
      std::memcpy(query.ray.tfar, rays.far + first, bytes);
      for (uint32_t i = 0; i < W; ++i) {
        valid[i] = i < count ? -1 : 0;
        query.ray.mask[i] = mask;
        query.ray.time[i] = 0;
        query.ray.id[i] = query.ray.flags[i] = 0;
        query.hit.geomID[i] = query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
      }
      geometry.intersect<W>(valid, query);
      std::memcpy(rays.t + first, query.ray.tfar, bytes);
      std::memcpy(rays.u + first, query.hit.u, bytes);
      std::memcpy(rays.v + first, query.hit.v, bytes);
      std::memcpy(rays.geometry + first, query.hit.geomID, bytes);
      std::memcpy(rays.primitive + first, query.hit.primID, bytes);
    }
  }
}

template <unsigned W>
void PacketHost<W>::findBlocked(RayList &rays) const {
  const Geometry &geometry = theScene.geometry();
  for (uint32_t first = 0; first < rays.count; first += W) {
    uint32_t count = std::min(W, rays.count - first);
    if (W == 1 || count == 1) {
      Vec3f o = rays.originOf(first), d = rays.directionOf(first);
      RTCRay query = {o.x, o.y, o.z, rays.near[first], d.x,
                      d.y, d.z, 0,   rays.far[first],  OpaqueShadowRays,
                      0,   0};
      geometry.occluded<1>(nullptr, query);
      rays.t[first] = query.tfar;
      continue;
    }
    if constexpr (W > 1) {
      typename RayPacketType<W>::Ray query;
      alignas(64) int valid[W];
      constexpr size_t bytes = W * sizeof(float);
      float *const origin[] = {query.org_x, query.org_y, query.org_z};
      float *const direction[] = {query.dir_x, query.dir_y, query.dir_z};
      for (int k = 0; k < 3; ++k) {
        std::memcpy(origin[k], rays.origin[k] + first, bytes);
        std::memcpy(direction[k], rays.direction[k] + first, bytes);
      }
      std::memcpy(query.tnear, rays.near + first, bytes);
      std::memcpy(query.tfar, rays.far + first, bytes);
      for (uint32_t i = 0; i < W; ++i) {
        valid[i] = i < count ? -1 : 0;
        query.mask[i] = OpaqueShadowRays;
        query.time[i] = 0;
        query.id[i] = query.flags[i] = 0;
      }
      geometry.occluded<W>(valid, query);
      std::memcpy(rays.t + first, query.tfar, bytes);
    }
  }
}

//===-- Following rays ------------------------------------------------------//

template <unsigned W>
void PacketHost<W>::follow(ThreadState &state, RayList &rays, unsigned mask, unsigned depth,
                           unsigned layers, Radiance *radiance, float *channels,
                           AnyslMessage *values) const {
  const Geometry &geometry = theScene.geometry();
  uint32_t targets = 0;
  for (uint32_t i = 0; i < rays.count; ++i) {
    radiance[rays.target[i]] = Radiance();
    targets = std::max(targets, rays.target[i] + 1);
  }
  Vec3f *passing = state.arena.allocate<Vec3f>(targets);
  std::fill_n(passing, targets, Vec3f(1));
  bool *covered = state.arena.allocate<bool>(targets);
  std::fill_n(covered, targets, false);

  // Each round takes the rays to the next surface; those that it lets through make the next round.
  RayList *current = &rays;
  RayList others[2] = {RayList(state.arena, 0), RayList(state.arena, 0)};
  for (unsigned layer = 0; current->count > 0 && layer < layers; ++layer) {
    RayList &list = *current;
    findNearest(list, mask);
    RayList &behind = others[layer % 2];
    behind = RayList(state.arena, list.count);

    // Sort the hits by group and medium, keeping the order of the rays within each.
    Outcome outcome{passing, covered, radiance, &behind, values};
    uint32_t *group = state.arena.allocate<uint32_t>(list.count);
    uint32_t *members = state.arena.allocate<uint32_t>(list.count);
    constexpr uint32_t done = ~uint32_t(0);
    for (uint32_t i = 0; i < list.count; ++i) {
      Hit hit = list.hitOf(i);
      group[i] = hit.isHit() ? geometry.groupOf(hit) : done;
      if (hit.isHit())
        continue;
      uint32_t target = list.target[i];
      radiance[target].color += passing[target] * theScene.background.color(list.directionOf(i));
    }
    for (uint32_t i = 0; i < list.count; ++i) {
      if (group[i] == done)
        continue;
      uint32_t wanted = group[i], count = 0;
      const Shader *medium = list.medium[i];
      for (uint32_t j = i; j < list.count; ++j)
        if (group[j] == wanted && list.medium[j] == medium) {
          members[count++] = j;
          group[j] = done;
        }
      const ShadingGroup &itsGroup = theScene.group(wanted);
      shade(
          state,
          {list, members, count, itsGroup, medium ? medium : itsGroup.atmosphere, depth, channels},
          outcome);
    }
    current = &behind;
  }
  for (uint32_t i = 0; i < rays.count; ++i) {
    Radiance &result = radiance[rays.target[i]];
    result.alpha = (result.opacity.x + result.opacity.y + result.opacity.z) / 3;
  }
}

template <unsigned W>
void PacketHost<W>::shade(ThreadState &state, const Members &members,
                          const Outcome &outcome) const {
  const Geometry &geometry = theScene.geometry();
  const Channels &channels = theScene.channels();
  const RayList &rays = members.rays;
  const Shader *shader = members.group.shader, *volume = members.volume;
  const uint32_t count = members.count;
  Arena::Scope scope(state.arena);
  size_t size = (size_t(count) + 15) / 16 * 16;
  RayStarts starts(state.arena, size);
  uint64_t channelGlobals = members.channels ? channels.globals() : 0;
  uint64_t lit = members.group.globalsOfOthers();
  uint64_t wanted = colorOutputs | (shader ? shader->globals : 0) | channelGlobals | lit;
  uint64_t inVolume = volume ? (volume->globals | lit) & ~colorOutputs : 0;
  uint64_t needed =
      (shader ? shader->needed : 0) | (volume ? volume->needed : 0) | channelGlobals | lit;
  GlobalArrays globals(state.arena, wanted, size, theScene);
  GlobalArrays volumeGlobals(state.arena, inVolume, size, theScene);

  std::optional<ParameterArrays<float>> values;
  if (shader)
    values.emplace(state.arena, *shader, members.group.bound, members.channels != nullptr,
                   (volume && volume->asksByName()) || outcome.values, ANYSL_LAYOUT_SOA, size);

  float *depths = state.arena.allocate<float>(size);
  for (uint32_t i = 0; i < count; ++i) {
    Ray ray = rays.rayOf(members.numbers[i]);
    SurfacePoint point;
    Hit hit = rays.hitOf(members.numbers[i]);
    geometry.evaluate(hit, ray.origin, ray.direction, needed, point);
    if (values && !members.group.bound.empty())
      values->set(
          i, theScene.bindingsOf(geometry.shapeOf(hit)),
          [&](uint32_t variable, float *value) { geometry.variable(hit, point, variable, value); });
    if (needed & footprintBits)
      findFootprint(theScene.camera, members.depth == 0, ray.origin, ray.direction, point);
    starts.set(i, point);
    depths[i] = float(point.frame.P.z);
    globals.set(i, wanted, point, ray, ray.travelled);
    volumeGlobals.set(i, inVolume, point, ray, 0);
    if (!shader) {
      Vec3f Ci = defaultSurface(point, ray.direction);
      for (int k = 0; k < 3; ++k)
        globals.component[ANYSL_COMPONENT_Ci + k][i] = Ci[k];
    }
  }

  uint32_t *seeds = state.arena.allocate<uint32_t>(size);
  uint32_t *traced = state.arena.allocate<uint32_t>(size);
  for (uint32_t i = 0; i < size; ++i) {
    seeds[i] = i < count ? rays.seed[members.numbers[i]] : 0;
    traced[i] = 0;
  }
  PacketBatch batch{this,   &state,        &members.group, &starts, seeds,
                    traced, members.depth, volume,         &members};
  AnyslShadeArgs surface = {};
  if (shader)
    surface = run(*shader, batch, count, globals, &*values);
  for (uint32_t i = 0; outcome.values && i < count; ++i) {
    uint32_t ray = members.numbers[i];
    answerValues(outcome.values[rays.target[ray]],
                 {&theScene, rays.hitOf(ray), rays.rayOf(ray), shader ? &surface : nullptr, i});
  }

  for (uint32_t i = 0; members.channels && i < count; ++i) {
    uint32_t target = rays.target[members.numbers[i]];
    bool visible = maxAbs(globals.triple(ANYSL_COMPONENT_Oi, i)) > 0;
    storeChannels(
        channels, shader, depths[i], outcome.passing[target], visible && !outcome.covered[target],
        members.channels + target * channels.size(),
        [&](int component) { return globals.component[component][i]; },
        [&](size_t output, unsigned k) { return values->output(shader->outputs[output], k, i); });
    outcome.covered[target] |= visible;
  }
  if (volume) {
    std::copy_n(globals.component + ANYSL_COMPONENT_Ci, 3,
                volumeGlobals.component + ANYSL_COMPONENT_Ci);
    std::copy_n(globals.component + ANYSL_COMPONENT_Oi, 3,
                volumeGlobals.component + ANYSL_COMPONENT_Oi);
    for (uint32_t i = 0; i < count; ++i)
      seeds[i] = hash(seeds[i], throughVolume);
    batch.surface = shader ? &surface : nullptr;
    run(*volume, batch, count, volumeGlobals, nullptr);
  }

  for (uint32_t i = 0; i < count; ++i) {
    uint32_t ray = members.numbers[i], target = rays.target[ray];
    Vec3f &passing = outcome.passing[target], before = passing;
    Radiance &radiance = outcome.radiance[target];
    bool seen = !members.group.matte || members.depth > 0;
    if (seen)
      radiance.color += passing * globals.triple(ANYSL_COMPONENT_Ci, i);
    passing *= Vec3f(1) - globals.triple(ANYSL_COMPONENT_Oi, i);
    if (!(maxAbs(passing) > 0x1p-12f))
      passing = Vec3f();
    if (seen)
      radiance.opacity += before - passing;
    if (passing == Vec3f())
      continue;
    outcome.behind->add(starts.behind(i, rays.rayOf(ray), rays.t[ray], members.group), target);
  }
}

template <unsigned W>
AnyslShadeArgs PacketHost<W>::run(const Shader &shader, PacketBatch &batch, uint32_t count,
                                  const GlobalArrays &globals,
                                  const ParameterArrays<float> *values) const {
  ThreadState &state = *batch.state;
  AnyslShadeArgs args = makeShadeArgs(shader, *batch.group, count, &batch);
  args.globals = reinterpret_cast<void *const *>(globals.component);
  args.seeds = batch.seeds;
  if (values)
    values->fill(args);
  state.counts.points += count;
  ++state.counts.batches;
  state.record(shader, *batch.group, args);
  LightScope lights(args, *batch.group->lights);
  state.startShading();
  shader.shade(&args, 0, count);
  state.stopShading();
  return args;
}

void PacketHostBase::transmission(ThreadState &state, RayList &rays, Vec3f *passing) const {
  const Geometry &geometry = scene().geometry();
  state.counts.shadowRays += rays.count;
  findBlocked(rays);
  RayList rest(state.arena, rays.count);
  for (uint32_t i = 0; i < rays.count; ++i) {
    bool blocked = rays.t[i] < 0;
    passing[rays.target[i]] = Vec3f(blocked ? 0 : 1);
    if (blocked || !geometry.hasPartialShadows())
      continue;
    rest.add(rays.rayOf(i), rays.target[i]);
  }
  for (unsigned layer = 0; rest.count > 0 && layer < maxLayers; ++layer) {
    findNearest(rest, PartialShadowRays);
    uint32_t kept = 0;
    for (uint32_t i = 0; i < rest.count; ++i) {
      Hit hit = rest.hitOf(i);
      if (!hit.isHit())
        continue;
      uint32_t target = rest.target[i];
      passing[target] *=
          Vec3f(Vec3d(1) - geometry.opacityAt(hit, rest.originOf(i), rest.directionOf(i)));
      Ray ray{rest.originOf(i), rest.directionOf(i), afterHit(hit.t), rest.far[i]};
      // In place: no later ray has been overwritten, since as many have been read as are kept.
      std::swap(rest.count, kept);
      rest.add(ray, target);
      std::swap(rest.count, kept);
    }
    rest.count = kept;
  }
}

//===-- Services ------------------------------------------------------------//

void setLane(float *vectors, uint32_t width, uint32_t i, Vec3f value) {
  for (uint32_t k = 0; k < 3; ++k)
    vectors[k * width + i] = value[int(k)];
}

/// The rays that the points of `mask` ask for, close together; a ray's target is its lane.
template <typename Seed>
RayList gather(PacketBatch &batch, const AskedRays &asked, uint32_t first, uint32_t width,
               uint32_t mask, const Seed &seed) {
  RayList rays(batch.state->arena, width);
  for (uint32_t rest = mask; rest != 0; rest &= rest - 1) {
    uint32_t i = uint32_t(std::countr_zero(rest));
    uint32_t itsSeed = seed(first + i);
    if (asked.valid[i])
      rays.add(asked.ray(i, itsSeed), i);
  }
  return rays;
}

void serveTracePacket(void *, const AnyslShadeArgs *args, uint32_t first, uint32_t width,
                      uint32_t mask, const float *P, const float *R, float *color) {
  auto &batch = *static_cast<PacketBatch *>(args->batch);
  ThreadState &state = *batch.state;
  ServiceScope service(state);
  Arena::Scope scope(state.arena);
  std::fill_n(color, 3 * width, 0.0f);
  AskedRays asked;
  makeTraceRays(*batch.starts, first, width, P, R, asked);
  RayList rays = gather(batch, asked, first, width, mask, [&](uint32_t point) {
    return hash(batch.seeds[point], ++batch.rays[point]);
  });
  if (rays.count == 0 || batch.depth >= batch.host->scene().description.maxDepth)
    return;
  state.counts.traceRays += rays.count;
  Radiance *radiance = state.arena.allocate<Radiance>(width);
  for (uint32_t i = 0; i < rays.count; ++i)
    rays.medium[i] =
        batch.starts->medium(first + rays.target[i], rays.directionOf(i), *batch.group);
  batch.host->follow(state, rays, TraceRays, batch.depth + 1, maxLayers, radiance, nullptr);
  for (uint32_t i = 0; i < rays.count; ++i)
    setLane(color, width, rays.target[i], radiance[rays.target[i]].color);
}

void serveDistancePacket(void *, const AnyslShadeArgs *args, uint32_t first, uint32_t width,
                         uint32_t mask, const float *P, const float *R, float *distance) {
  auto &batch = *static_cast<PacketBatch *>(args->batch);
  ThreadState &state = *batch.state;
  ServiceScope service(state);
  Arena::Scope scope(state.arena);
  std::fill_n(distance, width, 1e30f);
  AskedRays asked;
  makeTraceRays(*batch.starts, first, width, P, R, asked);
  RayList rays = gather(batch, asked, first, width, mask, [](uint32_t) { return 0u; });
  state.counts.traceRays += rays.count;
  batch.host->findNearest(rays, TraceRays);
  for (uint32_t i = 0; i < rays.count; ++i)
    distance[rays.target[i]] = rays.t[i];
}

void serveTransmissionPacket(void *, const AnyslShadeArgs *args, uint32_t first, uint32_t width,
                             uint32_t mask, const float *from, const float *to, float *color) {
  auto &batch = *static_cast<PacketBatch *>(args->batch);
  ThreadState &state = *batch.state;
  ServiceScope service(state);
  Arena::Scope scope(state.arena);
  std::fill_n(color, 3 * width, 1.0f);
  AskedRays asked;
  makeShadowRays(*batch.starts, first, width, from, to, asked);
  RayList rays = gather(batch, asked, first, width, mask, [](uint32_t) { return 0u; });
  Vec3f *passing = state.arena.allocate<Vec3f>(width);
  batch.host->transmission(state, rays, passing);
  for (uint32_t i = 0; i < rays.count; ++i)
    setLane(color, width, rays.target[i], passing[rays.target[i]]);
}

void serveHits(void *, const AnyslShadeArgs *args, uint32_t first, uint32_t width, uint32_t mask,
               const float *const *P, const float *const *R, const float *reach,
               const AnyslHits *hits) {
  auto &batch = *static_cast<PacketBatch *>(args->batch);
  ThreadState &state = *batch.state;
  ServiceScope service(state);
  Arena::Scope scope(state.arena);
  float from[3 * AskedRays::most], along[3 * AskedRays::most];
  for (uint32_t k = 0; k < 3; ++k) {
    std::copy_n(P[k], width, from + k * width);
    std::copy_n(R[k], width, along + k * width);
  }
  AskedRays asked;
  makeTraceRays(*batch.starts, first, width, from, along, asked);
  for (uint32_t i = 0; i < width; ++i)
    limitReach(asked, i, reach[i]);
  RayList rays = gather(batch, asked, first, width, mask, [&](uint32_t point) {
    return hash(batch.seeds[point], ++batch.rays[point]);
  });
  state.counts.traceRays += rays.count;
  const Scene &scene = batch.host->scene();
  // Beyond the deepest level surfaces are black.
  bool shades = hits->shades && batch.depth < scene.description.maxDepth;
  Radiance *radiance = state.arena.allocate<Radiance>(width);
  if (shades) {
    for (uint32_t i = 0; i < rays.count; ++i)
      rays.medium[i] =
          batch.starts->medium(first + rays.target[i], rays.directionOf(i), *batch.group);
    batch.host->follow(state, rays, TraceRays, batch.depth + 1, 1, radiance, nullptr, hits->values);
  } else {
    std::fill_n(radiance, width, Radiance{Vec3f(), Vec3f(1), 1});
    batch.host->findNearest(rays, TraceRays);
    for (uint32_t i = 0; hits->values && i < rays.count; ++i)
      answerValues(hits->values[rays.target[i]], {&scene, rays.hitOf(i), rays.rayOf(i)});
  }
  for (uint32_t i = 0; i < rays.count; ++i)
    storeHit(scene.geometry(), rays.hitOf(i), rays.rayOf(i), radiance[rays.target[i]],
             rays.target[i], *hits);
}

/// A lookup in a picture, while the clock of shading stands. There is no batch where defaults are
/// computed.
template <AnyslTextureService *service>
void outsideShading(void *renderer, const AnyslShadeArgs *args, uint32_t first, uint32_t width,
                    uint32_t mask, const AnyslTextureRequest *request,
                    const AnyslTexturePoints *points, float *result) {
  std::optional<ServiceScope> scope;
  if (args->batch)
    scope.emplace(*static_cast<PacketBatch *>(args->batch)->state);
  service(renderer, args, first, width, mask, request, points, result);
}

// A shader's scalar code (width 1) asks for one point at a time.
void serveTrace(void *renderer, const AnyslShadeArgs *args, uint32_t point, const double *P,
                const double *R, double *color) {
  float from[3] = {float(P[0]), float(P[1]), float(P[2])},
        along[3] = {float(R[0]), float(R[1]), float(R[2])};
  float result[3];
  serveTracePacket(renderer, args, point, 1, 1, from, along, result);
  std::copy_n(result, 3, color);
}

double serveDistance(void *renderer, const AnyslShadeArgs *args, uint32_t point, const double *P,
                     const double *R) {
  float from[3] = {float(P[0]), float(P[1]), float(P[2])},
        along[3] = {float(R[0]), float(R[1]), float(R[2])};
  float result;
  serveDistancePacket(renderer, args, point, 1, 1, from, along, &result);
  return result;
}

void serveTransmission(void *renderer, const AnyslShadeArgs *args, uint32_t point,
                       const double *from, const double *to, double *color) {
  float begin[3] = {float(from[0]), float(from[1]), float(from[2])},
        end[3] = {float(to[0]), float(to[1]), float(to[2])};
  float result[3];
  serveTransmissionPacket(renderer, args, point, 1, 1, begin, end, result);
  std::copy_n(result, 3, color);
}

/// Calls `serve` with what is known of the point that asks: nothing where defaults are computed.
template <typename Serve>
auto withAsker(const AnyslShadeArgs *args, uint32_t point, const Serve &serve) {
  const auto *batch = static_cast<const PacketBatch *>(args->batch);
  if (!batch)
    return serve(Asker());
  Hit hit;
  bool known = point < batch->members->count;
  if (known)
    hit = batch->members->rays.hitOf(batch->members->numbers[point]);
  return serve(
      Asker{batch->group, batch->volume, batch->surface, batch->depth, known ? &hit : nullptr});
}

int serveNamed(void *renderer, const AnyslShadeArgs *args, uint32_t point, const AnyslQuery *query,
               AnyslCell *value) {
  return withAsker(args, point, [&](const Asker &asker) {
    return serveQuery(*static_cast<const Shader *>(renderer), asker, args, point, *query, value);
  });
}

int serveCall(void *renderer, const AnyslShadeArgs *args, uint32_t point, const char *handle,
              AnyslMessage *message) {
  return withAsker(args, point, [&](const Asker &asker) {
    return serveMethod(*static_cast<const Shader *>(renderer), asker, args, point, handle,
                       *message);
  });
}

const char *serveName(void *renderer, const AnyslShadeArgs *args, const char *category,
                      uint32_t index) {
  return withAsker(args, 0, [&](const Asker &asker) {
    return serveShaderName(*static_cast<const Shader *>(renderer), asker, category, index);
  });
}

int serveMatrix(void *renderer, const AnyslShadeArgs *args, const char *from, const char *to,
                double *matrix) {
  const auto *batch = static_cast<const PacketBatch *>(args->batch);
  return serveSpaceMatrix(renderer, batch ? &batch->group->object : nullptr, from, to, matrix);
}

const AnyslServices services = [] {
  AnyslServices offered = {};
  offered.struct_size = sizeof offered;
  offered.trace = serveTrace;
  offered.trace_packet = serveTracePacket;
  offered.trace_distance = serveDistance;
  offered.trace_distance_packet = serveDistancePacket;
  offered.transmission = serveTransmission;
  offered.transmission_packet = serveTransmissionPacket;
  offered.space_matrix = serveMatrix;
  offered.texture = outsideShading<serveTexture>;
  offered.environment = outsideShading<serveEnvironment>;
  offered.shadow = outsideShading<serveShadow>;
  offered.trace_hit = serveHits;
  offered.query = serveNamed;
  offered.call_method = serveCall;
  offered.shader_name = serveName;
  return offered;
}();

template <unsigned W>
std::unique_ptr<Host> makeHost(const SceneDescription &description, const ShaderCache &cache,
                               Warnings &warnings) {
  auto host = std::make_unique<PacketHost<W>>(description, cache, services, warnings);
  if (host->scene().real() != ANYSL_REAL_FLOAT)
    throw UserError("packets of rays are float, but the shaders compute in double");
  return host;
}

} // namespace

std::unique_ptr<Host> anysl::render::makePacketHost(const SceneDescription &description,
                                                    const ShaderCache &cache, unsigned width,
                                                    Warnings &warnings) {
  switch (width) {
  case 1:
    return makeHost<1>(description, cache, warnings);
  case 4:
    return makeHost<4>(description, cache, warnings);
  case 8:
    return makeHost<8>(description, cache, warnings);
  case 16:
    return makeHost<16>(description, cache, warnings);
  }
  throw UserError("packets of " + std::to_string(width) + " rays: the width must be 1, 4, 8 or 16");
}
