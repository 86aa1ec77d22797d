//===-- tools/anysl-render/Sampling.cpp - random numbers and pixel samples --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Sampling.h"

using namespace anysl::render;

PixelSampler::PixelSampler(const SceneDescription &scene)
    : countX(scene.samplesX), countY(scene.samplesY), filter(scene.filter),
      widthX(scene.filterWidthX), widthY(scene.filterWidthY) {
  if (filter != FilterKind::Gaussian)
    return;
  // The standard's RiGaussianFilter is exp(-2 (2x/width)²), cut off at the width: with z = x/width
  // in [-1/2, 1/2] that is exp(-8 z²), whose integral is an error function. Invert it by bisection.
  const double total = std::erf(std::sqrt(8.0) / 2);
  constexpr int steps = 1024;
  for (int i = 0; i <= steps; ++i) {
    double target = (2.0 * i / steps - 1) * total, low = -0.5, high = 0.5;
    for (int k = 0; k < 50; ++k) {
      double middle = 0.5 * (low + high);
      (std::erf(std::sqrt(8.0) * middle) < target ? low : high) = middle;
    }
    gaussian.push_back(0.5 * (low + high));
  }
}

double PixelSampler::warp(double share) const {
  switch (filter) {
  case FilterKind::Box:
    return share - 0.5;
  case FilterKind::Triangle:
    return share < 0.5 ? 0.5 * (std::sqrt(2 * share) - 1) : 0.5 * (1 - std::sqrt(2 - 2 * share));
  case FilterKind::Gaussian: {
    double place = share * double(gaussian.size() - 1);
    size_t cell = std::min(size_t(place), gaussian.size() - 2);
    double fraction = place - double(cell);
    return gaussian[cell] * (1 - fraction) + gaussian[cell + 1] * fraction;
  }
  }
  return 0;
}

PixelSample PixelSampler::sample(int x, int y, unsigned index) const {
  uint32_t seed = hash(hash(uint32_t(x), uint32_t(y)), index);
  int cellX = int(index) % countX, cellY = int(index) / countX;
  double shareX = (cellX + unitNumber(hash(seed, 1))) / countX;
  double shareY = (cellY + unitNumber(hash(seed, 2))) / countY;
  return {x + 0.5 + warp(shareX) * widthX, y + 0.5 + warp(shareY) * widthY, seed};
}
