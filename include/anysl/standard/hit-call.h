//===-- anysl/standard/hit-call.h - how a runtime asks what rays meet first -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A function of the runtime's own that stays a call, whose numbers come and go by address: widened,
// each is an array with one element a lane, which is how AnyslServices::trace_hit wants them.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_HIT_CALL_H
#define ANYSL_STANDARD_HIT_CALL_H

#include <anysl/standard/alike.h>
#include <anysl/standard/ray-change.h>

#define ANYSL_HIT_BARE_PARAMETERS                                                                  \
  const AnyslShadeArgs *args, uint32_t point, uint32_t shades, const char *const *kind,            \
      const char *const *subset, const char *const *sides, const float *px, const float *py,       \
      const float *pz, const float *rx, const float *ry, const float *rz, const float *reach,      \
      float *distance, float *nx, float *ny, float *nz, float *gx, float *gy, float *gz,           \
      float *red, float *green, float *blue, float *opaqueRed, float *opaqueGreen,                 \
      float *opaqueBlue
#define ANYSL_HIT_BARE_ARGUMENTS                                                                   \
  args, point, shades, kind, subset, sides, px, py, pz, rx, ry, rz, reach, distance, nx, ny, nz,   \
      gx, gy, gz, red, green, blue, opaqueRed, opaqueGreen, opaqueBlue
/// The same in the vector function ABI's letters: uniform, linear, and addresses of lanes.
#define ANYSL_HIT_BARE_LETTERS "ulul8l8l8l4l4l4l4l4l4l4l4l4l4l4l4l4l4l4l4l4l4l4l4"

// Where numbers carry derivatives, the ray's go along.
#ifdef ANYSL_REAL_HAS_DERIVATIVES
#define ANYSL_HIT_PARAMETERS ANYSL_HIT_BARE_PARAMETERS, ANYSL_CHANGE_PARAMETERS
#define ANYSL_HIT_ARGUMENTS ANYSL_HIT_BARE_ARGUMENTS, ANYSL_CHANGE_ARGUMENTS
#define ANYSL_HIT_LETTERS ANYSL_HIT_BARE_LETTERS ANYSL_CHANGE_LETTERS
#else
#define ANYSL_HIT_PARAMETERS ANYSL_HIT_BARE_PARAMETERS
#define ANYSL_HIT_ARGUMENTS ANYSL_HIT_BARE_ARGUMENTS
#define ANYSL_HIT_LETTERS ANYSL_HIT_BARE_LETTERS
#endif

namespace anysl {

/// Serves the points of `mask`, of `width` from `point` on: those whose rays are alike by one call
/// of the renderer; `change` and `values` may be null.
inline void askForHits(ANYSL_HIT_BARE_PARAMETERS, const AnyslRayDerivatives *change, uint32_t width,
                       uint32_t mask, AnyslMessage *values = nullptr) {
  AnyslHits hits = {sizeof(AnyslHits),
                    shades,
                    distance,
                    {nx, ny, nz},
                    {gx, gy, gz},
                    {red, green, blue},
                    {opaqueRed, opaqueGreen, opaqueBlue},
                    values,
                    change,
                    "",
                    "",
                    ""};
  for (uint32_t i = 0; i < width; ++i) {
    distance[i] = -1;
    for (uint32_t c = 0; c < 3; ++c)
      hits.N[c][i] = hits.Ng[c][i] = hits.color[c][i] = hits.opacity[c][i] = 0;
  }
  const float *const P[3] = {px, py, pz}, *const R[3] = {rx, ry, rz};
  if (!args->services->trace_hit)
    return;
  while (mask) {
    uint32_t lead = uint32_t(__builtin_ctz(mask));
    uint32_t group = likeFirst(mask, width, kind, subset, sides);
    mask &= ~group;
    hits.kind = orEmpty(kind[lead]);
    hits.subset = orEmpty(subset[lead]);
    hits.sides = orEmpty(sides[lead]);
    args->services->trace_hit(args->renderer, args, point, width, group, P, R, reach, &hits);
  }
}

/// The same for what a runtime's own function is called with.
inline void askForHits(ANYSL_HIT_PARAMETERS, uint32_t width, uint32_t mask) {
#ifdef ANYSL_REAL_HAS_DERIVATIVES
  AnyslRayDerivatives derivatives = rayDerivatives(ANYSL_CHANGE_ARGUMENTS);
  const AnyslRayDerivatives *change = anysl_rays_carry_derivatives ? &derivatives : nullptr;
#else
  const AnyslRayDerivatives *change = nullptr;
#endif
  askForHits(ANYSL_HIT_BARE_ARGUMENTS, change, width, mask);
}

} // namespace anysl

#endif // ANYSL_STANDARD_HIT_CALL_H
