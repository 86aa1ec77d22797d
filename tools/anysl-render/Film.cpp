//===-- tools/anysl-render/Film.cpp - the picture and its files -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Film.h"

#include "lib/Rib/Camera.h"
#include "lib/Rib/FileTypes.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>
#include <map>

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

namespace {

/// The format of a file: by its suffix, else by the type that the scene states; empty: neither
/// says.
std::string imageFormat(const OutputFile &output) {
  const char *type = fileFormat(output.format);
  std::string byType = type ? type : "", bySuffix;
  if (auto file = OIIO::ImageOutput::create(imageFileName(output)))
    bySuffix = file->format_name();
  else
    OIIO::geterror(); // which is kept until asked for
  // Few formats hold depths, and depth files have names of all kinds.
  bool isDepth = output.format == "zfile" || output.format == "shadow";
  return bySuffix.empty() || (isDepth && bySuffix != "openexr") ? byType : bySuffix;
}

} // namespace

std::string anysl::render::imageFileName(const OutputFile &output) {
  if (fs::path(output.name).has_extension())
    return output.name;
  if (output.format == "openexr" || output.format == "exr")
    return output.name + ".exr";
  if (output.format == "tiff" || output.format == "tif")
    return output.name + ".tif";
  if (output.format == "zfile" || output.format == "shadow") // known by their names alone
    return output.name;
  return output.name + ".png";
}

void anysl::render::checkOutput(const OutputFile &output) {
  fs::path name = imageFileName(output);
  std::error_code error;
  if (name.has_parent_path() && !fs::is_directory(name.parent_path(), error))
    throw UserError(output.where, "cannot write '" + name.string() + "': there is no folder '" +
                                      name.parent_path().string() + "'");
  if (imageFormat(output).empty())
    throw UserError(output.where, "cannot write '" + name.string() +
                                      "': neither its suffix nor its type is known");
}

namespace {

/// Where one number of a file's pixel comes from.
struct FileChannel {
  std::string name;
  enum { Color, Coverage, Extra } source;
  unsigned number;     ///< of `source`
  bool isColor = true; ///< exposed, and encoded in files of integers
};

std::vector<FileChannel> fileChannels(const OutputFile &output, const Channels &channels) {
  static const char *const rgb[] = {"R", "G", "B"}, *const xyz[] = {"x", "y", "z"};
  std::vector<FileChannel> result;
  for (const OutputVariable &variable : output.variables) {
    if (variable.name == "rgb") {
      for (unsigned k = 0; k < 3; ++k)
        result.push_back({rgb[k], FileChannel::Color, k});
    } else if (variable.name == "a") {
      result.push_back({"A", FileChannel::Coverage, 0, false});
    } else if (const Channel *channel = channels.find(variable.name)) {
      // A value that is alone in its file has the names that viewers expect.
      bool isColor = channel->type == ValueType::Color, alone = output.variables.size() == 1;
      for (unsigned k = 0; k < channel->components; ++k) {
        std::string name = channel->components == 3   ? (isColor || alone ? rgb : xyz)[k]
                           : channel->components == 1 ? ""
                                                      : std::to_string(k);
        if (channel->source == Channel::Depth)
          name = "Z";
        else if (!alone)
          name = variable.name + (name.empty() ? "" : "." + name);
        else if (name.empty())
          name = "Y";
        result.push_back({name, FileChannel::Extra, channel->first + k, isColor});
      }
    }
  }
  return result;
}

/// From where the picture was taken, for those who use it as a shadow map: the world to camera
/// space, and to the picture, whose x goes from -1 at the left to 1 and whose y from -1 at the
/// bottom to 1.
void addMatrices(OIIO::ImageSpec &spec, const SceneDescription &scene) {
  Matrix4 toPicture, toSquare = Matrix4::identity();
  Camera(scene.camera).projection("NDC", toPicture);
  toSquare.m[0][0] = 2, toSquare.m[1][1] = -2;
  toSquare.m[3] = {-1, 1, 0, 1};
  auto add = [&](const char *name, const Matrix4 &matrix) {
    float numbers[16];
    for (size_t k = 0; k < 16; ++k)
      numbers[k] = float(matrix.m[k / 4][k % 4]);
    spec.attribute(name, OIIO::TypeMatrix, numbers);
  };
  add("worldtocamera", scene.worldToCamera);
  add("worldtoscreen", scene.worldToCamera * toPicture * toSquare);
}

OIIO::TypeDesc pixelType(const SceneDescription &scene, const OutputFile &output, bool linear) {
  if (linear)
    return output.half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
  return scene.quantizeOne > 255 ? OIIO::TypeDesc::UINT16 : OIIO::TypeDesc::UINT8;
}

} // namespace

void anysl::render::writeImage(const Film &film, const SceneDescription &scene,
                               const OutputFile &output) {
  if (output.format == "null")
    return;
  fs::path name = imageFileName(output);
  std::string suffix = name.extension().string(), format = imageFormat(output);
  bool isDepth = output.variables.size() == 1 && output.variables[0].name == "z";
  bool linear = format == "openexr" || format == "hdr" || suffix == ".pfm" ||
                (format == "tiff" && (isDepth || scene.quantizeOne == 0));

  fs::path temporary =
      name.parent_path() / ("." + name.stem().string() + "." + std::to_string(getpid()) + suffix);
  auto fail = [&](const std::string &reason) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    throw UserError(output.where, "cannot write '" + name.string() + "': " + reason);
  };
  auto file = OIIO::ImageOutput::create(format);
  if (!file)
    fail(OIIO::geterror());
  std::vector<FileChannel> channels = fileChannels(output, film.channels);
  OIIO::ImageSpec spec(film.width, film.height, int(channels.size()),
                       pixelType(scene, output, linear));
  spec.channelnames.clear();
  for (const FileChannel &channel : channels) {
    if (channel.source == FileChannel::Coverage)
      spec.alpha_channel = int(spec.channelnames.size());
    spec.channelnames.push_back(channel.name);
  }
  spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
  spec.attribute("Software", "AnySL " ANYSL_VERSION);
  if (!linear)
    spec.attribute("oiio:dither", 0);
  if (isDepth)
    addMatrices(spec, scene);

  std::vector<float> values;
  values.reserve(film.pixels.size() * channels.size());
  auto encode = [&](float value) {
    value *= float(scene.gain);
    if (linear)
      return value;
    return scene.gamma != 1 ? std::pow(std::clamp(value, 0.0f, 1.0f), float(1 / scene.gamma))
                            : encodeSRGB(value);
  };
  for (size_t i = 0; i < film.pixels.size(); ++i)
    for (const FileChannel &channel : channels) {
      float value = channel.source == FileChannel::Color ? film.pixels[i][channel.number]
                    : channel.source == FileChannel::Coverage
                        ? std::clamp(film.pixels[i][3], 0.0f, 1.0f)
                        : film.extra[i * film.channels.size() + channel.number];
      values.push_back(channel.isColor ? encode(value) : value);
    }
  if (!file->open(temporary.string(), spec) ||
      !file->write_image(OIIO::TypeDesc::FLOAT, values.data()) || !file->close())
    fail(file->geterror());
  std::error_code error;
  fs::rename(temporary, name, error);
  if (error)
    fail(error.message());
}
