//===-- tools/anysl-render/AreaLights.h - points of shapes that shine -------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_AREALIGHTS_H
#define ANYSL_RENDER_AREALIGHTS_H

#include "lib/Rib/SceneDescription.h"

namespace anysl::render {

/// A point of a shape in camera space, and the area around it that it stands for.
struct AreaSample {
  Vec3d P, N; ///< N of unit length, or zero where it is not known
  double area;
};

/// Points spread over a shape: sixteen on a quadric, four on each triangle of a polygon, or one if
/// the polygons are many; of other shapes the middle.
std::vector<AreaSample> areaSamples(const Shape &shape, const Appearance &appearance);

} // namespace anysl::render

#endif
