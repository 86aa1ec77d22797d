//===-- tools/anysl-render/RayList.cpp - many rays through Embree, in packets -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/RayList.h"

#include <algorithm>
#include <cstring>

using namespace anysl::render;

RayList::RayList(Arena &arena, uint32_t capacity) : capacity(capacity) {
  // Packets are loaded whole, so that the arrays reach beyond the last ray.
  size_t size = (capacity + 15) / 16 * 16;
  for (float **array : {&origin[0], &origin[1], &origin[2], &direction[0], &direction[1],
                        &direction[2], &near, &far, &travelled, &t, &u, &v})
    *array = arena.allocate<float>(size);
  medium = arena.allocate<const Shader *>(size);
  spread = arena.allocate<const RaySpread *>(size);
  for (uint32_t **array : {&seed, &target, &geometry, &primitive})
    *array = arena.allocate<uint32_t>(size);
}

void RayList::add(const Ray &ray, uint32_t toTarget) {
  for (int k = 0; k < 3; ++k) {
    origin[k][count] = ray.origin[k];
    direction[k][count] = ray.direction[k];
  }
  near[count] = ray.near;
  far[count] = ray.far;
  travelled[count] = ray.travelled;
  medium[count] = ray.medium;
  spread[count] = ray.spread;
  seed[count] = ray.seed;
  target[count++] = toTarget;
}

template <unsigned W>
void anysl::render::findNearest(const Geometry &geometry, RayList &rays, unsigned mask) {
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
void anysl::render::findBlocked(const Geometry &geometry, RayList &rays) {
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

template void anysl::render::findNearest<1>(const Geometry &, RayList &, unsigned);
template void anysl::render::findBlocked<1>(const Geometry &, RayList &);
template void anysl::render::findNearest<4>(const Geometry &, RayList &, unsigned);
template void anysl::render::findBlocked<4>(const Geometry &, RayList &);
template void anysl::render::findNearest<8>(const Geometry &, RayList &, unsigned);
template void anysl::render::findBlocked<8>(const Geometry &, RayList &);
template void anysl::render::findNearest<16>(const Geometry &, RayList &, unsigned);
template void anysl::render::findBlocked<16>(const Geometry &, RayList &);
