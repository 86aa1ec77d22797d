//===-- lib/Rib/RibAttributes.cpp - requests about how surfaces look --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/Camera.h"
#include "lib/Rib/RibState.h"

#include <algorithm>

using namespace anysl::render;

Vec3d RibState::readColor(RibArguments &arguments, const char *what) {
  if (colorToRgb.empty())
    return arguments.triple(what);
  auto samples = arguments.numbers(colorToRgb.size() / 3, what);
  Vec3d result;
  for (size_t i = 0; i < samples.size(); ++i)
    for (size_t k = 0; k < 3; ++k)
      result[int(k)] += samples[i] * colorToRgb[3 * i + k];
  return result;
}

void RibState::color(RibArguments &arguments) {
  state.appearance.color = readColor(arguments, "a colour");
}
void RibState::opacity(RibArguments &arguments) {
  state.appearance.opacity = readColor(arguments, "an opacity");
}

void RibState::sides(RibArguments &arguments) {
  double count = arguments.number("1 or 2");
  if (count != 1 && count != 2)
    throw UserError(arguments.where(), "Sides: must be 1 or 2");
  state.appearance.sides = int(count);
}

void RibState::orientation(RibArguments &arguments) {
  std::string name = arguments.string("an orientation");
  // Camera space is left-handed, and so is every space that a mirror-free matrix leads there.
  Vec3d x = state.transform.vector({1, 0, 0}), y = state.transform.vector({0, 1, 0});
  bool leftHanded = dot(cross(x, y), state.transform.vector({0, 0, 1})) > 0;
  if (name == "outside" || name == "inside")
    state.appearance.reverseOrientation = name == "inside";
  else if (name == "lh" || name == "rh")
    state.appearance.reverseOrientation = (name == "lh") != leftHanded;
  else
    throw UserError(arguments.where(),
                    "Orientation: \"" + name + "\" is none of outside, inside, lh, rh");
}

void RibState::matte(RibArguments &arguments) {
  state.appearance.matte = arguments.number("1 or 0") != 0;
}

void RibState::detail(RibArguments &arguments) {
  auto bound = arguments.numbers(6, "a bound");
  // The pixels of the bound's projection; what lies around the camera is as large as can be.
  Matrix4 toRaster;
  Camera(scene.camera).projection("raster", toRaster);
  double low[2] = {1e30, 1e30}, high[2] = {-1e30, -1e30};
  for (size_t corner = 0; corner < 8; ++corner) {
    Vec3d p = state.transform.point(
        {bound[corner & 1], bound[2 + (corner >> 1 & 1)], bound[4 + (corner >> 2)]});
    if (scene.camera.perspective && p.z <= 1e-6) {
      state.detail = 1e30;
      return;
    }
    p = toRaster.point(p);
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  state.detail = (high[0] - low[0]) * (high[1] - low[1]);
}

void RibState::detailRange(RibArguments &arguments) {
  auto n = arguments.numbers(4, "where a detail appears, is there, fades and is gone");
  double size = state.detail * detailFactor;
  // In between it is there by the half that it would be seen with.
  auto isAbove = [&](double begin, double full) { return size >= 0.5 * (begin + full); };
  state.isLeftOut = state.detail > 0 && (!isAbove(n[0], n[1]) || (isAbove(n[2], n[3])));
}

void RibState::reverseOrientation(RibArguments &) {
  state.appearance.reverseOrientation = !state.appearance.reverseOrientation;
}

void RibState::textureCoordinates(RibArguments &arguments) {
  auto n = arguments.numbers(8, "four pairs s t");
  std::copy(n.begin(), n.end(), state.appearance.textureCoordinates.begin());
}

void RibState::shadingRate(RibArguments &arguments) {
  double rate = arguments.number("an area in pixels");
  if (!(rate > 0))
    throw UserError(arguments.where(), "ShadingRate: must be greater than 0");
  state.appearance.shadingRate = rate;
}

SetName anysl::render::takeSetName(std::string_view &list) {
  size_t end = std::min(list.find_first_of(", "), list.size());
  SetName result{0, list.substr(0, end)};
  list.remove_prefix(std::min(end + 1, list.size()));
  if (result.name.starts_with('+') || result.name.starts_with('-')) {
    result.sign = result.name.front();
    result.name.remove_prefix(1);
  }
  return result;
}

/// "a,b" says of which sets a surface is a member, "+a,-b" how that changes.
static void joinSets(std::vector<std::string> &sets, std::string_view text) {
  bool isNew = true;
  while (!text.empty()) {
    auto [sign, name] = takeSetName(text);
    if (!sign && isNew)
      sets.clear();
    isNew = false;
    std::erase(sets, name);
    if (sign != '-' && !name.empty())
      sets.emplace_back(name);
  }
}

bool RibState::setDepth(std::string_view name, const Parameter &parameter) {
  if (parameter.numbers.size() != 1)
    return false;
  auto depth = unsigned(std::clamp(parameter.numbers[0], 0.0, 64.0));
  if (name == "trace:maxdiffusedepth")
    state.appearance.maxDiffuseDepth = depth;
  else if (name == "trace:maxspeculardepth")
    state.appearance.maxSpecularDepth = depth;
  else
    return false;
  return true;
}

void RibState::attribute(RibArguments &arguments) {
  std::string group = arguments.string("a name");
  const auto &before = state.appearance.attributes;
  auto attributes =
      before ? std::make_shared<ParameterMap>(*before) : std::make_shared<ParameterMap>();
  for (const Parameter &parameter : arguments.parameters()) {
    std::string name = group + ":" + parameter.name;
    attributes->insert_or_assign(name, parameter);
    std::string text = parameter.strings.size() == 1 ? parameter.strings[0] : "";
    bool on = parameter.numbers.size() == 1 ? parameter.numbers[0] != 0 : text == "on";
    Visibility &visibility = state.appearance.visibility;
    if (name == "visibility:camera")
      visibility.camera = on;
    else if (name == "visibility:trace")
      visibility.specular = visibility.diffuse = on;
    else if (name == "visibility:specular")
      visibility.specular = on;
    else if (name == "visibility:diffuse")
      visibility.diffuse = on;
    else if (name == "visibility:transmission" && (text == "transparent" || (text.empty() && !on)))
      visibility.transmission = Visibility::Transparent;
    else if (name == "visibility:transmission" && text == "opaque")
      visibility.transmission = Visibility::Opaque;
    else if (name == "visibility:transmission" && text == "shader")
      visibility.transmission = Visibility::ByShader;
    else if (name == "visibility:transmission" && (text == "Os" || text.empty()))
      visibility.transmission = Visibility::ByOpacity;
    else if (name == "light:shadows")
      state.lightShadows = on;
    else if (name == "grouping:membership" && parameter.strings.size() == 1)
      joinSets(state.appearance.sets, text);
    else if (!setDepth(name, parameter) && !isQuiet(group))
      warnUnknown("attribute", name, parameter.where);
  }
  state.appearance.attributes = std::move(attributes);
}
