//===-- lib/Shade/ImageModule.cpp - writes images through OpenImageIO -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A module of its own, loaded when an image is asked for: OpenImageIO brings some 250 shared
// libraries, which take longer to load than a grid to shade.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Shade/ImageModule.h"
#include <OpenImageIO/imageio.h>
#include <cstdio>

static std::string write(const std::string &path, int width, int height, const double *rgb) {
  auto output = OIIO::ImageOutput::create(path);
  if (!output)
    return OIIO::geterror();
  // 8 and 16 bit formats convert by themselves: clamped to [0, 1], no gamma.
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
  spec.attribute("Software", "anysl-shade " ANYSL_VERSION);
  if (!output->open(path, spec))
    return output->geterror();
  std::string problem;
  if (!output->write_image(OIIO::TypeDesc::DOUBLE, rgb))
    problem = output->geterror();
  if (!output->close() && problem.empty())
    problem = output->geterror();
  if (!problem.empty())
    std::remove(path.c_str());
  return problem;
}

void anyslWriteImage(const char *path, int width, int height, const double *rgb,
                     std::string *problem) {
  *problem = write(path, width, height, rgb);
}

void anyslMakeTextures(anysl::textures::TextureSettings settings,
                       std::unique_ptr<anysl::textures::Textures> *textures) {
  *textures = anysl::textures::Textures::create(std::move(settings));
}
