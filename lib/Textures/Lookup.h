//===-- lib/Textures/Lookup.h - one filtered lookup of up to 16 points --------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEXTURES_LOOKUP_H
#define ANYSL_TEXTURES_LOOKUP_H

#include "lib/Textures/Files.h"

namespace anysl::textures {

/// The points of a lookup, as OpenImageIO takes a batch of them.
struct Batch {
  static constexpr int size = OIIO::Tex::BatchWidth;
  OIIO::Tex::RunMask mask = 0;
  alignas(OIIO::Tex::BatchAlign) float s[size] = {}, t[size] = {}, dsdx[size] = {}, dtdx[size] = {},
                                       dsdy[size] = {}, dtdy[size] = {};
  OIIO::TextureOptBatch options;

  Batch();
  /// Switches a point on. Coordinates that are no numbers leave it off; filters are kept finite.
  void set(uint32_t i, float atS, float atT, float sx, float tx, float sy, float ty, float sblur,
           float tblur);
};

/// What a lookup gives: channel c of point i is value[c * width + i], and changes with s and t by
/// what lies at the same place of byS and byT where these are not null.
struct Values {
  float *value, *byS = nullptr, *byT = nullptr;
};

/// Looks up the batch's points in a file. A request for a colour gives a grey picture's value in
/// all channels unless it has a fill.
void lookUp(Files &files, const File &file, const AnyslTextureRequest &request, Batch &batch,
            uint32_t width, const Values &result);

/// What stands for a file that cannot be read, at (s, t).
void lookUpMissing(const AnyslTextureRequest &request, float s, float t, uint32_t i, uint32_t width,
                   float *result);

} // namespace anysl::textures

#endif
