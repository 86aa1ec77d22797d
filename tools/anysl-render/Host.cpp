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
  shadowPoints += other.shadowPoints;
  batches += other.batches;
  shadingTicks += other.shadingTicks;
  return *this;
}

//===-- Starts of rays ------------------------------------------------------//

RayStarts::RayStarts(Arena &arena, size_t count) {
  // Whole vectors are loaded, so that the arrays reach beyond the last point.
  count = (count + AskedRays::most - 1) / AskedRays::most * AskedRays::most;
  for (float **array : {&P[0], &P[1], &P[2], &Ng[0], &Ng[1], &Ng[2], &lift[0], &lift[1], &lift[2],
                        &offset, &toRight[0], &toRight[1], &down[0], &down[1]})
    *array = arena.allocate<float>(count);
}

void RayStarts::set(size_t i, const SurfacePoint &point) {
  for (int k = 0; k < 3; ++k) {
    P[k][i] = float(point.frame.P[k]);
    Ng[k][i] = float(point.frame.normal[k]);
    lift[k][i] = float(point.lift[k]);
  }
  offset[i] = point.offset;
  toRight[0][i] = float(point.toRight.u), toRight[1][i] = float(point.toRight.v);
  down[0][i] = float(point.down.u), down[1][i] = float(point.down.v);
}

Ray RayStarts::behind(size_t i, const Ray &ray, float t, const ShadingGroup &group) const {
  Vec3f normal(Ng[0][i], Ng[1][i], Ng[2][i]), p(P[0][i], P[1][i], P[2][i]);
  float distance = dot(normal, ray.direction) < 0 ? -offset[i] : offset[i];
  Ray result;
  result.origin = p + normal * distance;
  result.direction = ray.direction;
  result.far = ray.far - t;
  result.seed = hash(ray.seed, behindSurface);
  result.travelled = ray.travelled + t;
  result.spread = ray.spread;
  result.medium = medium(i, ray.direction, group);
  return result;
}

const Shader *RayStarts::medium(size_t i, Vec3f direction, const ShadingGroup &group) const {
  bool inwards = dot(Vec3f(Ng[0][i], Ng[1][i], Ng[2][i]), direction) < 0;
  return inwards ? group.interior : group.exterior;
}

namespace {

/// How far along the normal a ray that starts at `from` has to start: 0 for a shader's own points.
/// The comparison leaves room for a P that has been through another number format.
[[gnu::always_inline]] inline float shift(const RayStarts &starts, size_t point, float fx, float fy,
                                          float fz, float dx, float dy, float dz) {
  float offset = starts.offset[point], near = 0.25f * offset;
  float x = std::fabs(fx - starts.P[0][point]), y = std::fabs(fy - starts.P[1][point]);
  float z = std::fabs(fz - starts.P[2][point]);
  float away = x > y ? x : y;
  bool here = (away > z ? away : z) <= near;
  float facing = starts.Ng[0][point] * dx + starts.Ng[1][point] * dy + starts.Ng[2][point] * dz;
  return here ? (facing < 0 ? -offset : offset) : 0;
}

// Squares of floats do not overflow in double, so that lengths need no scaling.

[[gnu::always_inline]] inline void traceLane(const RayStarts &starts, size_t point, uint32_t i,
                                             uint32_t count, const float *P, const float *R,
                                             AskedRays &rays) {
  double x = R[i], y = R[count + i], z = R[2 * count + i];
  double length = __builtin_sqrt(x * x + y * y + z * z), scale = 1 / length;
  float dx = float(x * scale), dy = float(y * scale), dz = float(z * scale);
  float px = P[i], py = P[count + i], pz = P[2 * count + i];
  float off = shift(starts, point, px, py, pz, dx, dy, dz);
  rays.origin[0][i] = px + starts.Ng[0][point] * off;
  rays.origin[1][i] = py + starts.Ng[1][point] * off;
  rays.origin[2][i] = pz + starts.Ng[2][point] * off;
  rays.direction[0][i] = dx;
  rays.direction[1][i] = dy;
  rays.direction[2][i] = dz;
  rays.far[i] = 1e30f;
  // Written so that NaN fails, in P as well.
  rays.valid[i] =
      (length > 0) & (length < 1e300) & (px - px == 0) & (py - py == 0) & (pz - pz == 0);
}

/// Moves the end (x, y, z) of a shadow ray off its surface, where it lies on one: towards (dx, dy,
/// dz), and up to the smooth surface on whose outer side that is.
[[gnu::always_inline]] inline void raise(const RayStarts &starts, size_t point, float &x, float &y,
                                         float &z, float dx, float dy, float dz) {
  float lx = starts.lift[0][point], ly = starts.lift[1][point], lz = starts.lift[2][point];
  bool outside = lx * dx + ly * dy + lz * dz > 0;
  float off =
      shift(starts, point, x, y, z, outside ? lx : dx, outside ? ly : dy, outside ? lz : dz);
  float height = outside ? (off != 0 ? 1.0f : 0.0f) : 0.0f;
  x += starts.Ng[0][point] * off + lx * height;
  y += starts.Ng[1][point] * off + ly * height;
  z += starts.Ng[2][point] * off + lz * height;
}

[[gnu::always_inline]] inline void shadowLane(const RayStarts &starts, size_t point, uint32_t i,
                                              uint32_t count, const float *from, const float *to,
                                              AskedRays &rays) {
  float fx = from[i], fy = from[count + i], fz = from[2 * count + i];
  float tx = to[i], ty = to[count + i], tz = to[2 * count + i];
  float dx = tx - fx, dy = ty - fy, dz = tz - fz;
  raise(starts, point, fx, fy, fz, dx, dy, dz);
  raise(starts, point, tx, ty, tz, -dx, -dy, -dz);
  double x = double(tx) - fx, y = double(ty) - fy, z = double(tz) - fz;
  double length = __builtin_sqrt(x * x + y * y + z * z), scale = 1 / length;
  rays.origin[0][i] = fx;
  rays.origin[1][i] = fy;
  rays.origin[2][i] = fz;
  rays.direction[0][i] = float(x * scale);
  rays.direction[1][i] = float(y * scale);
  rays.direction[2][i] = float(z * scale);
  // Not as far as a surface on which the other end may lie.
  rays.far[i] = float(length * (1 - 0x1p-18));
  rays.valid[i] = (length > 0) & (length < 1e300);
}

} // namespace

// One lane and many compute the same.
namespace anysl::render {

ANYSL_RENDER_WIDE void makeTraceRays(const RayStarts &given, size_t first, uint32_t count,
                                     const float *P, const float *R, AskedRays &rays) {
  const RayStarts starts = given;
#pragma clang loop vectorize(assume_safety)
  for (uint32_t i = 0; i < count; ++i)
    traceLane(starts, first + i, i, count, P, R, rays);
}

ANYSL_RENDER_WIDE void makeShadowRays(const RayStarts &given, size_t first, uint32_t count,
                                      const float *from, const float *to, AskedRays &rays) {
  const RayStarts starts = given;
#pragma clang loop vectorize(assume_safety)
  for (uint32_t i = 0; i < count; ++i)
    shadowLane(starts, first + i, i, count, from, to, rays);
}

} // namespace anysl::render

bool anysl::render::spreadRay(const RayStarts &starts, size_t point, const AskedRays &rays,
                              uint32_t i, const float *const R[3],
                              const AnyslRayDerivatives &change, RaySpread &spread) {
  auto lane = [i](const float *const v[3]) { return Vec3d(Vec3f(v[0][i], v[1][i], v[2][i])); };
  Vec3d unit(rays.ray(i, 0).direction);
  double size = length(lane(R)), sum = 0;
  for (int pixel = 0; pixel < 2; ++pixel) {
    float *const *steps = pixel == 0 ? starts.toRight : starts.down;
    double u = double(steps[0][point]), v = double(steps[1][point]);
    Vec3d turned = lane(change.R_by_u) * u + lane(change.R_by_v) * v;
    spread.origin[pixel] = lane(change.P_by_u) * u + lane(change.P_by_v) * v;
    spread.direction[pixel] = (turned - unit * dot(unit, turned)) * (1 / size);
    sum += length(spread.origin[pixel]) + length(spread.direction[pixel]);
  }
  return std::isfinite(sum);
}

//===-- Shading -------------------------------------------------------------//

void anysl::render::makeAskedRays(const RayStarts &starts, size_t first, uint32_t count,
                                  const float *P, const float *R, const float *reach, bool isShadow,
                                  AskedRays &rays) {
  if (isShadow) {
    float to[3 * AskedRays::most];
    for (uint32_t i = 0; i < count; ++i) {
      auto at = [&](const float *v, uint32_t k) { return double(v[k * count + i]); };
      double length = std::sqrt(at(R, 0) * at(R, 0) + at(R, 1) * at(R, 1) + at(R, 2) * at(R, 2));
      double scale = length > 0 ? double(reach[i]) / length : 0;
      for (uint32_t k = 0; k < 3; ++k)
        to[k * count + i] = float(at(P, k) + at(R, k) * scale);
    }
    makeShadowRays(starts, first, count, P, to, rays);
    return;
  }
  makeTraceRays(starts, first, count, P, R, rays);
  for (uint32_t i = 0; i < count; ++i) {
    rays.far[i] = std::min(rays.far[i], reach[i]);
    rays.valid[i] &= reach[i] > 0;
  }
}

void anysl::render::storeOpacity(Vec3f opacity, uint32_t i, const AnyslHits &hits) {
  for (int k = 0; k < 3; ++k)
    hits.opacity[k][i] = opacity[k];
}

void anysl::render::storeHit(const Geometry &geometry, const Hit &hit, const Ray &ray,
                             const Radiance &radiance, uint32_t i, const AnyslHits &hits) {
  for (int k = 0; k < 3; ++k)
    hits.color[k][i] = radiance.color[k];
  if (!hit.isHit())
    return;
  SurfacePoint point;
  geometry.evaluate(hit, ray.origin, ray.direction,
                    uint64_t(1) << ANYSL_N | uint64_t(1) << ANYSL_Ng, point);
  hits.distance[i] = hit.t;
  Vec3d normal = normalized(point.normal), flat = normalized(point.frame.normal);
  double side = dot(flat, Vec3d(ray.direction)) > 0 ? -1 : 1;
  double smoothSide = dot(normal, Vec3d(ray.direction)) > 0 ? -1 : 1;
  for (int k = 0; k < 3; ++k) {
    hits.N[k][i] = float(smoothSide * normal[k]);
    hits.Ng[k][i] = float(side * flat[k]);
    hits.opacity[k][i] = radiance.opacity[k];
  }
}

void anysl::render::computeAgain(ThreadState &state, const Scene &scene, const Hit &hit,
                                 const Ray &ray, const RayPath &path, uint64_t globals) {
  Arena::Scope scope(state.arena);
  float *numbers = state.arena.allocate<float>(ANYSL_COMPONENT_COUNT);
  SurfacePoint point;
  uint64_t needed = neededFor(globals);
  scene.geometry().evaluate(hit, ray.origin, ray.direction, needed, point);
  if (needed & footprintBits)
    findFootprint(scene.camera, path.depth == 0, ray, point);
  storeGlobals(globals, point, ray, ray.travelled,
               [&](int number, double value) { numbers[number] = float(value); });
}

Vec3f anysl::render::defaultSurface(const SurfacePoint &point, Vec3f direction) {
  double facing = std::fabs(dot(point.normal, Vec3d(direction)));
  return Vec3f(point.color * point.opacity * (0.1 + 0.9 * facing));
}

int anysl::render::serveSpaceMatrix(void *renderer, const Space *object, const char *from,
                                    const char *to, double matrix[16]) {
  const auto &shader = *static_cast<const Shader *>(renderer);
  Matrix4 result;
  if (shader.info && shader.info->kind == ANYSL_IMAGER) {
    from = std::string_view(from) == "current" ? "raster" : from;
    to = std::string_view(to) == "current" ? "raster" : to;
  }
  if (!shader.scene->spaces.matrix(&shader.space, object, from, to, result))
    return 0;
  for (int i = 0; i < 16; ++i)
    matrix[i] = result.m[size_t(i / 4)][size_t(i % 4)];
  return 1;
}

AnyslShadeArgs anysl::render::makeShadeArgs(const Shader &shader, const ShadingGroup &group,
                                            uint32_t count, void *batch) {
  AnyslShadeArgs args;
  anysl_instance_fill_args(shader.instance.get(), &args);
  args.count = count;
  args.batch = batch;
  args.lights = group.lights->lights.data();
  args.light_count = uint32_t(group.lights->lights.size());
  std::copy_n(group.lights->ambient, 3, args.ambient);
  args.globals_given = shader.globals | group.lights->globals;
  return args;
}

std::unique_ptr<Host> anysl::render::makeHost(const SceneDescription &description,
                                              const ShaderCache &cache, const ShaderTarget &target,
                                              Warnings &warnings) {
  return target.runtime == "scalar" ? makeScalarHost(description, cache, warnings)
                                    : makePacketHost(description, cache, target.width, warnings);
}
