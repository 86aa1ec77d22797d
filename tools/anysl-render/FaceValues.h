//===-- tools/anysl-render/FaceValues.h - values of single faces ------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_FACEVALUES_H
#define ANYSL_RENDER_FACEVALUES_H

#include "tools/anysl-render/Bindings.h"

#include <span>

namespace anysl::render {

/// A shader's uniform parameter has one value for a shape, but polygons that share their corners,
/// patches of a mesh and faces of a subdivision surface may each have another. Takes such faces
/// apart: leaves in `shape` those with the values of the
/// first, and gives the others as shapes of their own. `shaders` are those whose parameters count.
std::vector<Shape> splitByFaceValues(Shape &shape, std::span<const Shader *const> shaders);

} // namespace anysl::render

#endif
