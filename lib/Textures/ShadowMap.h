//===-- lib/Textures/ShadowMap.h - pictures of depths -------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEXTURES_SHADOWMAP_H
#define ANYSL_TEXTURES_SHADOWMAP_H

#include "lib/Textures/Lookup.h"

namespace anysl::textures {

/// A picture whose first channel is the distance, along the light's axis, of the nearest surface.
/// How much of a filter is in shadow is the share of depths in it that are nearer than the point
/// (percentage closer filtering; Reeves, Salesin, Cook: "Rendering Antialiased Shadows with Depth
/// Maps", 1987). The depths are compared on a grid, which is the same for every point.
class ShadowMap {
public:
  /// Nothing, with a warning, if the file does not say from where it was made. The renderer of
  /// `args` says where its "current" space lies in the world.
  static std::optional<ShadowMap> open(Files &files, const File &file,
                                       const AnyslTextureRequest &request,
                                       const AnyslShadeArgs *args);

  float shadowAt(const AnyslTexturePoints &points, uint32_t i);

private:
  using Matrix = std::array<double, 16>;
  struct Projected {
    double s, t, depth;
    bool isInside; ///< in front of the light
  };

  ShadowMap(Files &files, const File &file, const AnyslTextureRequest &request)
      : files(files), file(file), request(request) {}
  Projected project(double x, double y, double z) const;

  Files &files;
  const File &file;
  const AnyslTextureRequest &request;
  Matrix toCamera, toScreen;
};

} // namespace anysl::textures

#endif
