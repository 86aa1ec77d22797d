//===-- tools/anysl-render/Textures.cpp - textures from pictures
//-------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Textures.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <sstream>

#include <unistd.h>

namespace fs = std::filesystem;
using namespace anysl::render;

namespace {

/// Where a direction meets the faces of a cube.
struct CubePlace {
  size_t face; ///< px nx py ny pz nz
  double x, y; ///< in [-1, 1] from the left and from the top
};

/// The interface's table of faces: the direction of view, of the picture's right and of its top.
struct Face {
  Vec3d view, right, top;
};
constexpr Face faces[6] = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                           {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                           {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}};

CubePlace onCube(Vec3d direction) {
  double most = maxAbs(direction);
  size_t face = 0;
  for (size_t i = 0; i < 6; ++i)
    if (dot(faces[i].view, direction) >= most * (1 - 1e-12))
      face = i;
  return {face, dot(faces[face].right, direction) / most, -dot(faces[face].top, direction) / most};
}

void load(OIIO::ImageBuf &picture, const std::string &name, const Location &where) {
  picture.reset(name);
  if (!picture.read(0, 0, true, OIIO::TypeDesc::FLOAT))
    throw UserError(where, "cannot read '" + name + "': " + picture.geterror());
}

/// The six faces as one picture in latitude and longitude, as environment() looks it up: z up, +x
/// at the left edge.
OIIO::ImageBuf unfold(const TextureUse &use) {
  OIIO::ImageBuf cube[6];
  int channels = 1, width = 1;
  for (size_t i = 0; i < 6; ++i) {
    load(cube[i], use.pictures[i], use.where);
    channels = std::max(channels, cube[i].nchannels());
    width = std::max(width, cube[i].spec().width);
  }
  OIIO::ImageBuf result(OIIO::ImageSpec(4 * width, 2 * width, channels, OIIO::TypeDesc::FLOAT));
  const double scale = 1 / std::tan(0.5 * use.fov * (std::numbers::pi / 180));
  std::vector<float> pixel(static_cast<size_t>(channels));
  for (int y = 0; y < 2 * width; ++y)
    for (int x = 0; x < 4 * width; ++x) {
      double longitude = (x + 0.5) / (4 * width) * 2 * std::numbers::pi;
      double latitude = (0.5 - (y + 0.5) / (2 * width)) * std::numbers::pi;
      CubePlace place = onCube({std::cos(longitude) * std::cos(latitude),
                                std::sin(longitude) * std::cos(latitude), std::sin(latitude)});
      const OIIO::ImageBuf &face = cube[place.face];
      std::fill(pixel.begin(), pixel.end(), 0.0f);
      face.interppixel(float((0.5 + 0.5 * scale * place.x) * face.spec().width),
                       float((0.5 + 0.5 * scale * place.y) * face.spec().height), pixel.data(),
                       OIIO::ImageBuf::WrapClamp);
      result.setpixel(x, y, pixel.data());
    }
  return result;
}

const char *wrapMode(const std::string &name) {
  return name == "black" ? "black" : name == "clamp" ? "clamp" : "periodic";
}

} // namespace

void anysl::render::makeTexture(const TextureUse &use) {
  OIIO::ImageBuf source;
  if (use.kind == TextureUse::CubeFaces)
    source = unfold(use);
  else
    load(source, use.pictures[0], use.where);
  OIIO::ImageSpec config;
  config.attribute("wrapmodes", use.kind == TextureUse::Texture
                                    ? std::string(wrapMode(use.wrapS)) + "," + wrapMode(use.wrapT)
                                : use.kind == TextureUse::Shadow ? "clamp,clamp"
                                                                 : "periodic,clamp");
  config.attribute("maketx:verbose", 0);
  // A texture may lie where its picture does, and is to be there only when it is complete. Its
  // format is TIFF, whatever its name.
  fs::path name = use.texture;
  fs::path temporary = name.parent_path() /
                       ("." + name.filename().string() + "." + std::to_string(getpid()) + ".tif");
  auto mode = use.kind == TextureUse::Texture  ? OIIO::ImageBufAlgo::MakeTxTexture
              : use.kind == TextureUse::Shadow ? OIIO::ImageBufAlgo::MakeTxShadow
                                               : OIIO::ImageBufAlgo::MakeTxEnvLatl;
  std::ostringstream messages;
  bool made = OIIO::ImageBufAlgo::make_texture(mode, source, temporary.string(), config, &messages);
  std::error_code error;
  if (made)
    fs::rename(temporary, name, error);
  if (!made || error) {
    fs::remove(temporary, error);
    std::string reason = made ? error.message() : messages.str();
    throw UserError(use.where, "cannot make '" + use.texture +
                                   "': " + (reason.empty() ? OIIO::geterror() : reason));
  }
}
