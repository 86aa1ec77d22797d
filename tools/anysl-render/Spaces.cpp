//===-- tools/anysl-render/Spaces.cpp - named coordinate systems ------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Spaces.h"

using namespace anysl::render;

Spaces::Spaces(const SceneDescription &scene, const Camera &eye) {
  named.emplace("world", Space(scene.worldToCamera));
  for (const char *name : {"screen", "NDC", "raster"}) {
    Space space;
    eye.projection(name, space.fromCamera);
    space.toCamera = space.fromCamera.inverse();
    named.emplace(name, space);
  }
  for (const auto &[name, toCamera] : scene.spaces)
    named.insert_or_assign(name, Space(toCamera));
}

const Space *Spaces::find(const Space *shader, const Space *object, std::string_view name) const {
  if (name == "current" || name == "camera" || name == "eye")
    return &camera;
  if (name == "shader" && shader)
    return shader;
  if (name == "object" && object)
    return object;
  auto entry = named.find(name);
  return entry == named.end() ? nullptr : &entry->second;
}

bool Spaces::matrix(const Space *shader, const Space *object, std::string_view fromName,
                    std::string_view toName, Matrix4 &matrix) const {
  const Space *from = find(shader, object, fromName), *to = find(shader, object, toName);
  if (!from || !to)
    return false;
  if (from == &camera)
    matrix = to->fromCamera;
  else if (to == &camera)
    matrix = from->toCamera;
  else
    matrix = from->toCamera * to->fromCamera;
  return true;
}
