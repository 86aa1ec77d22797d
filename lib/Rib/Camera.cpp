//===-- lib/Rib/Camera.cpp - rays from the eye ------------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/Camera.h"

#include <algorithm>
#include <numbers>

using namespace anysl::render;

Camera::Camera(const CameraDescription &given) : description(given) {
  double aspect = given.frameAspect > 0 ? given.frameAspect
                                        : double(given.width) * given.pixelAspect / given.height;
  if (given.screenWindow)
    window = *given.screenWindow;
  else if (aspect >= 1)
    window = {-aspect, aspect, -1, 1};
  else
    window = {-1, 1, -1 / aspect, 1 / aspect};
  scale = given.perspective ? std::tan(0.5 * given.fov * (std::numbers::pi / 180)) : 1;
}

Ray Camera::ray(double rasterX, double rasterY, uint32_t seed, double lensX, double lensY) const {
  double x = window[0] + (window[1] - window[0]) * (rasterX / description.width);
  double y = window[3] + (window[2] - window[3]) * (rasterY / description.height);
  // The ray at depth z is origin + direction * z.
  Vec3d origin, direction(x * scale, y * scale, 1);
  if (!description.perspective) {
    origin = {x, y, 0};
    direction = {0, 0, 1};
  }
  if (description.lensRadius > 0) {
    // Through a thin lens all rays to a point in focus meet there.
    Vec3d focus = origin + direction * description.focalDistance;
    origin += Vec3d(lensX, lensY, 0) * description.lensRadius;
    direction = (focus - origin) * (1 / description.focalDistance);
  }
  double slant = length(direction);
  Ray ray;
  ray.seed = seed;
  ray.origin = Vec3f(origin);
  ray.direction = Vec3f(direction * (1 / slant));
  ray.near = float(std::max(0.0, description.nearClip * slant));
  ray.far = float(std::min(1e30, description.farClip * slant));
  return ray;
}

RaySpread Camera::spread(Vec3f direction) const {
  Vec3d right(pixelWidth(), 0, 0), down(0, pixelHeight(), 0);
  if (!description.perspective)
    return {{right, down}, {}};
  // At depth z they are that far times z apart; a unit of length along the ray is less depth.
  double depth = double(direction.z);
  return {{}, {right * depth, down * depth}};
}

bool Camera::projection(std::string_view space, Matrix4 &matrix) const {
  bool ndc = space == "NDC", raster = space == "raster";
  if (space != "screen" && !ndc && !raster)
    return false;
  double nearClip = description.nearClip, farClip = description.farClip;
  Matrix4 toScreen = Matrix4::identity();
  if (description.perspective) {
    double depth = 1 / (1 - nearClip / farClip);
    toScreen.m[0][0] = toScreen.m[1][1] = 1 / scale;
    toScreen.m[2] = {0, 0, depth, 1};
    toScreen.m[3] = {0, 0, -nearClip * depth, 0};
  } else {
    toScreen.m[2][2] = 1 / (farClip - nearClip);
    toScreen.m[3][2] = -nearClip / (farClip - nearClip);
  }
  Matrix4 toImage = Matrix4::identity();
  if (ndc || raster) {
    double width = raster ? description.width : 1, height = raster ? description.height : 1;
    toImage.m[0][0] = width / (window[1] - window[0]);
    toImage.m[1][1] = height / (window[2] - window[3]);
    toImage.m[3][0] = -window[0] * toImage.m[0][0];
    toImage.m[3][1] = -window[3] * toImage.m[1][1];
  }
  matrix = toScreen * toImage;
  return true;
}

double Camera::pixelsPerUnit(Vec3d place) const {
  double pixels = description.width / std::fabs(window[1] - window[0]);
  return description.perspective ? pixels / (scale * std::max(length(place), 1e-6)) : pixels;
}

void Camera::cropPixels(int &x0, int &x1, int &y0, int &y1) const {
  // The standard's rule, by which adjoining windows share no pixel and miss none.
  auto edge = [](double fraction, int size) {
    return std::clamp(int(std::ceil(fraction * size)), 0, size);
  };
  x0 = edge(description.cropWindow[0], description.width);
  x1 = edge(description.cropWindow[1], description.width);
  y0 = edge(description.cropWindow[2], description.height);
  y1 = edge(description.cropWindow[3], description.height);
}
