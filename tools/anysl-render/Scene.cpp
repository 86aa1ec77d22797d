//===-- tools/anysl-render/Scene.cpp - a scene ready to be rendered ---------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Scene.h"
#include "tools/anysl-render/Displacement.h"
#include "tools/anysl-render/FaceValues.h"

#include "tools/anysl-render/Pictures.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace stc = anysl::stc;
using namespace anysl::render;

Scene::Scene(const SceneDescription &given, const ShaderCache &cache, const AnyslServices &services,
             AnyslLayout layout, unsigned width, Warnings &warnings)
    : description(given), camera(given.camera), spaces(given, camera), background(given),
      textures(makePictures(given)), loader(*this, description, cache, layout, width, warnings),
      lights(given, cache, warnings) {
  loadShaders(cache, services, warnings);
  splitShapes();
  makeGroups(services, warnings);
  displacements.resize(description.shapes.size());
  auto move = [&](uint32_t index, DisplacedSurface surface) {
    const Shape &shape = description.shapes[index];
    int number = description.appearances[shape.appearance].displacement;
    ShapeBindings found = bind(shape, *shaders[size_t(number)], warnings);
    const Shader &shader = *specialise(number, found.constant, displacementServices, warnings);
    displacements[index] = &shader;
    std::visit([&](auto *moved) { displace(*this, shader, found.varying, shape, layout, *moved); },
               surface);
  };
  surfaces = std::make_unique<Geometry>(description, camera, groupOfShape, move);
}

void Scene::loadShaders(const ShaderCache &cache, const AnyslServices &services,
                        Warnings &warnings) {
  // Only those that some shape uses.
  std::set<int> used;
  for (const Shape &shape : description.shapes) {
    const Appearance &appearance = description.appearances[shape.appearance];
    used.insert({appearance.surface, appearance.displacement, appearance.atmosphere,
                 appearance.interior, appearance.exterior});
    if (appearance.coshaders)
      for (const auto &[handle, index] : *appearance.coshaders)
        used.insert(index);
  }
  used.insert(description.imager);
  used.erase(-1);
  std::vector<const ShaderUse *> uses;
  for (int index : used)
    uses.push_back(&description.shaders[size_t(index)]);
  uses.insert(uses.end(), lights.shaders().begin(), lights.shaders().end());
  loader.linkLights(lights);
  loader.open(uses);
  loader.openForRays();
  imagerServices.struct_size = sizeof imagerServices;
  imagerServices.space_matrix = services.space_matrix;
  imagerServices.query = services.query;
  imagerServices.texture = serveTexture;
  imagerServices.environment = serveEnvironment;
  imagerServices.shadow = serveShadow;
  shaders.resize(description.shaders.size());
  for (int index : used) {
    const ShaderUse &use = description.shaders[size_t(index)];
    shaders[size_t(index)] =
        loader.make(use, use.kind == ShaderKind::Imager         ? imagerServices
                         : use.kind == ShaderKind::Displacement ? displacementServices
                                                                : services);
  }
  // What is left out moves no surface.
  for (Appearance &appearance : description.appearances)
    if (appearance.displacement >= 0 && !shaders[size_t(appearance.displacement)])
      appearance.displacement = -1;
  if (std::any_of(shaders.begin(), shaders.end(),
                  [](const auto &shader) { return shader && shader->asksLights(); }))
    loader.open(lights.runStandard(cache));
  lights.load(loader, services);
  wantedChannels = Channels(description, shaders, warnings);
}

void Scene::splitShapes() {
  for (size_t i = 0, count = description.shapes.size(); i < count; ++i) {
    const Appearance &appearance = description.appearances[description.shapes[i].appearance];
    std::vector<const Shader *> its;
    for (int index : {appearance.surface, appearance.displacement})
      if (index >= 0 && shaders[size_t(index)])
        its.push_back(shaders[size_t(index)].get());
    for (Shape &part : splitByFaceValues(description.shapes[i], its))
      description.shapes.push_back(std::move(part));
  }
}

const Shader *Scene::imager() const {
  return description.imager < 0 ? nullptr : shaders[size_t(description.imager)].get();
}

const Shader *Scene::specialise(int index, const std::vector<Parameter> &constants,
                                const AnyslServices &services, Warnings &warnings) {
  const Shader *base = shaders[size_t(index)].get();
  if (constants.empty())
    return base;
  std::string key = std::to_string(index);
  for (const Parameter &constant : constants) {
    key += '\n' + constant.name + ' ';
    key.append(reinterpret_cast<const char *>(constant.numbers.data()),
               constant.numbers.size() * sizeof(double));
    for (const std::string &text : constant.strings)
      key += text + '\n';
  }
  auto [entry, isNew] = specialised.try_emplace(std::move(key));
  Specialised &made = entry->second;
  if (isNew) {
    made.use = description.shaders[size_t(index)];
    for (const Parameter &constant : constants) {
      std::erase_if(made.use.parameters,
                    [&](const Parameter &other) { return other.name == constant.name; });
      made.use.parameters.push_back(constant);
    }
    try {
      made.shader = loader.make(made.use, services, &description.shaders[size_t(index)]);
      made.shader->outputs = base->outputs;
    } catch (const UserError &error) {
      warnings.warn(error.where, error.message);
    }
  }
  return made.shader ? made.shader.get() : base;
}

void Scene::makeGroups(const AnyslServices &services, Warnings &warnings) {
  using Key = std::tuple<const Shader *, std::array<int, 5>, bool, const LightSet *, uint32_t,
                         uint32_t, std::vector<uint32_t>, std::pair<unsigned, unsigned>>;
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
      return shaderOf(index) && shaderOf(index)->asksFor(stc::Service::Spaces);
    });
    bool byAppearance = std::any_of(indices.begin(), indices.end() - 1, [&](int index) {
      return shaderOf(index) && (shaderOf(index)->asksFor(stc::Service::Queries) ||
                                 shaderOf(index)->asksFor(stc::Service::Shaders));
    });
    const Shader *surface = shaderOf(appearance.surface);
    ShapeBindings found;
    if (surface) {
      loader.checkLights(description.shaders[size_t(appearance.surface)], set->second);
      found = bind(shape, *surface, warnings);
      surface = specialise(appearance.surface, found.constant, services, warnings);
    }
    std::vector<uint32_t> bound;
    for (const Binding &binding : found.varying)
      bound.push_back(binding.parameter);
    bool shadowByShader = surface && appearance.visibility.transmission == Visibility::ByShader;
    Key key{surface,
            indices,
            shadowByShader,
            &set->second,
            bySpace ? i : anyObject,
            byAppearance ? shape.appearance : anyObject,
            std::move(bound),
            {appearance.maxDiffuseDepth, appearance.maxSpecularDepth}};
    auto [entry, isNewGroup] = known.try_emplace(key, uint32_t(groups.size()));
    if (isNewGroup) {
      ShadingGroup &group = groups.emplace_back();
      group.shader = surface;
      group.shadowByShader = shadowByShader;
      if (shadowByShader && !surface->of(RayKind::Shadow).source.keeps_opacity)
        group.shadow = &surface->of(RayKind::Shadow);
      group.atmosphere = shaderOf(indices[1]);
      group.interior = shaderOf(indices[2]);
      group.exterior = shaderOf(indices[3]);
      group.lights = &set->second;
      group.object = Space(shape.objectToCamera);
      group.matte = appearance.matte;
      group.maxDiffuseDepth = appearance.maxDiffuseDepth;
      group.maxSpecularDepth = appearance.maxSpecularDepth;
      group.bound = found.varying;
      group.appearance = &appearance;
      if (byAppearance && appearance.coshaders)
        for (const auto &[handle, index] : *appearance.coshaders)
          group.called |= shaderOf(index) ? shaderOf(index)->globals : 0;
    }
    bindings.push_back(std::move(found.varying));
    groupOfShape.push_back(entry->second);
  }
  // Where no shader need run, geometry tells all.
  for (uint32_t i = 0; i < description.shapes.size(); ++i)
    if (auto &transmission =
            description.appearances[description.shapes[i].appearance].visibility.transmission;
        transmission == Visibility::ByShader && !groups[groupOfShape[i]].shadow)
      transmission = Visibility::ByOpacity;
}
