//===-- tools/anysl-render/Scene.cpp - a scene ready to be rendered ---------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Scene.h"

#include <set>
#include <tuple>

using namespace anysl::render;

namespace {

/// The bit of AnyslShaderInfo::services that says that a shader asks for named spaces.
constexpr uint32_t spacesService = 1u << 3;

} // namespace

Scene::Scene(const SceneDescription &given, const ShaderCache &cache, const AnyslServices &services,
             AnyslLayout layout, unsigned width, Warnings &warnings)
    : description(given), camera(given.camera), spaces(given, camera), background(given),
      loader(*this, cache, services, layout, width, warnings) {
  loadShaders();
  makeGroups(warnings);
  surfaces = std::make_unique<Geometry>(description, camera, groupOfShape);
}

void Scene::loadShaders() {
  // Only those that some shape uses.
  std::set<int> used;
  for (const Shape &shape : description.shapes)
    used.insert(description.appearances[shape.appearance].surface);
  used.erase(-1);
  std::vector<const ShaderUse *> uses;
  for (int index : used)
    uses.push_back(&description.shaders[size_t(index)]);
  loader.open(uses);
  shaders.resize(description.shaders.size());
  for (int index : used)
    shaders[size_t(index)] = loader.make(description.shaders[size_t(index)]);
}

void Scene::makeGroups(Warnings &warnings) {
  using Key = std::tuple<int, const LightSet *, uint32_t>;
  std::map<Key, uint32_t> known;
  constexpr uint32_t anyObject = ~uint32_t(0);
  for (uint32_t i = 0; i < description.shapes.size(); ++i) {
    const Shape &shape = description.shapes[i];
    const Appearance &appearance = description.appearances[shape.appearance];
    auto [lights, isNew] = lightSets.try_emplace(appearance.lights);
    if (isNew)
      lights->second = makeLightSet(description, appearance.lights, warnings);
    const Shader *shader =
        appearance.surface < 0 ? nullptr : shaders[size_t(appearance.surface)].get();
    bool bySpace =
        shader && (shader->info->services & spacesService) != 0;
    Key key{appearance.surface, &lights->second, bySpace ? i : anyObject};
    auto [entry, isNewGroup] = known.try_emplace(key, uint32_t(groups.size()));
    if (isNewGroup)
      groups.push_back({shader, &lights->second, Space(shape.objectToCamera)});
    groupOfShape.push_back(entry->second);
  }
}
