//===-- tools/anysl-render/SceneEffects.h - effects that are the scene's own --------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Besides what shaders do (lib/STC/Effects.def), a scene has effects that are not in the shader
// that is seen: lights and the shadow of each, displacement, volumes, the imager, the lens.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_SCENEEFFECTS_H
#define ANYSL_RENDER_SCENEEFFECTS_H

#include "lib/Rib/SceneDescription.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace anysl::render {

struct SceneEffect {
  std::string name;             ///< "Displacement", "Lights.pointlight", "Shadows.key"
  std::set<std::string> asking; ///< "displacement \"dents\" scene.rib:7"; empty: it is dropped
  std::string whyNot;           ///< then
  /// Makes the scene one that does without it.
  std::function<void(SceneDescription &)> leaveOut;
};

/// What asks for an effect: kind "name" file:line.
std::string described(const char *kind, const std::string &name, const Location &where);

/// All such effects, those of the standard's kinds of lights included that the scene does without.
std::vector<SceneEffect> sceneEffects(const SceneDescription &scene);

} // namespace anysl::render

#endif
