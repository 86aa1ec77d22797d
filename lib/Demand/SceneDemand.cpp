//===-- lib/Demand/SceneDemand.cpp - what a scene that was read calls for ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Demand/Demand.h"

#include <algorithm>
#include <filesystem>
#include <set>

using namespace anysl::render;

namespace anysl::demand {
namespace {

/// The places of shaders that some shape uses, and of those that others call.
struct UsedShaders {
  std::set<int> surfaces, displacements, volumes, coshaders;
  explicit UsedShaders(const SceneDescription &scene) {
    for (const Shape &shape : scene.shapes) {
      const Appearance &appearance = scene.appearances[shape.appearance];
      surfaces.insert(appearance.surface);
      displacements.insert(appearance.displacement);
      volumes.insert({appearance.atmosphere, appearance.interior, appearance.exterior});
      if (appearance.coshaders)
        for (const auto &[handle, index] : *appearance.coshaders)
          coshaders.insert(index);
    }
    for (std::set<int> *set : {&surfaces, &displacements, &volumes, &coshaders})
      set->erase(-1);
  }
};

bool isSame(const Value &a, const Value &b) { return a.numbers == b.numbers && a.text == b.text; }

/// A parameter's value; nothing where it is no single value that a shader could be compiled for.
/// Geometric values are left to the renderer, which knows in which space it wants them.
std::optional<Value> valueOf(const Parameter &parameter) {
  Value result;
  result.from = placeOf(parameter.where);
  if (parameter.declaration) {
    ValueType type = parameter.declaration->type;
    if (parameter.declaration->arrayLength ||
        (type != ValueType::Float && type != ValueType::Color && type != ValueType::String))
      return std::nullopt;
  }
  if (parameter.strings.size() == 1)
    result.text = parameter.strings[0];
  else if (parameter.numbers.size() == 1 || parameter.numbers.size() == 3)
    result.numbers = parameter.numbers;
  else
    return std::nullopt;
  return result;
}

/// A light of a standard kind, as far as every renderer that reads the scene has the same of it:
/// positions and directions depend on the space in which it shades, colours and angles on how it
/// rounds; of a light shader only that it is one. Nothing where a renderer may have several lights
/// for it.
std::optional<LightDemand> lightOf(const LightUse &light) {
  LightDemand result;
  result.kind = light.name;
  AnyslLight &values = result.values.light;
  values.kind = standardKind(light.name);
  if (!light.shapes.empty())
    return std::nullopt;
  if (values.kind == ANYSL_LIGHT_SHADER) {
    result.values.known_flags = shadowsKnownOf(light);
    return result;
  }
  auto flag = [&](uint32_t bit, bool isSet) {
    result.values.known_flags |= bit;
    values.flags |= isSet ? bit : 0;
  };
  auto number = [&](const char *name, double otherwise) -> std::optional<double> {
    const Parameter *parameter = findParameter(light.parameters, name);
    if (!parameter)
      return otherwise;
    return parameter->numbers.size() == 1 ? std::optional(parameter->numbers[0]) : std::nullopt;
  };
  flag(ANYSL_LIGHT_CASTS_SHADOW, light.castsShadow);
  if (auto given = number("__nondiffuse", 0))
    flag(ANYSL_LIGHT_NONDIFFUSE, *given != 0);
  if (auto given = number("__nonspecular", 0))
    flag(ANYSL_LIGHT_NONSPECULAR, *given != 0);
  const Parameter *category = findParameter(light.parameters, "__category");
  if (!category || category->strings.size() == 1) {
    result.values.known |= ANYSL_KNOWN_CATEGORY;
    result.category = category ? category->strings[0] : "";
  }
  auto beam = number("beamdistribution", 2);
  if (values.kind == ANYSL_LIGHT_SPOT && beam) {
    values.beam = float(*beam);
    result.values.known |= finiteFields(values) & ANYSL_KNOWN_BEAM;
  }
  return result;
}

/// Adds the lights, if they are the same for all shapes and known.
void addLights(const SceneDescription &scene, Demand &demand) {
  const std::vector<uint32_t> *lights = nullptr;
  for (const Shape &shape : scene.shapes) {
    const std::vector<uint32_t> &its = scene.appearances[shape.appearance].lights;
    if (lights && *lights != its)
      return;
    lights = &its;
  }
  std::vector<LightDemand> each;
  bool hasAmbient = false;
  for (uint32_t index : lights ? *lights : std::vector<uint32_t>()) {
    bool isAmbient = scene.lights[index].name == ambientLight;
    auto light = isAmbient ? std::nullopt : lightOf(scene.lights[index]);
    if (!light && !isAmbient)
      return;
    hasAmbient |= isAmbient;
    if (light)
      each.push_back(std::move(*light));
  }
  if (each.size() <= ANYSL_MOST_LINKED_LIGHTS)
    demand.setLights(std::move(each), hasAmbient);
}

} // namespace

std::set<uint32_t> usedLights(const SceneDescription &scene) {
  std::set<uint32_t> result;
  for (const Shape &shape : scene.shapes) {
    const std::vector<uint32_t> &lights = scene.appearances[shape.appearance].lights;
    result.insert(lights.begin(), lights.end());
  }
  return result;
}

std::string shaderName(const std::string &file) {
  std::string name = std::filesystem::path(file).filename().string();
  return name.substr(0, name.find('.'));
}

std::string placeOf(const Location &where) {
  if (!where.file)
    return {};
  size_t line, column;
  where.lineAndColumn(line, column);
  return std::filesystem::path(where.file->name).filename().string() + ":" + std::to_string(line);
}

Demand demandOf(const SceneDescription &scene) {
  Demand result;
  std::set<std::string> outputs{"Ci", "Oi"}, lights;
  for (const OutputFile &output : scene.outputs)
    for (const OutputVariable &variable : output.variables)
      if (variable.name != "rgb" && variable.name != "a" && variable.name != "z")
        outputs.insert(variable.name);
  result.outputs.emplace(outputs.begin(), outputs.end());
  bool shadows = false;
  for (uint32_t index : usedLights(scene)) {
    lights.insert(scene.lights[index].name);
    shadows |= scene.lights[index].castsShadow;
  }
  result.lights.emplace(lights.begin(), lights.end());
  result.shadows = shadows;
  result.rayDepth = scene.maxDepth;
  UsedShaders used(scene);
  result.displacement = !used.displacements.empty();
  result.atmosphere = !used.volumes.empty();
  result.imager = scene.imager >= 0;
  result.lens = scene.camera.lensRadius > 0;
  result.shutter = {scene.camera.shutterOpen, scene.camera.shutterClose};
  return result;
}

std::set<std::string> variablesOf(const SceneDescription &scene) {
  std::set<std::string> result;
  for (const Shape &shape : scene.shapes)
    for (const Parameter &variable : shape.variables)
      result.insert(variable.name);
  return result;
}

void addShader(Demand &demand, const std::set<std::string> &variables,
               std::span<const ShaderUse *const> uses) {
  if (uses.empty())
    return;
  ShaderDemand &shader = demand.shaders[shaderName(uses[0]->name)];
  shader.complete = true;
  for (const Parameter &parameter : uses[0]->parameters) {
    // What is stated twice is for the renderer to say.
    auto [entry, isNew] = shader.parameters.try_emplace(parameter.name, valueOf(parameter));
    if (!isNew)
      entry->second.reset();
  }
  for (const ShaderUse *use : uses.subspan(1)) {
    // What one gives and the other leaves at its default differs as well.
    for (auto &[name, value] : shader.parameters) {
      const Parameter *other = findParameter(use->parameters, name);
      std::optional<Value> its = other ? valueOf(*other) : std::nullopt;
      if (!its || !value || !isSame(*its, *value))
        value.reset();
    }
    for (const Parameter &parameter : use->parameters)
      shader.parameters.try_emplace(parameter.name);
  }
  for (const std::string &name : variables)
    shader.parameters[name].reset();
}

std::vector<std::vector<const ShaderUse *>> alikeUses(std::span<const ShaderUse *const> uses,
                                                      size_t most) {
  using Pattern = std::map<std::string, bool>; // by stated parameter: whether it is nothing
  std::vector<Pattern> patterns;
  std::vector<std::vector<const ShaderUse *>> result;
  for (const ShaderUse *use : uses) {
    Pattern pattern;
    for (const Parameter &parameter : use->parameters) {
      auto isZero = [](double number) { return number == 0; };
      auto isEmpty = [](const std::string &text) { return text.empty(); };
      pattern[parameter.name] =
          std::all_of(parameter.numbers.begin(), parameter.numbers.end(), isZero) &&
          std::all_of(parameter.strings.begin(), parameter.strings.end(), isEmpty);
    }
    auto known = std::find(patterns.begin(), patterns.end(), pattern);
    if (known == patterns.end() && result.size() < most) {
      known = patterns.insert(patterns.end(), std::move(pattern));
      result.emplace_back();
    }
    result[std::min(size_t(known - patterns.begin()), result.size() - 1)].push_back(use);
  }
  return result;
}

std::map<std::string, std::array<double, 3>, std::less<>>
fixedGlobals(const SceneDescription &scene, std::span<const Shape *const> shapes) {
  std::map<std::string, std::array<double, 3>, std::less<>> result;
  auto add = [&](const char *name, render::Vec3d Appearance::*value) {
    std::optional<Vec3d> same;
    for (const Shape *shape : shapes) {
      const Vec3d &its = scene.appearances[shape->appearance].*value;
      if (findParameter(shape->variables, name) || (same && *same != its))
        return;
      same = its;
    }
    if (same)
      result[name] = {same->x, same->y, same->z};
  };
  add("Cs", &Appearance::color);
  add("Os", &Appearance::opacity);
  return result;
}

Demand demandOfAll(const SceneDescription &scene) {
  Demand result = demandOf(scene);
  addLights(scene, result);
  std::vector<const Shape *> shapes;
  for (const Shape &shape : scene.shapes)
    shapes.push_back(&shape);
  result.globals = fixedGlobals(scene, shapes);
  // What has to be rounded is left to the renderer.
  std::erase_if(result.globals, [](const auto &entry) {
    return std::any_of(entry.second.begin(), entry.second.end(),
                       [](double x) { return double(float(x)) != x; });
  });
  UsedShaders used(scene);
  std::map<std::string, std::vector<const ShaderUse *>> uses;
  auto add = [&](const ShaderUse &use) { uses[shaderName(use.name)].push_back(&use); };
  for (const auto *set : {&used.surfaces, &used.displacements, &used.volumes})
    for (int index : *set)
      add(scene.shaders[size_t(index)]);
  if (scene.imager >= 0)
    add(scene.shaders[size_t(scene.imager)]);
  std::vector<ShaderUse> lights;
  for (uint32_t index : usedLights(scene)) {
    const LightUse &light = scene.lights[index];
    lights.push_back({ShaderKind::Light, light.name, light.parameters, light.lightToCamera,
                      light.where, nullptr});
  }
  for (const ShaderUse &light : lights)
    add(light);
  const std::set<std::string> variables = variablesOf(scene);
  for (const auto &[name, list] : uses)
    addShader(result, variables, list);
  // A co-shader's parameters are set and read by whoever calls it.
  for (int index : used.coshaders)
    result.shaders[shaderName(scene.shaders[size_t(index)].name)] = {};
  return result;
}

} // namespace anysl::demand
