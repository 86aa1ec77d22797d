//===-- lib/Rib/Camera.h - rays from the eye --------------------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_RIB_CAMERA_H
#define ANYSL_LIB_RIB_CAMERA_H

#include "lib/Rib/SceneDescription.h"

#include <string_view>

namespace anysl::render {

struct Shader;

/// How a ray differs from those through the pixels to the right and below, at its start (a ray
/// differential; Igehy, Tracing Ray Differentials, 1999).
struct RaySpread {
  Vec3d origin[2], direction[2];
};

/// A ray with a direction of unit length.
struct Ray {
  Vec3f origin, direction;
  float near = 0, far = 1e30f;
  uint32_t seed = 0;
  float travelled = 0; ///< from the eye, or where it was traced from, through surfaces up to here
  const Shader *medium = nullptr;    ///< the volume that it goes through; null: the atmosphere
  const RaySpread *spread = nullptr; ///< where `travelled` is 0; null: nobody has said
};

class Camera {
public:
  explicit Camera(const CameraDescription &description);

  /// The ray through a place of the raster, whose origin is the picture's upper left corner, from a
  /// place of the lens, as if its radius were 1.
  Ray ray(double rasterX, double rasterY, uint32_t seed, double lensX = 0, double lensY = 0) const;

  /// The matrix from camera space to "screen", "NDC" or "raster"; false for another name.
  bool projection(std::string_view space, Matrix4 &matrix) const;

  /// How many pixels across a unit of length is that stands at a place and is seen from in front,
  /// wherever the place lies: also beside and behind the camera, for things seen in mirrors.
  double pixelsPerUnit(Vec3d place) const;

  /// How a ray from the eye differs from its neighbours.
  RaySpread spread(Vec3f direction) const;

  bool isPerspective() const { return description.perspective; }
  /// How far the ray through the next pixel to the right, and downwards, lies from a ray: for a
  /// perspective camera at depth 1.
  double pixelWidth() const { return scale * (window[1] - window[0]) / description.width; }
  double pixelHeight() const { return scale * (window[2] - window[3]) / description.height; }

  int width() const { return description.width; }
  int height() const { return description.height; }
  /// The part of the picture that is rendered, in pixels: [x0, x1) x [y0, y1).
  void cropPixels(int &x0, int &x1, int &y0, int &y1) const;

private:
  CameraDescription description;
  std::array<double, 4> window; ///< left, right, bottom, top of the screen
  double scale; ///< screen coordinates to directions: the tangent of half the field of view
};

} // namespace anysl::render

#endif
