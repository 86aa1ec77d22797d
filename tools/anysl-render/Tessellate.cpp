//===-- tools/anysl-render/Tessellate.cpp - shapes to triangles -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Tessellate.h"

using namespace anysl::render;

std::unique_ptr<Mesh> anysl::render::tessellate(const Shape &shape, const Placement &placement,
                                                const Dicing &dicing) {
  return std::visit(
      [&]<typename Kind>(const Kind &kind) -> std::unique_ptr<Mesh> {
        if constexpr (std::is_same_v<Kind, PointsShape>)
          return nullptr;
        else
          return tessellate(kind, shape.variables, placement, dicing);
      },
      shape.geometry);
}
