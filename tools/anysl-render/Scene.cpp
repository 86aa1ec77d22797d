//===-- tools/anysl-render/Scene.cpp - a scene ready to be rendered ---------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Scene.h"

#include "tools/anysl-render/Pictures.h"

#include <algorithm>
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
      textures(makePictures(given)), loader(*this, cache, layout, width, warnings),
      lights(given, cache, warnings) {
  loadShaders(services, warnings);
  makeGroups(warnings);
  surfaces = std::make_unique<Geometry>(description, camera, groupOfShape);
}

void Scene::loadShaders(const AnyslServices &services, Warnings &warnings) {
  // Only those that some shape uses.
  std::set<int> used;
  for (const Shape &shape : description.shapes) {
    const Appearance &appearance = description.appearances[shape.appearance];
    used.insert(
        {appearance.surface, appearance.atmosphere, appearance.interior, appearance.exterior});
  }
  used.insert(description.imager);
  used.erase(-1);
  std::vector<const ShaderUse *> uses;
  for (int index : used)
    uses.push_back(&description.shaders[size_t(index)]);
  uses.insert(uses.end(), lights.shaders().begin(), lights.shaders().end());
  loader.open(uses);
  lights.load(loader, services);
  imagerServices.struct_size = sizeof imagerServices;
  imagerServices.space_matrix = services.space_matrix;
  imagerServices.texture = serveTexture;
  imagerServices.environment = serveEnvironment;
  imagerServices.shadow = serveShadow;
  shaders.resize(description.shaders.size());
  for (int index : used) {
    const ShaderUse &use = description.shaders[size_t(index)];
    shaders[size_t(index)] =
        loader.make(use, use.kind == ShaderKind::Imager ? imagerServices : services);
  }
  wantedChannels = Channels(description, shaders, warnings);
}

const Shader *Scene::imager() const {
  return description.imager < 0 ? nullptr : shaders[size_t(description.imager)].get();
}

void Scene::makeGroups(Warnings &warnings) {
  using Key = std::tuple<std::array<int, 5>, const LightSet *, uint32_t>;
  std::map<Key, uint32_t> known;
  constexpr uint32_t anyObject = ~uint32_t(0);
  auto shaderOf = [&](int index) { return index < 0 ? nullptr : shaders[size_t(index)].get(); };
  for (uint32_t i = 0; i < description.shapes.size(); ++i) {
    const Shape &shape = description.shapes[i];
    const Appearance &appearance = description.appearances[shape.appearance];
    auto [set, isNew] = lightSets.try_emplace(appearance.lights);
    if (isNew)
      set->second = lights.set(appearance.lights, warnings);
    std::array<int, 5> indices{appearance.surface, appearance.atmosphere, appearance.interior,
                               appearance.exterior, appearance.matte};
    bool bySpace = std::any_of(indices.begin(), indices.end() - 1, [&](int index) {
      return shaderOf(index) && (shaderOf(index)->info->services & spacesService) != 0;
    });
    Key key{indices, &set->second, bySpace ? i : anyObject};
    auto [entry, isNewGroup] = known.try_emplace(key, uint32_t(groups.size()));
    if (isNewGroup)
      groups.push_back({shaderOf(indices[0]), shaderOf(indices[1]), shaderOf(indices[2]),
                        shaderOf(indices[3]), &set->second, Space(shape.objectToCamera),
                        appearance.matte});
    groupOfShape.push_back(entry->second);
  }
}
