//===-- test/unit/render/ImageTest.cpp - the picture's files
//-----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Film.h"

#include <catch2/catch.hpp>

using namespace anysl::render;

TEST_CASE("sRGB encoding follows IEC 61966-2-1 and is monotone", "[image]") {
  CHECK(encodeSRGB(0) == 0);
  CHECK(encodeSRGB(1) == 1);
  CHECK(encodeSRGB(0.5f) == Approx(0.7353569f));
  CHECK(encodeSRGB(0.18f) == Approx(0.4613561f));
  CHECK(encodeSRGB(0.002f) == Approx(0.02584f));
  CHECK(encodeSRGB(-1e-6f) == 0);
  CHECK(encodeSRGB(-INFINITY) == 0);
  CHECK(encodeSRGB(INFINITY) == 1);
  CHECK(encodeSRGB(NAN) == 0);
  float last = 0;
  for (float x = 0; x < 1.01f; x += 1e-4f) {
    CHECK(encodeSRGB(x) >= last);
    last = encodeSRGB(x);
  }
}

TEST_CASE("a file's type follows from its suffix, else from the scene", "[image]") {
  auto name = [](const char *file, const char *format) {
    return imageFileName({file, format, {}, false, false, {}});
  };
  CHECK(name("a.exr", "file") == "a.exr");
  CHECK(name("a", "openexr") == "a.exr");
  CHECK(name("a", "tiff") == "a.tif");
  CHECK(name("a", "framebuffer") == "a.png");
}
