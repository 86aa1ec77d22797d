//===-- tools/anysl-render/Host.cpp - what the two hosts have in common -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Host.h"

#include <algorithm>

using namespace anysl::render;

void Arena::nextBlock(size_t bytes) {
  // Blocks stay for the next time; one that is too small is passed over until then.
  size_t next = blocks.empty() ? 0 : block + 1;
  while (next < blocks.size() && blocks[next].size < bytes)
    ++next;
  if (next == blocks.size()) {
    size_t size = std::max(bytes, size_t(1) << 20);
    void *memory = _mm_malloc(size, 64);
    if (!memory)
      throw std::bad_alloc();
    blocks.push_back({std::unique_ptr<std::byte[], Free>(static_cast<std::byte *>(memory)), size});
  }
  block = next;
  used = 0;
}

RenderCounts &RenderCounts::operator+=(const RenderCounts &other) {
  cameraRays += other.cameraRays;
  traceRays += other.traceRays;
  shadowRays += other.shadowRays;
  points += other.points;
  batches += other.batches;
  shadingTicks += other.shadingTicks;
  return *this;
}

Vec3f RayStart::origin(Vec3f asked, Vec3f direction) const {
  // A shader may start a ray anywhere, but nearly always it starts at the point being shaded. The
  // comparison leaves room for a P that has been through another number format.
  if (!(maxAbs(asked - P) <= 0.25f * offset))
    return asked;
  return asked + Ng * (dot(Ng, direction) < 0 ? -offset : offset);
}

bool anysl::render::traceRay(const RayStart &start, Vec3f P, Vec3f R, uint32_t seed, Ray &ray) {
  Vec3d direction = normalized(Vec3d(R));
  if (direction == Vec3d() || !isFinite(direction) || !isFinite(P))
    return false;
  ray.direction = Vec3f(direction);
  ray.origin = start.origin(P, ray.direction);
  ray.near = 0;
  ray.far = 1e30f;
  ray.seed = seed;
  return true;
}

bool anysl::render::shadowRay(const RayStart &start, Vec3f from, Vec3f to, Ray &ray) {
  Vec3d way = Vec3d(to) - Vec3d(from);
  Vec3f direction = Vec3f(normalized(way));
  Vec3f begin = start.origin(from, direction), end = start.origin(to, -direction);
  way = Vec3d(end) - Vec3d(begin);
  double distance = length(way);
  if (!(distance > 0) || !std::isfinite(distance))
    return false;
  ray.origin = begin;
  ray.direction = Vec3f(way * (1 / distance));
  ray.near = 0;
  // Not as far as a surface on which the other end may lie.
  ray.far = float(distance * (1 - 0x1p-18));
  return true;
}

Vec3f anysl::render::defaultSurface(const SurfacePoint &point, Vec3f direction) {
  double facing = std::fabs(dot(point.normal, Vec3d(direction)));
  return Vec3f(point.color * point.opacity * (0.1 + 0.9 * facing));
}

int anysl::render::serveSpaceMatrix(void *renderer, const Matrix4 *objectToCamera, const char *from,
                                    const char *to, double matrix[16]) {
  const auto &shader = *static_cast<const SurfaceShader *>(renderer);
  const Scene &scene = *shader.scene;
  Matrix4 result;
  if (!spaceMatrix(scene.description, scene.camera, &shader.use->shaderToCamera, objectToCamera, from,
                   to, result))
    return 0;
  for (int i = 0; i < 16; ++i)
    matrix[i] = result.m[i / 4][i % 4];
  return 1;
}

AnyslShadeArgs anysl::render::makeShadeArgs(const ShadingGroup &group, uint32_t count, void *batch) {
  AnyslShadeArgs args;
  anysl_instance_fill_args(group.shader->instance.get(), &args);
  args.count = count;
  args.batch = batch;
  args.lights = group.lights->lights.data();
  args.light_count = uint32_t(group.lights->lights.size());
  std::copy_n(group.lights->ambient, 3, args.ambient);
  return args;
}
