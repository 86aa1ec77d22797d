//===-- tools/anysl-render/Film.cpp - the picture and its files -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Film.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>

#include <unistd.h>

namespace fs = std::filesystem;
using namespace anysl::render;

float anysl::render::encodeSRGB(float linear) {
  // IEC 61966-2-1.
  if (!(linear > 0))
    return 0;
  if (linear >= 1)
    return 1;
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

std::string anysl::render::imageFileName(const OutputFile &output) {
  if (fs::path(output.name).has_extension())
    return output.name;
  if (output.format == "openexr" || output.format == "exr")
    return output.name + ".exr";
  if (output.format == "tiff" || output.format == "tif")
    return output.name + ".tif";
  return output.name + ".png";
}

void anysl::render::checkOutput(const OutputFile &output) {
  fs::path name = imageFileName(output);
  std::error_code error;
  if (name.has_parent_path() && !fs::is_directory(name.parent_path(), error))
    throw UserError(output.where, "cannot write '" + name.string() + "': there is no folder '" +
                                      name.parent_path().string() + "'");
  if (!OIIO::ImageOutput::create(name.string()))
    throw UserError(output.where, "cannot write '" + name.string() + "': " + OIIO::geterror());
}

void anysl::render::writeImage(const Film &film, const SceneDescription &scene,
                               const OutputFile &output) {
  fs::path name = imageFileName(output);
  std::string suffix = name.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](char c) { return char(std::tolower(c)); });
  bool linear = suffix == ".exr" || suffix == ".hdr" || suffix == ".pfm";

  // OpenImageIO chooses the format by the suffix, so that the temporary name keeps it.
  fs::path temporary =
      name.parent_path() / ("." + name.stem().string() + "." + std::to_string(getpid()) + suffix);
  auto fail = [&](const std::string &reason) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw UserError(output.where, "cannot write '" + name.string() + "': " + reason);
  };
  auto file = OIIO::ImageOutput::create(temporary.string());
  if (!file)
    fail(OIIO::geterror());
  int channels = output.alpha ? 4 : 3;
  auto type =
      linear ? (output.half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT) : OIIO::TypeDesc::UINT8;
  OIIO::ImageSpec spec(film.width, film.height, channels, type);
  spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
  spec.attribute("Software", "AnySL " ANYSL_VERSION);
  if (!linear)
    spec.attribute("oiio:dither", 0);

  std::vector<float> values;
  values.reserve(film.pixels.size() * size_t(channels));
  for (const auto &pixel : film.pixels) {
    for (int k = 0; k < 3; ++k) {
      float value = pixel[size_t(k)] * float(scene.gain);
      if (!linear && scene.gamma != 1)
        value = std::pow(std::clamp(value, 0.0f, 1.0f), float(1 / scene.gamma));
      else if (!linear)
        value = encodeSRGB(value);
      values.push_back(value);
    }
    if (output.alpha)
      values.push_back(std::clamp(pixel[3], 0.0f, 1.0f));
  }
  if (!file->open(temporary.string(), spec) ||
      !file->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !file->close())
    fail(file->geterror());
  std::error_code error;
  fs::rename(temporary, name, error);
  if (error)
    fail(error.message());
}
