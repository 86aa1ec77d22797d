//===-- lib/Rib/RibTextures.cpp - requests that make textures ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

using namespace anysl::render;

void RibState::addTexture(TextureUse texture, RibArguments &arguments) {
  texture.where = arguments.where();
  arguments.parameters();
  // In the order of the file: what a picture has to be rendered for comes after it.
  std::vector<TextureUse> &list = finished.empty() ? firstTextures : finished.back().texturesAfter;
  list.push_back(std::move(texture));
}

void RibState::makeTexture(RibArguments &arguments) {
  TextureUse use;
  use.pictures = {arguments.string("a picture")};
  use.texture = arguments.string("a texture");
  use.wrapS = arguments.string("how s goes on beyond the edges");
  use.wrapT = arguments.string("how t goes on beyond the edges");
  arguments.string("a filter");
  arguments.numbers(2, "widths of the filter");
  addTexture(std::move(use), arguments);
}

void RibState::makeLatLongEnvironment(RibArguments &arguments) {
  TextureUse use;
  use.kind = TextureUse::LatLong;
  use.pictures = {arguments.string("a picture")};
  use.texture = arguments.string("a texture");
  arguments.string("a filter");
  arguments.numbers(2, "widths of the filter");
  addTexture(std::move(use), arguments);
}

void RibState::makeCubeFaceEnvironment(RibArguments &arguments) {
  TextureUse use;
  use.kind = TextureUse::CubeFaces;
  for (const char *what :
       {"the picture towards +x", "the picture towards -x", "the picture towards +y",
        "the picture towards -y", "the picture towards +z", "the picture towards -z"})
    use.pictures.push_back(arguments.string(what));
  use.texture = arguments.string("a texture");
  use.fov = arguments.number("the field of view");
  arguments.string("a filter");
  arguments.numbers(2, "widths of the filter");
  if (!(use.fov > 0 && use.fov < 180))
    throw UserError(arguments.where(),
                    "MakeCubeFaceEnvironment: the field of view must lie between 0 and 180");
  addTexture(std::move(use), arguments);
}

void RibState::makeShadow(RibArguments &arguments) {
  TextureUse use;
  use.kind = TextureUse::Shadow;
  use.pictures = {arguments.string("a picture")};
  use.texture = arguments.string("a texture");
  addTexture(std::move(use), arguments);
}
