//===-- tools/anysl-render/RibAttributes.cpp - requests about how surfaces look
//----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/RibState.h"

using namespace anysl::render;

void RibState::color(RibArguments &arguments) {
  state.appearance.color = arguments.triple("a colour");
}
void RibState::opacity(RibArguments &arguments) {
  state.appearance.opacity = arguments.triple("an opacity");
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

void RibState::reverseOrientation(RibArguments &) {
  state.appearance.reverseOrientation = !state.appearance.reverseOrientation;
}

void RibState::textureCoordinates(RibArguments &arguments) {
  auto n = arguments.numbers(8, "four pairs s t");
  std::copy(n.begin(), n.end(), state.appearance.textureCoordinates.begin());
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
      visibility.trace = on;
    else if (name == "visibility:transmission" && (text == "transparent" || (text.empty() && !on)))
      visibility.transmission = Visibility::Transparent;
    else if (name == "visibility:transmission" && text == "opaque")
      visibility.transmission = Visibility::Opaque;
    else if (name == "visibility:transmission" && (text == "Os" || text.empty()))
      visibility.transmission = Visibility::ByOpacity;
    else if (name == "light:shadows")
      state.lightShadows = on;
    else if (group != "identifier" && group != "user")
      warnUnknown("attribute", name, parameter.where);
  }
  state.appearance.attributes = std::move(attributes);
}
