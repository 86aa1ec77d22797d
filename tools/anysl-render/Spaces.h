//===-- tools/anysl-render/Spaces.h - named coordinate systems --------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_SPACES_H
#define ANYSL_RENDER_SPACES_H

#include "lib/Rib/Camera.h"

#include <string_view>

namespace anysl::render {

/// A coordinate system: its matrix to camera space, and back.
struct Space {
  Matrix4 toCamera = Matrix4::identity(), fromCamera = Matrix4::identity();
  Space() = default;
  explicit Space(const Matrix4 &toCamera) : toCamera(toCamera), fromCamera(toCamera.inverse()) {}
};

/// The coordinate systems of a scene: "current", "camera" and "eye", which are the same, "world",
/// "screen", "NDC", "raster", and those of CoordinateSystem.
class Spaces {
public:
  Spaces(const SceneDescription &scene, const Camera &camera);

  /// The matrix from one to another; also "shader" and "object" are known where they are given.
  /// Returns false and leaves `matrix` alone for any other name.
  bool matrix(const Space *shader, const Space *object, std::string_view from, std::string_view to,
              Matrix4 &matrix) const;

private:
  const Space *find(const Space *shader, const Space *object, std::string_view name) const;

  Space camera;
  std::map<std::string, Space, std::less<>> named;
};

} // namespace anysl::render

#endif
