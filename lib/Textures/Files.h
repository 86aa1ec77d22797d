//===-- lib/Textures/Files.h - the files of a texture system ------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEXTURES_FILES_H
#define ANYSL_TEXTURES_FILES_H

#include "lib/Textures/Directions.h"
#include "lib/Textures/Textures.h"

#include <OpenImageIO/texture.h>

#include <map>
#include <mutex>
#include <set>
#include <shared_mutex>

namespace anysl::textures {

/// What is known of a file, once it has been looked for.
struct File {
  OIIO::TextureSystem::TextureHandle *handle = nullptr; ///< null: it cannot be read
  int channels = 0;
  EnvironmentLayout layout = EnvironmentLayout::LatLongZUp;
  /// For shadow maps, row by row, for row vectors: world to the light's camera, and to the picture,
  /// whose x and y go from -1 to 1.
  std::optional<std::array<float, 16>> worldToCamera, worldToScreen;
};

/// Finds files by name, each once, and warns of each that is not there.
class Files {
public:
  explicit Files(TextureSettings settings);
  ~Files();
  Files(const Files &) = delete;
  Files &operator=(const Files &) = delete;

  const File &find(const char *name);
  /// Whether a file can be read; says nothing if not.
  bool exists(const std::string &name);
  /// As Textures has it.
  void tellPlaces(std::function<void(const std::string &)> tell);
  /// Passes a message on that has not been given before.
  void warnOnce(const std::string &message);
  OIIO::TextureSystem &system() { return *theSystem; }

private:
  File open(const std::string &name);
  void notePlaces(const std::string &name);

  TextureSettings settings;
  OIIO::TextureSystem *theSystem;
  std::shared_mutex mutex;
  std::map<std::string, std::unique_ptr<const File>, std::less<>> files;
  std::mutex warningMutex;
  std::set<std::string> warnings;
  std::mutex placesMutex;
  std::set<std::string> places; ///< of all that was asked for
  std::function<void(const std::string &)> tell;
};

} // namespace anysl::textures

#endif
