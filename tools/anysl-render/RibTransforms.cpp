//===-- tools/anysl-render/RibTransforms.cpp - requests that transform
//-------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/RibState.h"

using namespace anysl::render;

void RibState::identity(RibArguments &) {
  state.transform = inWorld() ? scene.worldToCamera : Matrix4::identity();
}

void RibState::transform(RibArguments &arguments) {
  // Inside a world the current transformation leads to the world, whose own leads to the camera.
  Matrix4 matrix = arguments.matrix();
  state.transform = inWorld() ? matrix * scene.worldToCamera : matrix;
}

void RibState::concatTransform(RibArguments &arguments) { concatenate(arguments.matrix()); }
void RibState::translate(RibArguments &arguments) {
  concatenate(Matrix4::translation(arguments.triple("an offset")));
}
void RibState::rotate(RibArguments &arguments) {
  auto n = arguments.numbers(4, "an angle and an axis");
  concatenate(Matrix4::rotation(n[0], {n[1], n[2], n[3]}));
}
void RibState::scale(RibArguments &arguments) {
  concatenate(Matrix4::scaling(arguments.triple("factors")));
}
void RibState::coordinateSystem(RibArguments &arguments) {
  scene.spaces[arguments.string("a name")] = state.transform;
}
