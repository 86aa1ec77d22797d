//===-- test/unit/render/PictureErrorTest.cpp - differences of pictures -----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/PictureError.h"
#include <catch2/catch.hpp>
#include <random>

using namespace anysl::render;

namespace {

Film uniform(float red, float green, float blue) {
  Film film;
  film.width = 48;
  film.height = 40;
  film.pixels.assign(size_t(film.width * film.height), {red, green, blue, 1});
  return film;
}

Film noisy(Film film, float amount) {
  std::minstd_rand random(5);
  for (auto &pixel : film.pixels)
    for (size_t k = 0; k < 3; ++k)
      pixel[k] += amount * (float(random() % 2001) / 1000 - 1);
  return film;
}

} // namespace

TEST_CASE("Equal pictures do not differ", "[picture-error]") {
  Film film = noisy(uniform(0.4f, 0.5f, 0.6f), 0.3f);
  CHECK(flipMean(film, film) == 0);
  CHECK(rootMeanSquare(film, film) == 0);
}

TEST_CASE("The root mean square of a constant difference is that difference", "[picture-error]") {
  CHECK(rootMeanSquare(uniform(0.25f, 0.5f, 1), uniform(0.5f, 0.75f, 1.25f)) == Approx(0.25));
  CHECK(rootMeanSquare(uniform(0, 0, 0), uniform(3, 0, 0)) == Approx(std::sqrt(3.0)));
}

TEST_CASE("Nothing differs more than green and blue, by the scale's definition",
          "[picture-error]") {
  CHECK(flipMean(uniform(0, 1, 0), uniform(0, 0, 1)) == Approx(1).epsilon(1e-6));
  CHECK(flipMean(uniform(0, 0, 0), uniform(1, 1, 1)) < 1);
  CHECK(flipMean(uniform(0, 0, 0), uniform(1, 1, 1)) > 0.9);
}

TEST_CASE("More noise is a greater difference, and less is seen of it than of a shift",
          "[picture-error]") {
  Film gray = uniform(0.2f, 0.2f, 0.2f);
  double little = flipMean(gray, noisy(gray, 0.01f)), more = flipMean(gray, noisy(gray, 0.1f));
  CHECK(0 < little);
  CHECK(little < more);
  // The same root mean square, but all pixels move together.
  Film shifted = gray;
  double noise = rootMeanSquare(gray, noisy(gray, 0.1f));
  for (auto &pixel : shifted.pixels)
    for (size_t k = 0; k < 3; ++k)
      pixel[k] += float(noise);
  CHECK(rootMeanSquare(gray, shifted) == Approx(noise).epsilon(1e-3));
  CHECK(more < flipMean(gray, shifted));
}

TEST_CASE("What is beyond a screen's range is not seen", "[picture-error]") {
  CHECK(flipMean(uniform(1, 1, 1), uniform(4, 2, 9)) == 0);
  CHECK(flipMean(uniform(0, 0, 0), uniform(-1, 0, 0)) == 0);
}
