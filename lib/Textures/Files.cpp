//===-- lib/Textures/Files.cpp - the files of a texture system ----------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Textures/Files.h"

#include <OpenImageIO/strutil.h>

#include <filesystem>

namespace anysl::textures {
namespace {

std::optional<std::array<float, 16>> matrixOf(const OIIO::ImageSpec &spec, const char *name) {
  const OIIO::ParamValue *value = spec.find_attribute(name, OIIO::TypeMatrix);
  if (!value)
    return std::nullopt;
  std::array<float, 16> matrix;
  std::copy_n(static_cast<const float *>(value->data()), 16, matrix.begin());
  return matrix;
}

EnvironmentLayout layoutOf(const OIIO::ImageSpec &spec) {
  int width = spec.full_width, height = spec.full_height;
  bool isCube = OIIO::Strutil::istarts_with(spec.get_string_attribute("textureformat"), "CubeFace");
  if (6 * width == height)
    return EnvironmentLayout::CubeColumn;
  if (isCube || 2 * width == 3 * height)
    return EnvironmentLayout::CubeRows;
  bool isYUp = spec.get_string_attribute("oiio:updirection") == "y";
  return isYUp ? EnvironmentLayout::LatLongYUp : EnvironmentLayout::LatLongZUp;
}

} // namespace

Files::Files(TextureSettings given)
    : settings(std::move(given)), theSystem(OIIO::TextureSystem::create(/*shared=*/false)) {
  theSystem->attribute("searchpath", OIIO::Strutil::join(settings.searchPath, ":"));
  // Pictures need not have been prepared: tiles and smaller sizes are made as they are asked for.
  theSystem->attribute("autotile", 64);
  theSystem->attribute("automip", 1);
  theSystem->attribute("max_memory_MB", 512.0f);
  // What a file lacks is this library's affair.
  theSystem->attribute("gray_to_rgb", 0);
}

Files::~Files() { OIIO::TextureSystem::destroy(theSystem, /*teardown_imagecache=*/true); }

const File &Files::find(const char *name) {
  {
    std::shared_lock lock(mutex);
    if (auto known = files.find(std::string_view(name)); known != files.end())
      return *known->second;
  }
  std::unique_lock lock(mutex);
  std::unique_ptr<const File> &file = files[name];
  if (!file)
    file = std::make_unique<const File>(open(name));
  return *file;
}

File Files::open(const std::string &name) {
  File file;
  if (name.empty()) {
    warnOnce("a texture has no name");
    return file;
  }
  notePlaces(name);
  OIIO::ImageSpec spec;
  auto *handle = theSystem->get_texture_handle(OIIO::ustring(name));
  bool good = handle && theSystem->get_imagespec(handle, nullptr, 0, spec);
  std::string reason = theSystem->geterror();
  if (!good) {
    warnOnce("cannot read texture '" + name + "'" + (reason.empty() ? "" : ": " + reason));
    return file;
  }
  file.handle = handle;
  file.channels = spec.nchannels;
  file.layout = layoutOf(spec);
  file.worldToCamera = matrixOf(spec, "worldtocamera");
  file.worldToScreen = matrixOf(spec, "worldtoscreen");
  return file;
}

bool Files::exists(const std::string &name) {
  if (name.empty())
    return false;
  notePlaces(name);
  OIIO::ImageSpec spec;
  auto *handle = theSystem->get_texture_handle(OIIO::ustring(name));
  bool good = handle && theSystem->get_imagespec(handle, nullptr, 0, spec);
  theSystem->geterror(); // which nobody asked for
  return good;
}

void Files::notePlaces(const std::string &name) {
  std::lock_guard lock(placesMutex);
  auto note = [&](const std::filesystem::path &path) {
    if (places.insert(path.string()).second && tell)
      tell(path.string());
    std::error_code error;
    return std::filesystem::exists(path, error);
  };
  if (std::filesystem::path(name).is_absolute()) {
    note(name);
    return;
  }
  for (const std::string &folder : settings.searchPath)
    if (note(std::filesystem::path(folder) / name))
      return;
}

void Files::tellPlaces(std::function<void(const std::string &)> newTell) {
  std::lock_guard lock(placesMutex);
  tell = std::move(newTell);
  for (const std::string &path : places)
    tell(path);
}

void Files::warnOnce(const std::string &message) {
  std::lock_guard lock(warningMutex);
  if (warnings.insert(message).second && settings.warn)
    settings.warn(message);
}

} // namespace anysl::textures
