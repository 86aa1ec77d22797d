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

#include "tools/anysl-render/PacketHost.h"
#include "tools/anysl-render/ParameterArrays.h"

#include <algorithm>
#include <optional>

namespace stc = anysl::stc;
using namespace anysl::render;

namespace {

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

/// What becomes of rays: the light so far, and what goes on.
struct Outcome {
  Vec3f *passing;
  bool *covered; ///< whether some surface counts already for what the nearest one gives
  Radiance *radiance;
  RayList *behind;
  AnyslMessage *values; ///< what else the targets ask of the surfaces, or null
};

template <unsigned W>
class SizedPacketHost final : public PacketHost {
public:
  SizedPacketHost(const SceneDescription &description, const ShaderCache &cache, Warnings &warnings)
      : theScene(description, cache, packetServices, ANYSL_LAYOUT_SOA, W, warnings) {}

  void trace(ThreadState &state, const Ray *rays, uint32_t count, Radiance *radiance,
             float *channels) const override {
    Arena::Scope scope(state.arena);
    RayList list(state.arena, count);
    for (uint32_t i = 0; i < count; ++i)
      list.add(rays[i], i);
    state.counts.cameraRays += count;
    follow(state, list, RayPurpose(), radiance, theScene.channels().size() > 0 ? channels : nullptr,
           nullptr);
  }
  // Enough points for full packets after sorting, few enough for their arrays to stay in cache.
  uint32_t preferredCount() const override { return 256; }
  const Scene &scene() const override { return theScene; }

  void follow(ThreadState &state, RayList &rays, const RayPurpose &purpose, Radiance *radiance,
              float *channels, AnyslMessage *values) const override;
  void nearest(RayList &rays, const RayPurpose &purpose) const override;
  void transmission(const PacketBatch &from, RayList &rays, RayPurpose purpose,
                    Vec3f *passing) const override;

private:
  /// Calls act(group, medium, members, count) for the hits of each group in each medium, in the
  /// order of the rays. `group` has each ray's, `done` where there is none, and is used up.
  static constexpr uint32_t done = ~uint32_t(0);
  template <typename Act>
  void sort(Arena &arena, const RayList &rays, uint32_t *group, const Act &act) const;
  void shade(ThreadState &state, const Members &members, const Outcome &outcome) const;
  /// Shades, and gives back what with; `values` may be null.
  AnyslShadeArgs run(const Shader &shader, PacketBatch &batch, uint32_t count,
                     const GlobalArrays &globals, const ParameterArrays<float> *values) const;

  Scene theScene;
};

template <unsigned W>
void SizedPacketHost<W>::nearest(RayList &rays, const RayPurpose &purpose) const {
  findNearest<W>(theScene.geometry(), rays, purpose.mask);
  for (uint32_t i = 0; purpose.chooses() && i < rays.count; ++i)
    rays.set(i, firstSeen(theScene, rays.rayOf(i), rays.hitOf(i), purpose));
}

template <unsigned W>
void SizedPacketHost<W>::follow(ThreadState &state, RayList &rays, const RayPurpose &purpose,
                                Radiance *radiance, float *channels, AnyslMessage *values) const {
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
  for (unsigned layer = 0; current->count > 0 && layer < purpose.layers; ++layer) {
    RayList &list = *current;
    nearest(list, purpose);
    RayList &behind = others[layer % 2];
    behind = RayList(state.arena, list.count);

    // Sort the hits by group and medium, keeping the order of the rays within each.
    Outcome outcome{passing, covered, radiance, &behind, values};
    uint32_t *group = state.arena.allocate<uint32_t>(list.count);
    for (uint32_t i = 0; i < list.count; ++i) {
      Hit hit = list.hitOf(i);
      group[i] = hit.isHit() ? geometry.groupOf(hit) : done;
      if (hit.isHit())
        continue;
      uint32_t target = list.target[i];
      radiance[target].color += passing[target] * theScene.background.color(list.directionOf(i));
    }
    sort(state.arena, list, group,
         [&](const ShadingGroup &its, const Shader *medium, const uint32_t *members,
             uint32_t count) {
           shade(state,
                 {list, members, count, its, medium ? medium : its.atmosphere, purpose.path,
                  channels},
                 outcome);
         });
    current = &behind;
  }
  for (uint32_t i = 0; i < rays.count; ++i) {
    Radiance &result = radiance[rays.target[i]];
    result.alpha = (result.opacity.x + result.opacity.y + result.opacity.z) / 3;
  }
}

template <unsigned W>
template <typename Act>
void SizedPacketHost<W>::sort(Arena &arena, const RayList &rays, uint32_t *group,
                              const Act &act) const {
  uint32_t *members = arena.allocate<uint32_t>(rays.count);
  for (uint32_t i = 0; i < rays.count; ++i) {
    if (group[i] == done)
      continue;
    uint32_t wanted = group[i], count = 0;
    const Shader *medium = rays.medium[i];
    for (uint32_t j = i; j < rays.count; ++j)
      if (group[j] == wanted && rays.medium[j] == medium) {
        members[count++] = j;
        group[j] = done;
      }
    act(theScene.group(wanted), medium, members, count);
  }
}

template <unsigned W>
void SizedPacketHost<W>::shade(ThreadState &state, const Members &members,
                               const Outcome &outcome) const {
  const Geometry &geometry = theScene.geometry();
  const Channels &channels = theScene.channels();
  const RayList &rays = members.rays;
  const Shader *shader = members.group.shaderFor(members.path.kind), *volume = members.volume;
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
                   (volume && volume->asksFor(stc::Service::Queries)) || outcome.values,
                   ANYSL_LAYOUT_SOA, size);

  float *depths = state.arena.allocate<float>(size);
  for (uint32_t i = 0; i < count; ++i) {
    Ray ray = rays.rayOf(members.numbers[i]);
    SurfacePoint point;
    Hit hit = rays.hitOf(members.numbers[i]);
    geometry.evaluate(hit, ray.origin, ray.direction, needed, point);
    if (values && !members.group.bound.empty())
      values->set(i, theScene.bindingsOf(geometry.shapeOf(hit)), geometry.variablesAt(hit, point));
    if (needed & footprintBits)
      findFootprint(theScene.camera, members.path.depth == 0, ray, point);
    if (state.again)
      computeAgain(state, theScene, hit, ray, members.path, *state.again & needed);
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
  PacketBatch batch{this,   &state,       &members.group, &starts, seeds,
                    traced, members.path, volume,         &members};
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

  for (uint32_t i = 0; members.path.kind == RayKind::Shadow && i < count; ++i)
    outcome.passing[rays.target[members.numbers[i]]] *=
        passedBy(globals.triple(ANYSL_COMPONENT_Oi, i));
  for (uint32_t i = 0; members.path.kind != RayKind::Shadow && i < count; ++i) {
    uint32_t ray = members.numbers[i], target = rays.target[ray];
    Vec3f &passing = outcome.passing[target], before = passing;
    Radiance &radiance = outcome.radiance[target];
    bool seen = !members.group.matte || members.path.depth > 0;
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
AnyslShadeArgs SizedPacketHost<W>::run(const Shader &shader, PacketBatch &batch, uint32_t count,
                                       const GlobalArrays &globals,
                                       const ParameterArrays<float> *values) const {
  ThreadState &state = *batch.state;
  AnyslShadeArgs args = makeShadeArgs(shader, *batch.group, count, &batch);
  args.globals = reinterpret_cast<void *const *>(globals.component);
  args.seeds = batch.seeds;
  if (values)
    values->fill(args);
  state.counts.points += count;
  state.counts.shadowPoints += batch.members->path.kind == RayKind::Shadow ? count : 0;
  ++state.counts.batches;
  state.record(shader, *batch.group, args);
  LightScope lights(args, *batch.group->lights);
  state.startShading();
  shader.shade(&args, 0, count);
  state.stopShading();
  return args;
}

template <unsigned W>
void SizedPacketHost<W>::transmission(const PacketBatch &from, RayList &rays, RayPurpose purpose,
                                      Vec3f *passing) const {
  ThreadState &state = *from.state;
  const Geometry &geometry = theScene.geometry();
  state.counts.shadowRays += rays.count;
  purpose.mask = OpaqueShadowRays;
  if (purpose.chooses())
    nearest(rays, purpose);
  else
    findBlocked<W>(geometry, rays);
  auto isBlocked = [&](uint32_t i) {
    return purpose.chooses() ? rays.hitOf(i).isHit() : rays.t[i] < 0;
  };
  RayList lists[2] = {RayList(state.arena, rays.count), RayList(state.arena, rays.count)};
  for (uint32_t i = 0; i < rays.count; ++i) {
    bool blocked = isBlocked(i);
    passing[rays.target[i]] = Vec3f(blocked ? 0 : 1);
    if (!blocked && geometry.hasPartialShadows())
      lists[0].add(rays.rayOf(i), rays.target[i]);
  }
  purpose.mask = PartialShadowRays;
  uint32_t *group = state.arena.allocate<uint32_t>(rays.count);
  for (unsigned layer = 0; layer < maxLayers; ++layer) {
    RayList &list = lists[layer % 2], &behind = lists[1 - layer % 2];
    if (list.count == 0)
      break;
    nearest(list, purpose);
    behind.count = 0;
    bool isShaded = false;
    for (uint32_t i = 0; i < list.count; ++i) {
      group[i] = done;
      Hit hit = list.hitOf(i);
      if (!hit.isHit())
        continue;
      uint32_t number = geometry.groupOf(hit), target = list.target[i];
      const ShadingGroup &its = theScene.group(number);
      if (its.shadow && from.members->path.kind != RayKind::Shadow) {
        group[i] = number;
        isShaded = true;
      } else {
        passing[target] *= passedAt(geometry, its, hit, list.originOf(i), list.directionOf(i));
      }
      behind.add({list.originOf(i), list.directionOf(i), afterHit(hit.t), list.far[i],
                  hash(list.seed[i], behindSurface)},
                 target);
    }
    if (isShaded)
      sort(state.arena, list, group,
           [&](const ShadingGroup &its, const Shader *, const uint32_t *members, uint32_t count) {
             shade(state, {list, members, count, its, nullptr, purpose.path, nullptr},
                   {passing, nullptr, nullptr, nullptr, nullptr});
           });
  }
}

template <unsigned W>
std::unique_ptr<Host> makeSized(const SceneDescription &description, const ShaderCache &cache,
                                Warnings &warnings) {
  auto host = std::make_unique<SizedPacketHost<W>>(description, cache, warnings);
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
    return makeSized<1>(description, cache, warnings);
  case 4:
    return makeSized<4>(description, cache, warnings);
  case 8:
    return makeSized<8>(description, cache, warnings);
  case 16:
    return makeSized<16>(description, cache, warnings);
  }
  throw UserError("packets of " + std::to_string(width) + " rays: the width must be 1, 4, 8 or 16");
}
