//===-- tools/anysl-render/Channels.cpp - what pictures show besides colour
//--------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Channels.h"
#include "tools/anysl-render/Shaders.h"

#include <algorithm>

using namespace anysl::render;

namespace {

ValueType valueType(uint32_t type) {
  switch (type) {
  case ANYSL_COLOR:
    return ValueType::Color;
  case ANYSL_POINT:
    return ValueType::Point;
  case ANYSL_VECTOR:
    return ValueType::Vector;
  case ANYSL_NORMAL:
    return ValueType::Normal;
  case ANYSL_MATRIX:
    return ValueType::Matrix;
  default:
    return ValueType::Float;
  }
}

/// The output parameter of this name that some shader has.
const AnyslParamInfo *findOutput(const std::string &name,
                                 std::span<const std::unique_ptr<Shader>> shaders) {
  for (const auto &shader : shaders)
    if (const AnyslParamInfo *param =
            shader ? anysl_shader_param(shader->info, name.c_str()) : nullptr)
      if ((param->flags & ANYSL_PARAM_OUTPUT) && param->type != ANYSL_STRING)
        return param;
  return nullptr;
}

} // namespace

Channels::Channels(const SceneDescription &scene, std::span<const std::unique_ptr<Shader>> shaders,
                   Warnings &warnings) {
  for (const OutputFile &output : scene.outputs)
    for (const OutputVariable &variable : output.variables)
      if (variable.name != "rgb" && variable.name != "a" && !find(variable.name))
        add(variable, output.where, shaders, warnings);
  // An imager may ask how much of each colour is hidden.
  for (const auto &shader : shaders)
    if (shader && shader->info->kind == ANYSL_IMAGER && (shader->needed >> ANYSL_Oi & 1) &&
        !find("Oi"))
      add({"Oi", {}}, {}, shaders, warnings);
  for (const auto &shader : shaders)
    for (uint32_t i = 0; shader && i < shader->info->param_count; ++i) {
      const AnyslParamInfo &param = shader->info->params[i];
      const Channel *channel = find(param.name);
      if (channel && channel->source == Channel::Parameter && (param.flags & ANYSL_PARAM_OUTPUT) &&
          param.array_length == 0 && anysl_type_components(param.type) == channel->components)
        shader->outputs.push_back({i, uint32_t(channel - channels.data())});
    }
}

void Channels::add(const OutputVariable &variable, const Location &where,
                   std::span<const std::unique_ptr<Shader>> shaders, Warnings &warnings) {
  Channel channel;
  channel.name = variable.name;
  channel.first = total;
  int global = anysl_global_find(variable.name.c_str());
  if (global > ANYSL_dPdv) // not a surface's, or the same everywhere
    global = -1;
  if (variable.name == "z") {
    channel.source = Channel::Depth;
  } else if (variable.name == "Oi") {
    channel.source = Channel::Opacity;
    channel.type = ValueType::Color;
  } else if (global >= 0) {
    channel.source = Channel::Global;
    channel.global = global;
    channel.type = valueType(anysl_global_type(global));
    wantedGlobals |= uint64_t(1) << global;
  } else if (const AnyslParamInfo *param = findOutput(variable.name, shaders)) {
    channel.type = valueType(param->type);
  } else {
    warnings.warn(where, "no shader has an output parameter \"" + variable.name +
                             "\"; it is 0 everywhere");
    if (variable.declaration && variable.declaration->type != ValueType::String)
      channel.type = variable.declaration->type;
  }
  channel.components = componentCount(channel.type);
  total += channel.components;
  channels.push_back(std::move(channel));
}

const Channel *Channels::find(std::string_view name) const {
  auto channel = std::find_if(channels.begin(), channels.end(),
                              [&](const Channel &each) { return each.name == name; });
  return channel == channels.end() ? nullptr : &*channel;
}

void Channels::clear(float *numbers) const {
  std::fill_n(numbers, total, 0.0f);
  for (const Channel &channel : channels)
    if (channel.source == Channel::Depth)
      numbers[channel.first] = 1e38f; // the interface's infinity
}
