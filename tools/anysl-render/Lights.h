//===-- tools/anysl-render/Lights.h - the standard lights and the sky -------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_LIGHTS_H
#define ANYSL_RENDER_LIGHTS_H

#include "tools/anysl-render/SceneDescription.h"

#include <anysl/abi.h>

namespace anysl::render {

/// The lights that shine on a surface, as its shader gets them.
struct LightSet {
  std::vector<AnyslLight> lights;
  float ambient[3] = {};
};

/// Translates the lights with these indices: ambientlight, distantlight, pointlight and spotlight
/// with the parameters of the RenderMan Interface's standard lights, and __nondiffuse and
/// __nonspecular. Others get a warning and are left out.
LightSet makeLightSet(const SceneDescription &scene, const std::vector<uint32_t> &indices,
                      Warnings &warnings);

/// The light from beyond all surfaces: a sky that is brighter or darker towards the world's +y.
class Background {
public:
  explicit Background(const SceneDescription &scene);
  bool isVisible() const { return visible; }
  Vec3f color(Vec3f direction) const;

private:
  bool visible;
  Vec3f up, zenith, horizon, ground;
};

} // namespace anysl::render

#endif
