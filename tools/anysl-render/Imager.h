//===-- tools/anysl-render/Imager.h - shaders of finished pixels -----------------------*- C++
//-*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_IMAGER_H
#define ANYSL_RENDER_IMAGER_H

#include "tools/anysl-render/Film.h"

namespace anysl::render {

class Scene;

/// Runs the scene's imager over the rendered part of a picture. Returns how many pixels it made
/// that are not numbers; those become black.
uint64_t runImager(const Scene &scene, Film &film);

} // namespace anysl::render

#endif
