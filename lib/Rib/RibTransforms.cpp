//===-- lib/Rib/RibTransforms.cpp - requests that transform -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <algorithm>
#include <numbers>

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

void RibState::skew(RibArguments &arguments) {
  auto n = arguments.numbers(7, "an angle and two directions");
  Vec3d along = normalized({n[1], n[2], n[3]}), shift = normalized({n[4], n[5], n[6]});
  Vec3d across = along - shift * dot(along, shift);
  double between = std::acos(std::clamp(dot(along, shift), -1.0, 1.0));
  double angle = n[0] * (std::numbers::pi / 180);
  if (along == Vec3d() || shift == Vec3d() || length(across) < 1e-9 || angle >= between ||
      angle <= between - std::numbers::pi)
    throw UserError(arguments.where(), "Skew: the angle does not lie between the two directions");
  // Points move along `shift` by their distance from it, so far that the first direction turns
  // towards it by the angle.
  across = normalized(across);
  double amount = 1 / std::tan(between - angle) - 1 / std::tan(between);
  Matrix4 matrix = Matrix4::identity();
  for (size_t row = 0; row < 3; ++row)
    for (size_t column = 0; column < 3; ++column)
      matrix.m[row][column] += amount * across[int(row)] * shift[int(column)];
  concatenate(matrix);
}

void RibState::perspective(RibArguments &arguments) {
  double fov = arguments.number("a field of view");
  if (!(fov > 0 && fov < 180))
    throw UserError(arguments.where(), "Perspective: the field of view must lie between 0 and 180");
  double scale = 1 / std::tan(0.5 * fov * (std::numbers::pi / 180));
  Matrix4 matrix = Matrix4::scaling({scale, scale, 1});
  matrix.m[2] = {0, 0, 1, 1};
  matrix.m[3] = {0, 0, -1, 0};
  concatenate(matrix);
}

void RibState::coordSysTransform(RibArguments &arguments) {
  std::string name = arguments.string("a name");
  auto space = scene.spaces.find(name);
  if (space != scene.spaces.end())
    state.transform = space->second;
  else if (name == "camera" || name == "current")
    state.transform = Matrix4::identity();
  else if (name == "world")
    state.transform = inWorld() ? scene.worldToCamera : Matrix4::identity();
  else if (name != "object")
    warnings.fail(arguments.where(), "there is no coordinate system \"" + name + "\"");
}

void RibState::coordinateSystem(RibArguments &arguments) {
  scene.spaces[arguments.string("a name")] = state.transform;
}
