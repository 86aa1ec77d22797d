//===-- tools/anysl-render/Displacement.h - surfaces moved by shaders -------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_DISPLACEMENT_H
#define ANYSL_RENDER_DISPLACEMENT_H

#include "tools/anysl-render/PointSet.h"
#include "tools/anysl-render/Scene.h"

namespace anysl::render {

/// What a displacement shader may ask its renderer for: pictures, and named spaces, with
/// AnyslShadeArgs::batch pointing to the object's. There is nothing to trace yet.
extern const AnyslServices displacementServices;

/// Names the variables of a mesh that hold what its displacement shader's outputs were.
inline constexpr const char *displacementPrefix = "displacement:";

/// Moves a mesh's points to where a displacement shader puts them, and gives it the normals and
/// derivatives that belong there. Corners at a point go together: to the mean of where each would
/// go, so that the mesh stays whole.
///
/// Where the shader assigns N, the normals are the shader's; otherwise they stay what they were.
/// Where it has looked for the normals of what has moved, and what it knows has not turned them,
/// they are those of the mesh.
void displace(const Scene &scene, const Shader &shader, std::span<const Binding> bound,
              const Shape &shape, AnyslLayout layout, Mesh &mesh);
/// The same for particles, which keep their sizes. Balls have the normals of balls.
void displace(const Scene &scene, const Shader &shader, std::span<const Binding> bound,
              const Shape &shape, AnyslLayout layout, PointSet &points);

} // namespace anysl::render

#endif
