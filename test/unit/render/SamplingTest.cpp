//===-- test/unit/render/SamplingTest.cpp - random numbers and pixel samples
//-------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Sampling.h"

#include <catch2/catch.hpp>

#include <set>

using namespace anysl::render;

namespace {
SceneDescription sceneWith(FilterKind filter, double width) {
  SceneDescription scene;
  scene.samplesX = scene.samplesY = 16;
  scene.filter = filter;
  scene.filterWidthX = scene.filterWidthY = width;
  return scene;
}
} // namespace

TEST_CASE("samples are spread as the filter weighs", "[sampling]") {
  // Variances of the filters over their width w, in closed form: box w²/12, triangle w²/24; of the
  // truncated Gaussian exp(-8 z²), z in [-1/2, 1/2], by its moments.
  double cut = std::exp(-2.0), mass = std::sqrt(3.14159265358979 / 8) * std::erf(std::sqrt(2.0));
  double gaussian = 1.0 / 16 - cut / (16 * mass);
  struct {
    FilterKind kind;
    double variance;
  } const cases[] = {{FilterKind::Box, 1.0 / 12},
                     {FilterKind::Triangle, 1.0 / 24},
                     {FilterKind::Gaussian, gaussian}};
  for (auto [kind, variance] : cases) {
    double width = 3;
    PixelSampler sampler(sceneWith(kind, width));
    double sum = 0, squares = 0;
    unsigned count = 0;
    for (int x = 0; x < 20; ++x)
      for (unsigned i = 0; i < sampler.samplesPerPixel(); ++i) {
        double offset = sampler.sample(x, 5, i).x - (x + 0.5);
        CHECK(std::fabs(offset) <= width / 2);
        sum += offset;
        squares += offset * offset;
        ++count;
      }
    CHECK(sum / count == Approx(0).margin(0.01));
    CHECK(squares / count == Approx(variance * width * width).epsilon(0.02));
  }
}

TEST_CASE("filters that are negative somewhere weigh their samples", "[sampling]") {
  // Second moments: a Catmull-Rom spline reproduces parabolas, so that its own is 0; of Mitchell's
  // cubic at width 4 it is 1/9; of the Blackman-Harris window by integrating its cosines.
  const double pi2 = 9.869604401089358;
  double harris =
      (0.35875 / 12 - 0.48829 / (2 * pi2) + 0.14128 / (8 * pi2) - 0.01168 / (18 * pi2)) / 0.35875;
  struct {
    FilterKind kind;
    double moment;
  } const cases[] = {{FilterKind::CatmullRom, 0},
                     {FilterKind::Mitchell, 1.0 / 9},
                     {FilterKind::BlackmanHarris, 16 * harris},
                     // A disk of diameter w has w^2 / 16 in each direction.
                     {FilterKind::Disk, 1}};
  for (auto [kind, moment] : cases) {
    PixelSampler sampler(sceneWith(kind, 4));
    double sum = 0, weights = 0;
    for (int x = 0; x < 20; ++x)
      for (unsigned i = 0; i < sampler.samplesPerPixel(); ++i) {
        PixelSample sample = sampler.sample(x, 7, i);
        CHECK(std::fabs(sample.x - x - 0.5) <= 2);
        sum += sample.weight * (sample.x - x - 0.5) * (sample.x - x - 0.5);
        weights += sample.weight;
      }
    CHECK(sum / weights == Approx(moment).margin(0.02));
  }
}

TEST_CASE("places on the lens fill a disk evenly, whatever the place in the pixel", "[sampling]") {
  PixelSampler sampler(sceneWith(FilterKind::Box, 1));
  double squares = 0, mixed = 0;
  std::set<std::pair<int, int>> cells;
  for (unsigned i = 0; i < 256; ++i) {
    PixelSample sample = sampler.sample(3, 4, i);
    double square = sample.lensX * sample.lensX + sample.lensY * sample.lensY;
    CHECK(square < 1);
    squares += square / 256;
    mixed += sample.lensX * (sample.x - 3.5) / 256;
    double angle = std::atan2(sample.lensY, sample.lensX) / (2 * 3.14159265358979);
    cells.insert({int(square * 16), int((angle < 0 ? angle + 1 : angle) * 16)});
  }
  CHECK(squares == Approx(0.5).margin(0.01));
  CHECK(std::fabs(mixed) < 0.02);
  CHECK(cells.size() > 250); // one in each of 16 x 16 cells, but for rounding
}

TEST_CASE("a box filter of width 1 puts one sample into each cell of its pixel", "[sampling]") {
  PixelSampler sampler(sceneWith(FilterKind::Box, 1));
  std::set<std::pair<int, int>> cells;
  for (unsigned i = 0; i < sampler.samplesPerPixel(); ++i) {
    PixelSample sample = sampler.sample(12, 34, i);
    cells.insert({int((sample.x - 12) * 16), int((sample.y - 34) * 16)});
  }
  CHECK(cells.size() == 256);
}

TEST_CASE("seeds differ between pixels and samples, and come out the same again", "[sampling]") {
  PixelSampler sampler(sceneWith(FilterKind::Box, 1));
  std::set<uint32_t> seeds;
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 16; ++y)
      for (unsigned i = 0; i < 16; ++i)
        seeds.insert(sampler.sample(x, y, i).seed);
  CHECK(seeds.size() == 4096);
  CHECK(sampler.sample(3, 4, 5).seed ==
        PixelSampler(sceneWith(FilterKind::Box, 1)).sample(3, 4, 5).seed);
}

TEST_CASE("every bit of a hash depends on every bit of what is hashed", "[sampling]") {
  for (int bit = 0; bit < 32; ++bit) {
    int changed = 0;
    for (uint32_t i = 0; i < 1000; ++i)
      changed += __builtin_popcount(hash(i, 42) ^ hash(i ^ (1u << bit), 42));
    CHECK(changed / 1000.0 == Approx(16).margin(1.5));
  }
}
