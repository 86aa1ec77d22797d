//===-- tools/anysl-render/Film.h - the picture and its files ---------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_FILM_H
#define ANYSL_RENDER_FILM_H

#include "tools/anysl-render/Channels.h"

namespace anysl::render {

/// Linear colours and coverage, row by row from the top.
struct Film {
  int width = 0, height = 0;
  std::vector<std::array<float, 4>> pixels;
  Channels channels;
  std::vector<float> extra; ///< of each pixel, the numbers of the channels
  /// Pixels for which a shader returned a number that is none, or infinity. Those samples are left
  /// out of the pixel's mean.
  uint64_t badPixels = 0;
};

/// A picture's file: a name without a suffix gets that of the type that the scene states.
std::string imageFileName(const OutputFile &output);

/// Throws UserError where the file's type is not known or its folder does not exist: better before
/// rendering than after.
void checkOutput(const OutputFile &output);

/// Writes the picture. Floating-point formats get the linear values times the exposure's gain;
/// others are encoded as sRGB, or, where the scene asks for a gamma other than 1, by that gamma.
/// The file appears under its name only when it is complete. Throws UserError where it cannot be
/// written.
void writeImage(const Film &film, const SceneDescription &scene, const OutputFile &output);

/// The sRGB encoding of a linear value: monotone, 0 for what is not positive, 1 from 1 on.
float encodeSRGB(float linear);

} // namespace anysl::render

#endif
