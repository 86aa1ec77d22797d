//===-- tools/anysl-render/AreaLights.h - points of shapes that shine -------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_AREALIGHTS_H
#define ANYSL_RENDER_AREALIGHTS_H

#include "lib/Rib/Camera.h"

namespace anysl::render {

/// A point of a shape in camera space, and the area around it that it stands for.
struct AreaSample {
  Vec3d P, N; ///< N of unit length
  double area;
};

/// Points spread over a shape as the camera would see it: sixteen on a quadric; on polygons and on
/// smooth surfaces, cut into triangles, four on each of a few, or 32 in all; on tubes,
/// and on spheres and discs that are points, 32 in all.
std::vector<AreaSample> areaSamples(const Shape &shape, const Appearance &appearance,
                                    const Camera &camera);

} // namespace anysl::render

#endif
