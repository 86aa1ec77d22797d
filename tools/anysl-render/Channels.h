//===-- tools/anysl-render/Channels.h - what pictures show besides colour ------------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_CHANNELS_H
#define ANYSL_RENDER_CHANNELS_H

#include "lib/Rib/SceneDescription.h"

#include <span>

namespace anysl::render {

struct Shader;

/// A value besides colour and coverage that some file shows.
struct Channel {
  std::string name;
  enum Source {
    Depth,    ///< along the camera's axis; a pixel has the nearest of its samples
    Opacity,  ///< "Oi": how much of each colour from beyond is hidden
    Global,   ///< a shader's global variable
    Parameter ///< a shader's output parameter
  } source = Parameter;
  int global = -1; ///< AnyslGlobal
  ValueType type = ValueType::Float;
  unsigned components = 1;
  unsigned first = 0; ///< of its numbers among those of a pixel
  /// Whether light from behind adds to it, as it does to colour; otherwise the nearest surface that
  /// is not wholly transparent counts.
  bool isLight() const { return source == Parameter && type == ValueType::Color; }
};

/// The channels that a scene's files ask for.
class Channels {
public:
  Channels() = default;
  /// Types that the scene does not state come from the shaders, which may be null. Warns of names
  /// that no shader knows. Tells the shaders which of their outputs are wanted.
  Channels(const SceneDescription &scene, std::span<const std::unique_ptr<Shader>> shaders,
           Warnings &warnings);

  /// All of a pixel's numbers.
  unsigned size() const { return total; }
  const std::vector<Channel> &list() const { return channels; }
  const Channel *find(std::string_view name) const;
  /// The globals that shaders have to store for them, as bits 1 << ANYSL_P ...
  uint64_t globals() const { return wantedGlobals; }
  /// A pixel's numbers where there is no surface.
  void clear(float *numbers) const;

private:
  void add(const OutputVariable &variable, const Location &where,
           std::span<const std::unique_ptr<Shader>> shaders, Warnings &warnings);

  std::vector<Channel> channels;
  unsigned total = 0;
  uint64_t wantedGlobals = 0;
};

} // namespace anysl::render

#endif
