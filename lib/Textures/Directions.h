//===-- lib/Textures/Directions.h - where a direction lies in a picture -------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEXTURES_DIRECTIONS_H
#define ANYSL_TEXTURES_DIRECTIONS_H

#include <array>

namespace anysl::textures {

/// How a picture shows all directions.
enum class EnvironmentLayout {
  /// The RenderMan Interface's: +z is the top row, the left edge is +x, and s goes over +y.
  LatLongZUp,
  /// OpenEXR's: +y is the top row, the middle is +z, and s goes from +x to -x there.
  LatLongYUp,
  /// Six square faces below each other: +x -x +y -y +z -z.
  CubeColumn,
  /// The same in two rows of three.
  CubeRows
};

using Direction = std::array<double, 3>;

/// A filter in a picture: its centre and two axes.
struct PictureFilter {
  double s = 0, t = 0;
  /// How the centre changes with the direction's components; 0 at the poles of a globe.
  Direction sBy = {0, 0, 0}, tBy = {0, 0, 0};
  double ds[2] = {0, 0}, dt[2] = {0, 0};
  /// The part of the picture that it may look at: all of it, or the face of a cube.
  double low[2] = {0, 0}, high[2] = {1, 1};
};

/// Finds a direction of any length, and what two small changes of it cover. Gives false for no
/// direction: zero, infinite or NaN.
bool findDirection(EnvironmentLayout layout, const Direction &direction, const Direction &changeX,
                   const Direction &changeY, PictureFilter &filter);

} // namespace anysl::textures

#endif
