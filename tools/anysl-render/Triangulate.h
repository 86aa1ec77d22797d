//===-- tools/anysl-render/Triangulate.h - polygons to triangles ------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_TRIANGULATE_H
#define ANYSL_RENDER_TRIANGULATE_H

#include "lib/Rib/Linear.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace anysl::render {

/// Cuts a polygon, which may be concave and have holes, into triangles that turn as its outline
/// does. `corners` lists the outline and then each hole, in either direction; `loopSizes` says how
/// many corners each has. Triangles are appended as indices into `corners`. From outlines that
/// cross themselves come some triangles; nothing is promised of them. A hole that lies nowhere in
/// the outline is left out.
void triangulate(std::span<const Vec3d> corners, std::span<const uint32_t> loopSizes,
                 std::vector<std::array<uint32_t, 3>> &triangles);

} // namespace anysl::render

#endif
