//===-- anysl/standard/texture-call.h - how a runtime asks for pictures -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A lookup is a function of the runtime's own that stays a call. Every number and text comes by
// address: widened, each is an array with one element a lane, which is how AnyslTexturePoints wants
// them, so that one function serves one point and many.
//
// Where numbers carry derivatives, the call has nine results more: how each channel changes with
// each coordinate. The renderer is asked for them only where one of them is read in the end.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_TEXTURE_CALL_H
#define ANYSL_STANDARD_TEXTURE_CALL_H

#include <anysl/standard/alike.h>
#include <anysl/standard/context.h>

// How r changes with x, y and z, then g and b.
#ifdef ANYSL_REAL_HAS_DERIVATIVES
#define ANYSL_SLOPE_PARAMETERS                                                                     \
  , float *rByX, float *rByY, float *rByZ, float *gByX, float *gByY, float *gByZ, float *bByX,     \
      float *bByY, float *bByZ
#define ANYSL_SLOPE_ARGUMENTS , rByX, rByY, rByZ, gByX, gByY, gByZ, bByX, bByY, bByZ
#define ANYSL_SLOPE_ADDRESSES , &rByX, &rByY, &rByZ, &gByX, &gByY, &gByZ, &bByX, &bByY, &bByZ
#define ANYSL_SLOPES                                                                               \
  {rByX, rByY, rByZ}, {gByX, gByY, gByZ}, { bByX, bByY, bByZ }
#define ANYSL_SLOPE_LETTERS "l4l4l4l4l4l4l4l4l4"
#else
#define ANYSL_SLOPE_PARAMETERS
#define ANYSL_SLOPE_ARGUMENTS
#define ANYSL_SLOPE_ADDRESSES
#define ANYSL_SLOPES
#define ANYSL_SLOPE_LETTERS ""
#endif

#define ANYSL_TEXTURE_PARAMETERS                                                                   \
  const AnyslShadeArgs *args, uint32_t point, uint32_t query, const char *const *name,             \
      const char *const *filter, const char *const *swrap, const char *const *twrap,               \
      const float *channel, const float *fill, const float *bias, const float *samples,            \
      const float *x, const float *y, const float *z, const float *xByU, const float *yByU,        \
      const float *zByU, const float *xByV, const float *yByV, const float *zByV,                  \
      const float *sblur, const float *tblur, float *r, float *g, float *b ANYSL_SLOPE_PARAMETERS
#define ANYSL_TEXTURE_ARGUMENTS                                                                    \
  args, point, query, name, filter, swrap, twrap, channel, fill, bias, samples, x, y, z, xByU,     \
      yByU, zByU, xByV, yByV, zByV, sblur, tblur, r, g, b ANYSL_SLOPE_ARGUMENTS
/// The same in the vector function ABI's letters: uniform, linear, and addresses of lanes.
#define ANYSL_TEXTURE_LETTERS "ulul8l8l8l8l4l4l4l4l4l4l4l4l4l4l4l4l4l4l4l4l4l4" ANYSL_SLOPE_LETTERS

/// `query` where something is read of what a lookup puts to those addresses, else 0: the linker
/// knows.
extern "C" __attribute__((const)) uint32_t
anysl_derivative_texture(uint32_t query ANYSL_SLOPE_PARAMETERS);

namespace anysl {

/// What `query` says: the kind of picture, and how many channels are asked for.
enum TextureKind : uint32_t { flatTexture = 0, environmentTexture = 1, shadowTexture = 2 };
constexpr uint32_t textureQuery(TextureKind kind, uint32_t channels) {
  return kind | channels << 8;
}
/// Added to a query that asks for slopes as well.
constexpr uint32_t slopesQuery = 1 << 16;

/// Serves the points of `mask`, of `width` from `point` on: those that ask the same of the same
/// file by one call of the renderer.
inline void askForTextures(ANYSL_TEXTURE_PARAMETERS, uint32_t width, uint32_t mask) {
  float *const slopes[3][3] = {ANYSL_SLOPES};
  bool asksForSlopes = query & slopesQuery;
  for (uint32_t i = 0; i < width; ++i) {
    r[i] = g[i] = b[i] = 0;
    for (uint32_t k = 0; asksForSlopes && k < 9; ++k)
      slopes[k / 3][k % 3][i] = 0;
  }
  uint32_t kind = query & 0xff;
  AnyslTextureService *service = kind == flatTexture          ? args->services->texture
                                 : kind == environmentTexture ? args->services->environment
                                                              : args->services->shadow;
  if (!service)
    return;
  AnyslTexturePoints points = {sizeof(AnyslTexturePoints), {x, y, z},      {xByU, yByU, zByU},
                               {xByV, yByV, zByV},         {sblur, tblur}, {}};
  alignas(64) float resultBy[3][3 * 16];
  for (uint32_t k = 0; asksForSlopes && k < 3; ++k)
    points.result_by[k] = resultBy[k];
  while (mask) {
    uint32_t lead = uint32_t(__builtin_ctz(mask));
    uint32_t group =
        likeFirst(mask, width, channel, fill, bias, samples, name, filter, swrap, twrap);
    mask &= ~group;
    auto count = [](float n) { return n > 0 && n < 1e6f ? uint32_t(n) : 0u; };
    AnyslTextureRequest request = {sizeof(AnyslTextureRequest),
                                   query >> 8 & 0xff,
                                   count(channel[lead]),
                                   count(samples[lead]),
                                   orEmpty(name[lead]),
                                   orEmpty(filter[lead]),
                                   orEmpty(swrap[lead]),
                                   orEmpty(twrap[lead]),
                                   fill[lead],
                                   bias[lead]};
    alignas(64) float result[3 * 16] = {};
    if (asksForSlopes)
      __builtin_memset(resultBy, 0, sizeof resultBy);
    service(args->renderer, args, point, width, group, &request, &points, result);
    for (uint32_t i = 0; i < width; ++i) {
      bool has = group >> i & 1, hasColor = has && request.channels > 1;
      r[i] = has ? result[i] : r[i];
      g[i] = hasColor ? result[width + i] : g[i];
      b[i] = hasColor ? result[2 * width + i] : b[i];
    }
    for (uint32_t i = lead; asksForSlopes && i < width; ++i)
      if (group >> i & 1)
        for (uint32_t c = 0; c < request.channels; ++c)
          for (uint32_t k = 0; k < 3; ++k)
            slopes[c][k][i] = resultBy[k][c * width + i];
  }
}

} // namespace anysl

#endif // ANYSL_STANDARD_TEXTURE_CALL_H
