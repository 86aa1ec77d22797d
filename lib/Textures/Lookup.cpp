//===-- lib/Textures/Lookup.cpp - one filtered lookup of up to 16 points ------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Textures/Lookup.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace anysl::textures {
namespace {

/// Half a picture: a wider filter gives the picture's mean.
float limited(float x, float most) { return std::isfinite(x) ? std::clamp(x, -most, most) : 0; }

OIIO::Tex::InterpMode interpolation(const char *filter) {
  auto is = [filter](const char *name) { return std::strcmp(filter, name) == 0; };
  if (is("closest") || is("point") || is("nearest"))
    return OIIO::Tex::InterpMode::Closest;
  if (is("bicubic") || is("catmull-rom") || is("b-spline") || is("bspline"))
    return OIIO::Tex::InterpMode::Bicubic;
  return OIIO::Tex::InterpMode::Bilinear;
}

OIIO::Tex::Wrap wrapMode(const char *name) {
  return *name ? OIIO::Tex::decode_wrapmode(name) : OIIO::Tex::Wrap::Default;
}

bool hasFill(const AnyslTextureRequest &request) { return request.fill < ANYSL_NO_FILL; }

} // namespace

Batch::Batch() {
  std::fill_n(options.sblur, size, 0.0f);
  std::fill_n(options.tblur, size, 0.0f);
  std::fill_n(options.rblur, size, 0.0f);
  std::fill_n(options.swidth, size, 1.0f);
  std::fill_n(options.twidth, size, 1.0f);
  std::fill_n(options.rwidth, size, 1.0f);
}

void Batch::set(uint32_t i, float atS, float atT, float sx, float tx, float sy, float ty,
                float sblur, float tblur) {
  if (!(std::fabs(atS) < 1e9f) || !(std::fabs(atT) < 1e9f))
    return;
  mask |= OIIO::Tex::RunMask(1) << i;
  s[i] = atS, t[i] = atT;
  dsdx[i] = limited(sx, 1), dtdx[i] = limited(tx, 1);
  dsdy[i] = limited(sy, 1), dtdy[i] = limited(ty, 1);
  options.sblur[i] = std::max(limited(sblur, 1), 0.0f);
  options.tblur[i] = std::max(limited(tblur, 1), 0.0f);
}

void lookUp(Files &files, const File &file, const AnyslTextureRequest &request, Batch &batch,
            uint32_t width, const Values &result) {
  OIIO::TextureSystem &system = files.system();
  bool isGrey = request.channels == 3 && request.first_channel == 0 && file.channels < 3;
  uint32_t channels = isGrey && !hasFill(request) ? 1 : request.channels;
  bool isThere = request.first_channel < uint32_t(file.channels);
  batch.options.firstchannel = int(request.first_channel);
  batch.options.fill = hasFill(request) ? request.fill : 0;
  batch.options.interpmode = interpolation(request.filter);
  batch.options.swrap = wrapMode(request.swrap);
  batch.options.twrap = wrapMode(request.twrap);
  struct alignas(OIIO::Tex::BatchAlign) Channels {
    float of[3 * Batch::size] = {};
  } values, byS, byT;
  // The nearest texel's value has none, and OpenImageIO leaves them as they are.
  bool wantsSlopes = result.byS && batch.options.interpmode != OIIO::Tex::InterpMode::Closest;
  if (!isThere)
    std::fill_n(values.of, std::size(values.of), batch.options.fill);
  else if (batch.mask &&
           !system.texture(file.handle, system.get_perthread_info(), batch.options, batch.mask,
                           batch.s, batch.t, batch.dsdx, batch.dtdx, batch.dsdy, batch.dtdy,
                           int(channels), values.of, wantsSlopes ? byS.of : nullptr,
                           wantsSlopes ? byT.of : nullptr))
    files.warnOnce("cannot read texture '" + std::string(request.name) + "': " + system.geterror());
  auto hand = [&](const Channels &from, float *to) {
    for (uint32_t c = 0; to && c < request.channels; ++c)
      for (uint32_t i = 0; i < width; ++i)
        to[c * width + i] = from.of[std::min(c, channels - 1) * Batch::size + i];
  };
  hand(values, result.value);
  hand(byS, result.byS);
  hand(byT, result.byT);
}

void lookUpMissing(const AnyslTextureRequest &request, float s, float t, uint32_t i, uint32_t width,
                   float *result) {
  constexpr float magenta[] = {1, 0, 1};
  bool finite = std::fabs(s) < 1e6f && std::fabs(t) < 1e6f;
  bool dark = finite && (int(std::floor(8 * s)) + int(std::floor(8 * t))) % 2 != 0;
  for (uint32_t c = 0; c < request.channels; ++c) {
    uint32_t channel = request.first_channel + c;
    float checker = dark || channel > 2 ? 0 : magenta[channel];
    result[c * width + i] = hasFill(request) ? request.fill : checker;
  }
}

} // namespace anysl::textures
