//===-- tools/anysl-render/Textures.h - textures from pictures -----------------------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_TEXTURES_H
#define ANYSL_RENDER_TEXTURES_H

#include "lib/Rib/SceneDescription.h"

namespace anysl::render {

/// Makes a texture file, tiled and with all its smaller versions. A cube becomes a picture in
/// latitude and longitude, y up. Throws UserError where it cannot.
void makeTexture(const TextureUse &use);

} // namespace anysl::render

#endif
