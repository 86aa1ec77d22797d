//===-- lib/Rib/RibStructure.cpp - requests that open and close blocks ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <algorithm>

using namespace anysl::render;

void RibState::open(Block kind, const RibArguments &arguments) {
  blocks.push_back({kind, arguments.where()});
  savedStates.push_back(state);
}

void RibState::close(Block kind, const char *name, const RibArguments &arguments) {
  if (blocks.size() <= blockFloor || blocks.back().kind != kind)
    throw UserError(arguments.where(), std::string(name) + "End does not match the open block");
  blocks.pop_back();
  GraphicsState saved = std::move(savedStates.back());
  savedStates.pop_back();
  if (kind == Block::Transform)
    state.transform = saved.transform;
  else
    state = std::move(saved);
}

bool RibState::inWorld() const {
  return std::any_of(blocks.begin(), blocks.end(),
                     [](const OpenBlock &block) { return block.kind == Block::World; });
}

void RibState::frameBegin(RibArguments &arguments) {
  frame = arguments.number("the frame's number");
  if (inWorld())
    throw UserError(arguments.where(), "FrameBegin inside a world");
  open(Block::Frame, arguments);
  savedScenes.push_back(scene);
}

void RibState::frameEnd(RibArguments &arguments) {
  close(Block::Frame, "Frame", arguments);
  scene = std::move(savedScenes.back());
  savedScenes.pop_back();
  std::erase_if(lightHandles, [&](auto &entry) { return entry.second >= scene.lights.size(); });
}

void RibState::worldBegin(RibArguments &arguments) {
  if (inWorld())
    throw UserError(arguments.where(), "WorldBegin inside a world");
  Matrix4 test = state.transform;
  if (!test.invert())
    throw UserError(arguments.where(), "the camera's transformation has no inverse");
  open(Block::World, arguments);
  savedScenes.push_back(scene);
  scene.worldToCamera = state.transform;
}

void RibState::worldEnd(RibArguments &arguments) {
  close(Block::World, "World", arguments);
  for (OutputFile &output : scene.outputs)
    if (output.isReplacement) {
      warnings.warnOnce("display " + output.format, output.where,
                        "Display: there is no \"" + output.format +
                            "\"; a file is written instead");
      output.format = "file";
    }
  if (scene.outputs.empty())
    scene.outputs.push_back({sceneFile.stem().string() + ".png",
                             "file",
                             {{"rgb", {}}},
                             false,
                             false,
                             arguments.where()});
  finished.push_back(std::move(scene));
  scene = std::move(savedScenes.back());
  savedScenes.pop_back();
  std::erase_if(lightHandles, [&](auto &entry) { return entry.second >= scene.lights.size(); });
}

void RibState::attributeBegin(RibArguments &arguments) { open(Block::Attribute, arguments); }
void RibState::attributeEnd(RibArguments &arguments) {
  close(Block::Attribute, "Attribute", arguments);
}
void RibState::transformBegin(RibArguments &arguments) { open(Block::Transform, arguments); }
void RibState::transformEnd(RibArguments &arguments) {
  close(Block::Transform, "Transform", arguments);
}

void RibState::solidBegin(RibArguments &arguments) {
  std::string operation = arguments.string("an operation");
  if (operation != "primitive")
    warnings.warnOnce("solid", arguments.where(),
                      "SolidBegin \"" + operation +
                          "\": solids are not cut; the shapes are drawn as they are");
  open(Block::Solid, arguments);
}
void RibState::solidEnd(RibArguments &arguments) { close(Block::Solid, "Solid", arguments); }

void RibState::declare(RibArguments &arguments) {
  std::string name = arguments.string("a name");
  std::string text = arguments.string("a declaration");
  declarations[name] = parseDeclaration(text, nullptr, arguments.where());
}
