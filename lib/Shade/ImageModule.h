//===-- lib/Shade/ImageModule.h - writes images, in a module of its own -------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SHADE_IMAGEMODULE_H
#define ANYSL_LIB_SHADE_IMAGEMODULE_H

#include "lib/Textures/Textures.h"
#include <string>

/// Writes red, green and blue of width * height pixels, the top row first. What goes wrong is put
/// into
/// \p problem, and no file is left.
extern "C" __attribute__((visibility("default"))) void
anyslWriteImage(const char *path, int width, int height, const double *rgb, std::string *problem);

/// Makes what looks pictures up.
extern "C" void anyslMakeTextures(anysl::textures::TextureSettings settings,
                                  std::unique_ptr<anysl::textures::Textures> *textures);

#endif
