//===-- tools/anysl-render/SceneEffects.cpp - effects that are the scene's own ----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/SceneEffects.h"

#include "lib/Demand/Demand.h"
#include "lib/Demand/Json.h"

#include <map>

namespace anysl::render {

std::string described(const char *kind, const std::string &name, const Location &where) {
  std::string place = demand::placeOf(where);
  return std::string(kind) + " \"" + name + "\"" + (place.empty() ? "" : " " + place);
}

namespace {

/// Shaders of some kind that shapes use.
SceneEffect shaderEffect(const SceneDescription &scene, const char *name,
                         std::vector<int Appearance::*> kinds) {
  SceneEffect effect{name, {}, "no shape has such a shader", {}};
  for (const Shape &shape : scene.shapes)
    for (int Appearance::*kind : kinds)
      if (int index = scene.appearances[shape.appearance].*kind; index >= 0)
        effect.asking.insert(
            described("shader", scene.shaders[index].name, scene.shaders[index].where));
  effect.leaveOut = [kinds](SceneDescription &other) {
    for (Appearance &appearance : other.appearances)
      for (int Appearance::*kind : kinds)
        appearance.*kind = -1;
  };
  return effect;
}

/// Each kind of light, and the shadows of each light.
void addLights(const SceneDescription &scene, std::vector<SceneEffect> &effects) {
  std::map<std::string, SceneEffect> kinds;
  kinds[std::string(demand::ambientLight)];
#define ANYSL_STANDARD_LIGHT(id, name, word, source, absence) kinds[source];
#include <anysl/LightKinds.def>
  std::vector<SceneEffect> shadows;
  for (uint32_t index : demand::usedLights(scene)) {
    const LightUse &light = scene.lights[index];
    std::string place = described("light", light.handle, light.where);
    kinds[light.name].asking.insert(place);
    SceneEffect shadow{"Shadows." + light.handle, {}, "the light casts none", {}};
    if (light.castsShadow && light.name != demand::ambientLight)
      shadow.asking.insert(place);
    shadow.leaveOut = [index](SceneDescription &other) { other.lights[index].castsShadow = false; };
    shadows.push_back(std::move(shadow));
  }
  for (auto &[kind, effect] : kinds) {
    effect.name = "Lights." + kind;
    effect.whyNot = "no such light shines on a shape";
    effect.leaveOut = [kind = kind](SceneDescription &other) {
      for (Appearance &appearance : other.appearances)
        std::erase_if(appearance.lights,
                      [&](uint32_t light) { return other.lights[light].name == kind; });
    };
    effects.push_back(std::move(effect));
  }
  std::move(shadows.begin(), shadows.end(), std::back_inserter(effects));
}

} // namespace

std::vector<SceneEffect> sceneEffects(const SceneDescription &scene) {
  std::vector<SceneEffect> effects;
  addLights(scene, effects);
  effects.push_back(shaderEffect(scene, "Displacement", {&Appearance::displacement}));
  effects.push_back(shaderEffect(
      scene, "Volumes", {&Appearance::atmosphere, &Appearance::interior, &Appearance::exterior}));

  SceneEffect &imager = effects.emplace_back("Imager", std::set<std::string>(), "there is none",
                                             [](SceneDescription &other) { other.imager = -1; });
  if (scene.imager >= 0)
    imager.asking.insert(
        described("shader", scene.shaders[scene.imager].name, scene.shaders[scene.imager].where));

  SceneEffect &lens =
      effects.emplace_back("DepthOfField", std::set<std::string>(), "the lens is a point",
                           [](SceneDescription &other) { other.camera.lensRadius = 0; });
  if (scene.camera.lensRadius > 0)
    lens.asking.insert("a lens of radius " + demand::shortest(scene.camera.lensRadius));

  // What moves is seen as it is when the shutter opens.
  effects.emplace_back("MotionBlur", std::set<std::string>(),
                       "pictures are of the moment when the shutter opens",
                       [](SceneDescription &) {});
  return effects;
}

} // namespace anysl::render
