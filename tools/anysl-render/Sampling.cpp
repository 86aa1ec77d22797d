//===-- tools/anysl-render/Sampling.cpp - random numbers and pixel samples --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Sampling.h"

#include <algorithm>
#include <numbers>

using namespace anysl::render;

namespace {

/// A filter at x pixels from its middle; those named after the interface's standard filters follow
/// the specification's formulas, one direction at a time.
double filterAt(FilterKind filter, double x, double width) {
  using std::numbers::pi;
  x = std::fabs(x);
  switch (filter) {
  case FilterKind::CatmullRom:
    return x < 1 ? ((1.5 * x - 2.5) * x * x + 1) : (x < 2 ? ((-0.5 * x + 2.5) * x - 4) * x + 2 : 0);
  case FilterKind::Sinc: // windowed by a cosine, so that it ends at 0
    return (x < 1e-9 ? 1 : std::sin(pi * x) / (pi * x)) * std::cos(pi * x / width);
  case FilterKind::Mitchell: { // Mitchell and Netravali 1988, B = C = 1/3
    x *= 4 / width;
    return x < 1 ? (7 * x * x * x - 12 * x * x + 16.0 / 3) / 6
                 : (x < 2 ? (-7.0 / 3 * x * x * x + 12 * x * x - 20 * x + 32.0 / 3) / 6 : 0);
  }
  case FilterKind::BlackmanHarris: { // Harris 1978, the minimum of four terms
    double angle = 2 * pi * (0.5 - x / width);
    return 0.35875 - 0.48829 * std::cos(angle) + 0.14128 * std::cos(2 * angle) -
           0.01168 * std::cos(3 * angle);
  }
  default:
    return 1;
  }
}

/// Place `index` of `count` in a random order (the permutation of Kensler, Correlated
/// Multi-Jittered Sampling, 2013).
uint32_t permute(uint32_t index, uint32_t count, uint32_t seed) {
  uint32_t mask = count - 1;
  for (uint32_t shift : {1, 2, 4, 8, 16})
    mask |= mask >> shift;
  do {
    index ^= seed;
    index *= 0xe170893d;
    index ^= seed >> 16;
    index ^= (index & mask) >> 4;
    index ^= seed >> 8;
    index *= 0x0929eb3f;
    index ^= seed >> 23;
    index ^= (index & mask) >> 1;
    index *= 1 | seed >> 27;
    index *= 0x6935fa69;
    index ^= (index & mask) >> 11;
    index *= 0x74dcb303;
    index ^= (index & mask) >> 2;
    index *= 0x9e501cc3;
    index ^= (index & mask) >> 2;
    index *= 0xc860a3df;
    index &= mask;
    index ^= index >> 5;
  } while (index >= count);
  return (index + seed) % count;
}

} // namespace

PixelSampler::PixelSampler(const SceneDescription &scene)
    : countX(scene.samplesX), countY(scene.samplesY), jitter(scene.jitter), filter(scene.filter),
      widthX(scene.filterWidthX), widthY(scene.filterWidthY) {
  if (filter >= FilterKind::CatmullRom && filter != FilterKind::Disk) {
    tableX = makeTable(filter, widthX);
    tableY = makeTable(filter, widthY);
  }
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

PixelSampler::Table PixelSampler::makeTable(FilterKind filter, double width) {
  constexpr size_t cells = 4096, steps = 1024;
  std::vector<double> sums{0};
  auto place = [&](double cell) { return ((cell + 0.5) / cells - 0.5) * width; };
  for (size_t i = 0; i < cells; ++i)
    sums.push_back(sums.back() + std::fabs(filterAt(filter, place(double(i)), width)));
  Table table;
  for (size_t i = 0; i < steps; ++i) {
    double target = (double(i) + 0.5) / steps * sums.back();
    auto cell = std::upper_bound(sums.begin(), sums.end(), target) - sums.begin() - 1;
    cell = std::clamp<ptrdiff_t>(cell, 0, cells - 1);
    table.places.push_back(place(double(cell)));
    table.signs.push_back(filterAt(filter, table.places.back(), width) < 0 ? -1 : 1);
  }
  return table;
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
  default:
    return 0;
  }
}

PixelSample PixelSampler::sample(int x, int y, unsigned index) const {
  uint32_t seed = hash(hash(uint32_t(x), uint32_t(y)), index);
  int cellX = int(index) % countX, cellY = int(index) / countX;
  double shareX = (cellX + (jitter ? unitNumber(hash(seed, 1)) : 0.5)) / countX;
  double shareY = (cellY + (jitter ? unitNumber(hash(seed, 2)) : 0.5)) / countY;
  PixelSample sample{x + 0.5 + warp(shareX) * widthX, y + 0.5 + warp(shareY) * widthY, seed};
  if (hasWeights()) {
    size_t i = size_t(shareX * double(tableX.places.size()));
    size_t j = size_t(shareY * double(tableY.places.size()));
    sample.x += tableX.places[i];
    sample.y += tableY.places[j];
    sample.weight = tableX.signs[i] * tableY.signs[j];
  } else if (filter == FilterKind::Disk) {
    double radius = 0.5 * std::sqrt(shareX), angle = 2 * std::numbers::pi * shareY;
    sample.x += widthX * radius * std::cos(angle);
    sample.y += widthY * radius * std::sin(angle);
  }
  // Stratified as well, and in an order that has nothing to do with the place in the pixel.
  uint32_t cell = permute(index, samplesPerPixel(), hash(hash(uint32_t(x), uint32_t(y)), 3));
  double radius = std::sqrt((cell % unsigned(countX) + unitNumber(hash(seed, 4))) / countX);
  double angle =
      2 * std::numbers::pi * (cell / unsigned(countX) + unitNumber(hash(seed, 5))) / countY;
  sample.lensX = radius * std::cos(angle);
  sample.lensY = radius * std::sin(angle);
  return sample;
}
