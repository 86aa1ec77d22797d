//===-- lib/Rib/RibShaders.cpp - requests that name shaders -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <algorithm>

using namespace anysl::render;

int RibState::addShader(ShaderKind kind, RibArguments &arguments) {
  ShaderUse use;
  use.kind = kind;
  use.where = arguments.where();
  use.name = arguments.string("a shader's name");
  use.parameters = arguments.parameters();
  use.shaderToCamera = state.transform;
  if (use.name.empty() || use.name == "null" || use.name == "defaultsurface")
    return -1;
  scene.shaders.push_back(std::move(use));
  return int(scene.shaders.size()) - 1;
}

void RibState::surface(RibArguments &arguments) {
  state.appearance.surface = addShader(ShaderKind::Surface, arguments);
}
void RibState::displacement(RibArguments &arguments) {
  state.appearance.displacement = addShader(ShaderKind::Displacement, arguments);
}
void RibState::atmosphere(RibArguments &arguments) {
  state.appearance.atmosphere = addShader(ShaderKind::Volume, arguments);
}
void RibState::interior(RibArguments &arguments) {
  state.appearance.interior = addShader(ShaderKind::Volume, arguments);
}
void RibState::exterior(RibArguments &arguments) {
  state.appearance.exterior = addShader(ShaderKind::Volume, arguments);
}
void RibState::imager(RibArguments &arguments) {
  scene.imager = addShader(ShaderKind::Imager, arguments);
}

/// Shader "name" "handle" parameters: one that others call by its handle.
void RibState::coshader(RibArguments &arguments) {
  ShaderUse use;
  use.kind = ShaderKind::Any;
  use.where = arguments.where();
  use.name = arguments.string("a shader's name");
  std::string handle = arguments.handle("a handle");
  use.parameters = arguments.parameters();
  use.shaderToCamera = state.transform;
  std::map<std::string, int, std::less<>> all;
  if (state.appearance.coshaders)
    all = *state.appearance.coshaders;
  if (use.name.empty() || use.name == "null") {
    all.erase(handle);
  } else {
    all[handle] = int(scene.shaders.size());
    scene.shaders.push_back(std::move(use));
  }
  state.appearance.coshaders =
      std::make_shared<const std::map<std::string, int, std::less<>>>(std::move(all));
}

void RibState::deformation(RibArguments &arguments) {
  std::string name = arguments.string("a shader's name");
  arguments.parameters();
  if (name != "null" && !name.empty())
    warnings.warnOnce("deformation", arguments.where(),
                      "Deformation \"" + name + "\": shaders that deform are not run");
}

uint32_t RibState::addLight(RibArguments &arguments) {
  LightUse light;
  light.where = arguments.where();
  light.name = arguments.string("a light's name");
  std::string handle = arguments.handle("a handle");
  light.handle = handle;
  light.parameters = arguments.parameters();
  light.lightToCamera = state.transform;
  light.castsShadow = state.lightShadows;
  uint32_t index = uint32_t(scene.lights.size());
  lightHandles[handle] = index;
  state.appearance.lights.push_back(index);
  scene.lights.push_back(std::move(light));
  return index;
}

void RibState::lightSource(RibArguments &arguments) { addLight(arguments); }

void RibState::areaLightSource(RibArguments &arguments) {
  uint32_t light = addLight(arguments);
  const std::string &name = scene.lights[light].name;
  bool none = name.empty() || name == "null";
  state.areaLight = none ? -1 : int(light);
  if (none)
    state.appearance.lights.pop_back();
}

void RibState::illuminate(RibArguments &arguments) {
  std::string handle = arguments.handle("a light's handle");
  bool on = arguments.number("1 or 0") != 0;
  auto light = lightHandles.find(handle);
  if (light == lightHandles.end() || light->second >= scene.lights.size())
    throw UserError(arguments.where(), "Illuminate: there is no light " + handle);
  std::vector<uint32_t> &lights = state.appearance.lights;
  auto place = std::lower_bound(lights.begin(), lights.end(), light->second);
  bool there = place != lights.end() && *place == light->second;
  if (on && !there)
    lights.insert(place, light->second);
  else if (!on && there)
    lights.erase(place);
}
