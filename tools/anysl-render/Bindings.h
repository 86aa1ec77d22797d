//===-- tools/anysl-render/Bindings.h - variables to shaders' parameters ----------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_BINDINGS_H
#define ANYSL_RENDER_BINDINGS_H

#include "tools/anysl-render/Shaders.h"

namespace anysl::render {

/// A parameter of a shader that takes its value from a variable of the surface, point by point.
struct Binding {
  uint32_t parameter; ///< index into the shader's
  uint32_t variable;  ///< index into the surface's
  uint32_t numbers;   ///< of one value, with all elements of an array
};

/// What the variables of a shape do to the parameters of its shader of the same names.
struct ShapeBindings {
  std::vector<Binding> varying;
  std::vector<Parameter> constant; ///< the same for the whole shape, in the shader's space
};

/// Finds them; warns of those that do not fit, which have no effect.
ShapeBindings bind(const Shape &shape, const Shader &shader, Warnings &warnings);

} // namespace anysl::render

#endif
