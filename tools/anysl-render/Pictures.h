//===-- tools/anysl-render/Pictures.h - textures, for both hosts --------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_PICTURES_H
#define ANYSL_RENDER_PICTURES_H

#include "lib/Rib/SceneDescription.h"
#include "lib/Textures/Textures.h"

namespace anysl::render {

/// The files of a scene's textures, looked for where Option "searchpath" "texture" says, relative
/// to the scene's folder, and in that folder.
std::unique_ptr<textures::Textures> makePictures(const SceneDescription &scene);

/// The services; `renderer` is the Shader.
AnyslTextureService serveTexture, serveEnvironment, serveShadow;

} // namespace anysl::render

#endif
