//===-- tools/anysl-render/RayList.h - many rays, and what they meet --------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_RAYLIST_H
#define ANYSL_RENDER_RAYLIST_H

#include "tools/anysl-render/Host.h"

namespace anysl::render {

/// Rays and what they meet, one array for each number.
struct RayList {
  uint32_t count = 0, capacity = 0;
  float *origin[3], *direction[3], *near, *far, *travelled;
  const Shader **medium;
  const RaySpread **spread;
  uint32_t *seed;
  uint32_t *target; ///< where the ray's light goes to: an index into the caller's arrays
  float *t, *u, *v;
  uint32_t *geometry, *primitive;

  RayList(Arena &arena, uint32_t capacity);

  void add(const Ray &ray, uint32_t toTarget);
  Vec3f originOf(uint32_t i) const { return {origin[0][i], origin[1][i], origin[2][i]}; }
  Vec3f directionOf(uint32_t i) const {
    return {direction[0][i], direction[1][i], direction[2][i]};
  }
  Ray rayOf(uint32_t i) const {
    return {originOf(i), directionOf(i), near[i],   far[i],
            seed[i],     travelled[i],   medium[i], spread[i]};
  }
  void set(uint32_t i, const Hit &hit) {
    t[i] = hit.t, u[i] = hit.u, v[i] = hit.v;
    geometry[i] = hit.geometry, primitive[i] = hit.primitive;
  }
  Hit hitOf(uint32_t i) const { return {t[i], u[i], v[i], geometry[i], primitive[i]}; }
};

/// Finds what the rays meet, in packets of W: 1, 4, 8 or 16.
template <unsigned W>
void findNearest(const Geometry &geometry, RayList &rays, unsigned mask);
/// Sets t to -infinity where a ray is blocked.
template <unsigned W>
void findBlocked(const Geometry &geometry, RayList &rays);

} // namespace anysl::render

#endif
