//===-- lib/Textures/Textures.h - the texture services of a renderer ----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What AnyslServices asks about pictures, answered by OpenImageIO's texture system. This header
// names nothing of that library, so that a program can load the implementation when it needs it.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEXTURES_TEXTURES_H
#define ANYSL_TEXTURES_TEXTURES_H

#include <anysl/abi.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace anysl::textures {

struct TextureSettings {
  /// The folders in which relative names are looked for, in order.
  std::vector<std::string> searchPath;
  /// Takes one message for each file that cannot be read. Called by one thread at a time.
  std::function<void(const std::string &)> warn;
};

/// One answer of textureinfo(): numbers or text.
struct TextureFact {
  std::vector<double> numbers;
  std::optional<std::string> text;
};

/// The files of one run. Every function may be called by many threads at once.
///
/// Rows of a picture run from t = 0 at its top to t = 1, and values are what the file says, without
/// a conversion of colour spaces; alpha is premultiplied. A file that cannot be read shows as the
/// `fill` of the lookup if there is one, else as magenta and black squares.
class Textures {
public:
  static std::unique_ptr<Textures> create(TextureSettings settings);
  virtual ~Textures() = default;

  // As AnyslServices describes them.
  virtual void texture(const AnyslShadeArgs *args, uint32_t width, uint32_t mask,
                       const AnyslTextureRequest &request, const AnyslTexturePoints &points,
                       float *result) = 0;
  virtual void environment(const AnyslShadeArgs *args, uint32_t width, uint32_t mask,
                           const AnyslTextureRequest &request, const AnyslTexturePoints &points,
                           float *result) = 0;
  virtual void shadow(const AnyslShadeArgs *args, uint32_t width, uint32_t mask,
                      const AnyslTextureRequest &request, const AnyslTexturePoints &points,
                      float *result) = 0;

  /// What is known of a file: "exists", "resolution", "type", "channels", "viewingmatrix",
  /// "projectionmatrix" or the name of an entry of the file's metadata. Nothing where there is no
  /// such fact.
  virtual std::optional<TextureFact> fact(const std::string &file, const std::string &name) = 0;

  /// Has `tell` called with the places where each file is looked for, up to the one where it is:
  /// now for those that have been asked for, and for others before they are opened. Called by one
  /// thread at a time.
  virtual void tellPlaces(std::function<void(const std::string &path)> tell) = 0;
};

/// The function by which a module that is loaded at run time offers Textures::create().
using TexturesMaker = std::unique_ptr<Textures>(TextureSettings settings);

} // namespace anysl::textures

#endif
