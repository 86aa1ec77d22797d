//===-- tools/anysl-render/PacketServices.cpp - what shaders ask of packets' host -------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/HostServices.h"
#include "tools/anysl-render/PacketHost.h"

#include <algorithm>
#include <bit>

using namespace anysl::render;

namespace {

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

/// Tells the rays how they differ from their neighbours, where that is known.
void spreadRays(RayList &rays, const PacketBatch &batch, const AskedRays &asked, uint32_t first,
                const float *const *R, const AnyslRayDerivatives *change) {
  if (!change)
    return;
  auto *spreads = batch.state->arena.allocate<RaySpread>(rays.count);
  for (uint32_t i = 0; i < rays.count; ++i) {
    uint32_t lane = rays.target[i];
    if (spreadRay(*batch.starts, first + lane, asked, lane, R, *change, spreads[i]))
      rays.spread[i] = &spreads[i];
  }
}

/// Vectors lie as x[width] y[width] z[width]; `change` may be null.
void traceAll(const AnyslShadeArgs *args, uint32_t first, uint32_t width, uint32_t mask,
              const float *P, const float *R, const AnyslRayDerivatives *change,
              float *const color[3]) {
  auto &batch = *static_cast<PacketBatch *>(args->batch);
  ThreadState &state = *batch.state;
  ServiceScope service(state);
  Arena::Scope scope(state.arena);
  for (int k = 0; k < 3; ++k)
    std::fill_n(color[k], width, 0.0f);
  AskedRays asked;
  makeTraceRays(*batch.starts, first, width, P, R, asked);
  RayList rays = gather(batch, asked, first, width, mask, [&](uint32_t point) {
    return hash(batch.seeds[point], ++batch.rays[point]);
  });
  RayPurpose purpose = tracedFrom(batch.path, RayKind::Traced);
  if (rays.count == 0 || !isWithinDepth(batch.host->scene(), *batch.group, purpose.path))
    return;
  const float *const along[3] = {R, R + width, R + 2 * width};
  spreadRays(rays, batch, asked, first, along, change);
  state.counts.traceRays += rays.count;
  Radiance *radiance = state.arena.allocate<Radiance>(width);
  for (uint32_t i = 0; i < rays.count; ++i)
    rays.medium[i] =
        batch.starts->medium(first + rays.target[i], rays.directionOf(i), *batch.group);
  batch.host->follow(state, rays, purpose, radiance, nullptr);
  for (uint32_t i = 0; i < rays.count; ++i)
    for (int k = 0; k < 3; ++k)
      color[k][rays.target[i]] = radiance[rays.target[i]].color[k];
}

void serveTracePacket(void *, const AnyslShadeArgs *args, uint32_t first, uint32_t width,
                      uint32_t mask, const float *P, const float *R, float *color) {
  float *const components[3] = {color, color + width, color + 2 * width};
  traceAll(args, first, width, mask, P, R, nullptr, components);
}

/// Vectors in an array for each component, as x[width] y[width] z[width].
struct Joined {
  Joined(const float *const v[3], uint32_t width) {
    for (uint32_t k = 0; k < 3; ++k)
      std::copy_n(v[k], width, values + k * width);
  }
  float values[3 * AskedRays::most];
};

void serveTraceDerivatives(void *, const AnyslShadeArgs *args, uint32_t first, uint32_t width,
                           uint32_t mask, const float *const *P, const float *const *R,
                           const AnyslRayDerivatives *change, float *const color[3]) {
  traceAll(args, first, width, mask, Joined(P, width).values, Joined(R, width).values, change,
           color);
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
  batch.host->nearest(rays, tracedFrom(batch.path, RayKind::Traced));
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
  RayList rays = gather(batch, asked, first, width, mask,
                        [&](uint32_t point) { return hash(batch.seeds[point], towardsLight); });
  Vec3f *passing = state.arena.allocate<Vec3f>(width);
  batch.host->transmission(batch, rays, tracedFrom(batch.path, RayKind::Shadow), passing);
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
  const Scene &scene = batch.host->scene();
  RayPurpose purpose = askedFrom(batch.path, *hits);
  bool isShadow = purpose.path.kind == RayKind::Shadow;
  AskedRays asked;
  makeAskedRays(*batch.starts, first, width, Joined(P, width).values, Joined(R, width).values,
                reach, isShadow, asked);
  RayList rays = gather(batch, asked, first, width, mask, [&](uint32_t point) {
    return hash(batch.seeds[point], isShadow ? towardsLight : ++batch.rays[point]);
  });
  bool isWithin = isWithinDepth(scene, *batch.group, purpose.path);
  if (isShadow || (!isWithin && endsAtDepth(purpose, *hits))) {
    Vec3f *passing = state.arena.allocate<Vec3f>(width);
    std::fill_n(passing, width, Vec3f());
    if (isShadow)
      batch.host->transmission(batch, rays, purpose, passing);
    for (uint32_t i = 0; i < rays.count; ++i)
      storeOpacity(Vec3f(1) - passing[rays.target[i]], rays.target[i], *hits);
    return;
  }
  state.counts.traceRays += rays.count;
  Radiance *radiance = state.arena.allocate<Radiance>(width);
  if (hits->shades && isWithin) {
    for (uint32_t i = 0; i < rays.count; ++i)
      rays.medium[i] =
          batch.starts->medium(first + rays.target[i], rays.directionOf(i), *batch.group);
    spreadRays(rays, batch, asked, first, R, hits->change);
    batch.host->follow(state, rays, purpose, radiance, nullptr, hits->values);
  } else {
    // Beyond the deepest level surfaces are black.
    std::fill_n(radiance, width, Radiance{Vec3f(), Vec3f(1), 1});
    batch.host->nearest(rays, purpose);
    for (uint32_t i = 0; hits->values && i < rays.count; ++i)
      answerValues(hits->values[rays.target[i]], {&scene, rays.hitOf(i), rays.rayOf(i)});
  }
  for (uint32_t i = 0; i < rays.count; ++i)
    storeHit(scene.geometry(), rays.hitOf(i), rays.rayOf(i), radiance[rays.target[i]],
             rays.target[i], *hits);
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

} // namespace

const AnyslServices anysl::render::packetServices = [] {
  AnyslServices offered = servicesOfBatch<PacketBatch>();
  offered.trace = serveTrace;
  offered.trace_packet = serveTracePacket;
  offered.trace_distance = serveDistance;
  offered.trace_distance_packet = serveDistancePacket;
  offered.transmission = serveTransmission;
  offered.transmission_packet = serveTransmissionPacket;
  offered.trace_hit = serveHits;
  offered.trace_derivatives = serveTraceDerivatives;
  return offered;
}();
