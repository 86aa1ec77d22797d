//===-- tools/anysl-render/Host.h - what the two hosts have in common -------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A host drives shaders of one runtime: it traces camera rays, shades what they hit, and serves the
// shaders' own rays, which may lead to more shading. All arithmetic that decides a pixel stands
// here, once, so that the hosts make the same picture.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_HOST_H
#define ANYSL_RENDER_HOST_H

#include "lib/Shade/Recording.h"
#include "tools/anysl-render/Footprint.h"
#include "tools/anysl-render/RayPurpose.h"
#include "tools/anysl-render/Sampling.h"

#include <immintrin.h>

namespace anysl::render {

/// Memory that is handed back in the reverse order, for the arrays of nested batches.
class Arena {
public:
  /// Everything allocated during its life is handed back at its end.
  class Scope {
  public:
    explicit Scope(Arena &arena) : arena(arena), block(arena.block), used(arena.used) {}
    ~Scope() { arena.block = block, arena.used = used; }
    Scope(const Scope &) = delete;
    Scope &operator=(const Scope &) = delete;

  private:
    Arena &arena;
    size_t block, used;
  };

  /// `count` values, not initialised, aligned to 64 bytes and padded to a multiple of that.
  template <typename T>
  T *allocate(size_t count) {
    size_t bytes = (count * sizeof(T) + 63) / 64 * 64;
    if (blocks.empty() || used + bytes > blocks[block].size)
      nextBlock(bytes);
    T *result = reinterpret_cast<T *>(blocks[block].memory.get() + used);
    used += bytes;
    return result;
  }

private:
  struct Free {
    void operator()(std::byte *memory) const { _mm_free(memory); }
  };
  struct Block {
    std::unique_ptr<std::byte[], Free> memory;
    size_t size;
  };
  void nextBlock(size_t bytes);

  std::vector<Block> blocks;
  size_t block = 0, used = 0;
};

/// What one thread has done.
struct RenderCounts {
  uint64_t cameraRays = 0, traceRays = 0, shadowRays = 0;
  uint64_t points = 0;       ///< shaded
  uint64_t shadowPoints = 0; ///< of those, points that were shaded for the sake of shadow rays
  uint64_t batches = 0;      ///< calls of a shader
  uint64_t shadingTicks = 0;
  RenderCounts &operator+=(const RenderCounts &other);
};

/// A thread's own memory and counts. Time runs for shading only while a shader does: a service
/// stops the clock when it is entered and starts it again when it returns.
struct ThreadState {
  Arena arena;
  RenderCounts counts;
  bool timed = false;
  shade::Recorder *recorder = nullptr; ///< of what shaders are called with; null: nobody asks
  std::optional<uint64_t> again;       ///< globals to compute once more (RenderOptions)

  void startShading() {
    if (timed)
      since = __rdtsc();
  }
  void stopShading() {
    if (timed)
      counts.shadingTicks += __rdtsc() - since;
  }
  void record(const Shader &shader, const ShadingGroup &group, const AnyslShadeArgs &args) const {
    if (recorder)
      recorder->add(*shader.instance, args, group.lights, shader.file);
  }

private:
  uint64_t since = 0;
};

/// Stops the shading clock as long as it lives.
class ServiceScope {
public:
  explicit ServiceScope(ThreadState &state) : state(state) { state.stopShading(); }
  ~ServiceScope() { state.startShading(); }
  ServiceScope(const ServiceScope &) = delete;
  ServiceScope &operator=(const ServiceScope &) = delete;

private:
  ThreadState &state;
};

/// The light along a camera ray, and how much of what lies beyond all surfaces is hidden.
struct Radiance {
  Vec3f color;
  Vec3f opacity;
  float alpha = 0;
};

class Host {
public:
  virtual ~Host() = default;
  /// The light along `count` camera rays, and of each the numbers of the scene's channels, which
  /// have to be clear before.
  virtual void trace(ThreadState &state, const Ray *rays, uint32_t count, Radiance *radiance,
                     float *channels) const = 0;
  /// How many rays trace() likes to get at once.
  virtual uint32_t preferredCount() const = 0;
  virtual const Scene &scene() const = 0;
};

/// The host for structure-of-arrays libraries, with packets of 1, 4, 8 or 16 rays.
std::unique_ptr<Host> makePacketHost(const SceneDescription &description, const ShaderCache &cache,
                                     unsigned width, Warnings &warnings);
/// The host for array-of-structures libraries, float or double: one ray and one point at a time.
std::unique_ptr<Host> makeScalarHost(const SceneDescription &description, const ShaderCache &cache,
                                     Warnings &warnings);
/// The host of a target's runtime. The scalar runtime is known by its name; any other is taken for
/// one of packets, and refused if its libraries say otherwise.
std::unique_ptr<Host> makeHost(const SceneDescription &description, const ShaderCache &cache,
                               const ShaderTarget &target, Warnings &warnings);

//===-- Shared arithmetic ---------------------------------------------------//

/// The number mixed into a ray's seed where it goes on behind a surface.
constexpr uint32_t behindSurface = 0x62656864;
/// The number mixed into the seeds of points that a volume shader works on.
constexpr uint32_t throughVolume = 0x766f6c75;
/// The number mixed into the seeds of shadow rays: all of a point have one, so that it does not
/// matter which of them are asked for.
constexpr uint32_t towardsLight = 0x73686164;
/// What every batch of points has, whether its shader names it or not.
constexpr uint64_t colorOutputs = uint64_t(1) << ANYSL_Ci | uint64_t(1) << ANYSL_Oi;

/// What is kept of shaded points for the rays that start there, one array for each number.
struct RayStarts {
  float *P[3], *Ng[3], *lift[3];
  float *offset;
  float *toRight[2], *down[2]; ///< where a footprint was asked for

  RayStarts(Arena &arena, size_t count);
  void set(size_t i, const SurfacePoint &point);
  /// The ray that goes on behind point i, which it met at distance t.
  Ray behind(size_t i, const Ray &ray, float t, const ShadingGroup &group) const;
  /// The volume that a ray starts in that leaves point i on the side of `direction`.
  const Shader *medium(size_t i, Vec3f direction, const ShadingGroup &group) const;
};

/// Rays that shaders ask for, up to 16 at once, one array for each number.
struct AskedRays {
  static constexpr uint32_t most = 16;
  alignas(64) float origin[3][most], direction[3][most], far[most];
  alignas(64) uint32_t valid[most]; ///< 0 where there is no ray to trace

  Ray ray(uint32_t i, uint32_t seed) const {
    return {{origin[0][i], origin[1][i], origin[2][i]},
            {direction[0][i], direction[1][i], direction[2][i]},
            0,
            far[i],
            seed,
            0,
            nullptr};
  }
};

/// The rays for trace(P, R) from the points first, first + 1, ...; vectors lie as x[count] y[count]
/// z[count]. A ray that starts at its point, as nearly all do, starts a little off the surface on
/// the side that R leads to, so far that it cannot meet the surface where it starts. None is valid
/// where R is no direction.
void makeTraceRays(const RayStarts &starts, size_t first, uint32_t count, const float *P,
                   const float *R, AskedRays &rays);
/// The rays for transmission(from, to), either of which may be the point itself. None is valid
/// where both are the same.
void makeShadowRays(const RayStarts &starts, size_t first, uint32_t count, const float *from,
                    const float *to, AskedRays &rays);

/// The rays for a service that gives AnyslHits: shadow rays or others, each of which ends at its
/// reach.
void makeAskedRays(const RayStarts &starts, size_t first, uint32_t count, const float *P,
                   const float *R, const float *reach, bool isShadow, AskedRays &rays);

/// How the ray that was made for direction number i differs from its neighbours, which a shader
/// says for a point by u and v. False, and nothing to be relied on, where it is not finite.
bool spreadRay(const RayStarts &starts, size_t point, const AskedRays &rays, uint32_t i,
               const float *const R[3], const AnyslRayDerivatives &change, RaySpread &spread);

/// What ray i has met, for a shader: nothing is stored where it met nothing, but for what arrives.
void storeHit(const Geometry &geometry, const Hit &hit, const Ray &ray, const Radiance &radiance,
              uint32_t i, const AnyslHits &hits);

/// Stores how much is hidden of what lies along ray i, of which nothing else is known.
void storeOpacity(Vec3f opacity, uint32_t i, const AnyslHits &hits);
/// Whether rays are not traced beyond the deepest level: from there comes no light, and what they
/// would meet is of no interest.
inline bool endsAtDepth(const RayPurpose &purpose, const AnyslHits &hits) {
  return hits.shades == ANYSL_SHADE_ALL ||
         (hits.shades == ANYSL_SHADE_FIRST && purpose.path.kind == RayKind::Diffuse);
}

/// How much of a shadow ray's light a surface lets pass whose shader makes it so opaque. What is no
/// number hides all.
inline Vec3f passedBy(Vec3f opacity) {
  auto passed = [](float o) { return o < 1 ? 1 - std::max(o, 0.0f) : 0; };
  return {passed(opacity.x), passed(opacity.y), passed(opacity.z)};
}
/// The same where no shader is run for it.
inline Vec3f passedAt(const Geometry &geometry, const ShadingGroup &group, const Hit &hit,
                      Vec3f origin, Vec3f direction) {
  Vec3d opacity = geometry.opacityAt(hit, origin, direction);
  // As if the shader had stored it.
  return group.shadowByShader ? passedBy(Vec3f(opacity)) : Vec3f(Vec3d(1) - opacity);
}

/// Hands every component of the globals in `wanted` to store(component, value); I comes from where
/// the ray has travelled `travelled` before.
template <typename Store>
void storeGlobals(uint64_t wanted, const SurfacePoint &point, const Ray &ray, float travelled,
                  const Store &store) {
  auto asks = [&](AnyslGlobal global) { return (wanted >> global & 1) != 0; };
  auto triple = [&](AnyslGlobal global, int component, Vec3d value) {
    if (asks(global))
      for (int k = 0; k < 3; ++k)
        store(component + k, value[k]);
  };
  auto number = [&](AnyslGlobal global, int component, double value) {
    if (asks(global))
      store(component, value);
  };
  triple(ANYSL_P, ANYSL_COMPONENT_P, point.frame.P);
  triple(ANYSL_N, ANYSL_COMPONENT_N, point.normal);
  triple(ANYSL_Ng, ANYSL_COMPONENT_Ng, point.frame.normal);
  triple(ANYSL_I, ANYSL_COMPONENT_I,
         point.frame.P - Vec3d(ray.origin) + Vec3d(ray.direction) * double(travelled));
  triple(ANYSL_Cs, ANYSL_COMPONENT_Cs, point.color);
  triple(ANYSL_Os, ANYSL_COMPONENT_Os, point.opacity);
  triple(ANYSL_Ci, ANYSL_COMPONENT_Ci, Vec3d());
  triple(ANYSL_Oi, ANYSL_COMPONENT_Oi, point.opacity);
  number(ANYSL_u, ANYSL_COMPONENT_u, point.frame.u);
  number(ANYSL_v, ANYSL_COMPONENT_v, point.frame.v);
  number(ANYSL_s, ANYSL_COMPONENT_s, point.s);
  number(ANYSL_t, ANYSL_COMPONENT_t, point.t);
  triple(ANYSL_dPdu, ANYSL_COMPONENT_dPdu, point.frame.dPdu);
  triple(ANYSL_dPdv, ANYSL_COMPONENT_dPdv, point.frame.dPdv);
  number(ANYSL_du, ANYSL_COMPONENT_du, point.du);
  number(ANYSL_dv, ANYSL_COMPONENT_dv, point.dv);
  number(ANYSL_dsdu, ANYSL_COMPONENT_dsdu, point.dsdu);
  number(ANYSL_dsdv, ANYSL_COMPONENT_dsdv, point.dsdv);
  number(ANYSL_dtdu, ANYSL_COMPONENT_dtdu, point.dtdu);
  number(ANYSL_dtdv, ANYSL_COMPONENT_dtdv, point.dtdv);
  triple(ANYSL_dNdu, ANYSL_COMPONENT_dNdu, point.dNdu);
  triple(ANYSL_dNdv, ANYSL_COMPONENT_dNdv, point.dNdv);
  triple(ANYSL_dIdu, ANYSL_COMPONENT_dIdu, point.dIdu);
  triple(ANYSL_dIdv, ANYSL_COMPONENT_dIdv, point.dIdv);
  triple(ANYSL_dNgdu, ANYSL_COMPONENT_dNgdu, point.dNgdu);
  triple(ANYSL_dNgdv, ANYSL_COMPONENT_dNgdv, point.dNgdv);
  triple(ANYSL_dCsdu, ANYSL_COMPONENT_dCsdu, point.dCsdu);
  triple(ANYSL_dCsdv, ANYSL_COMPONENT_dCsdv, point.dCsdv);
  triple(ANYSL_dOsdu, ANYSL_COMPONENT_dOsdu, point.dOsdu);
  triple(ANYSL_dOsdv, ANYSL_COMPONENT_dOsdv, point.dOsdv);
  number(ANYSL_alpha, ANYSL_COMPONENT_alpha, 1);
}

/// The same for the globals that are the same everywhere.
template <typename Store>
void storeUniformGlobals(uint64_t wanted, const Scene &scene, const Store &store) {
  auto number = [&](AnyslGlobal global, int component, double value) {
    if (wanted >> global & 1)
      store(component, value);
  };
  number(ANYSL_time, ANYSL_COMPONENT_time, scene.description.camera.shutterOpen);
  number(ANYSL_ncomps, ANYSL_COMPONENT_ncomps, 3);
  for (int k = 0; k < 3; ++k)
    number(ANYSL_E, ANYSL_COMPONENT_E + k, 0);
}

/// Computes some globals of a hit into memory that nobody looks at, as hosts do before they shade.
void computeAgain(ThreadState &state, const Scene &scene, const Hit &hit, const Ray &ray,
                  const RayPath &path, uint64_t globals);

/// The surface that shows where a scene names none: lit from the eye.
Vec3f defaultSurface(const SurfacePoint &point, Vec3f direction);

/// The service space_matrix; `renderer` is the Shader, `object` may be null.
int serveSpaceMatrix(void *renderer, const Space *object, const char *from, const char *to,
                     double matrix[16]);

/// The common part of what a shader of a group is called with.
AnyslShadeArgs makeShadeArgs(const Shader &shader, const ShadingGroup &group, uint32_t count,
                             void *batch);

/// Adds what is known of a camera ray's point to the numbers of its channels. `passing` is how much
/// of the point's light arrives, `nearest` whether no surface before it counts.
/// value(component) gives a global's number, output(number, k) that of one of the shader's outputs.
template <typename Value, typename Output>
void storeChannels(const Channels &channels, const Shader *shader, double depth, Vec3f passing,
                   bool nearest, float *numbers, const Value &value, const Output &output) {
  static constexpr int firstComponent[] = {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) ANYSL_COMPONENT_##name,
#include <anysl/Globals.def>
  };
  for (const Channel &channel : channels.list()) {
    float *target = numbers + channel.first;
    if (channel.source == Channel::Depth && nearest)
      *target = float(depth);
    for (unsigned k = 0; channel.source == Channel::Global && nearest && k < channel.components;
         ++k)
      target[k] = value(firstComponent[channel.global] + int(k));
  }
  for (size_t i = 0; shader && i < shader->outputs.size(); ++i) {
    const Channel &channel = channels.list()[shader->outputs[i].channel];
    for (unsigned k = 0; k < channel.components; ++k) {
      if (channel.isLight())
        numbers[channel.first + k] += passing[int(k)] * output(i, k);
      else if (nearest)
        numbers[channel.first + k] = output(i, k);
    }
  }
}

} // namespace anysl::render

#endif
