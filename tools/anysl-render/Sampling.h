//===-- tools/anysl-render/Sampling.h - random numbers and pixel samples ----------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Every number comes from hashing what it is for: the pixel, the sample, the way of the ray. So a
// picture does not depend on the number of threads, the width of packets or the runtime.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_SAMPLING_H
#define ANYSL_RENDER_SAMPLING_H

#include "lib/Rib/SceneDescription.h"

namespace anysl::render {

/// Mixes two numbers into one whose bits all depend on all of theirs (the finaliser of Appleby's
/// MurmurHash3).
inline uint32_t hash(uint32_t a, uint32_t b) {
  uint32_t h = a * 0x9e3779b1u ^ (b + 0x7f4a7c15u + (a << 6) + (a >> 2));
  h ^= h >> 16;
  h *= 0x85ebca6bu;
  h ^= h >> 13;
  h *= 0xc2b2ae35u;
  return h ^ h >> 16;
}

/// A number in [0, 1) from the upper bits of a hash.
inline double unitNumber(uint32_t h) { return (h >> 8) * 0x1p-24; }

/// A sample of one pixel: its place on the raster, where the pixel (x, y) covers [x, x + 1).
struct PixelSample {
  double x, y;
  uint32_t seed;
  double weight = 1;           ///< negative where the filter is
  double lensX = 0, lensY = 0; ///< on the disk of radius 1
};

/// Places samples as the pixel filter weights them, so that a pixel is the plain mean of its own
/// samples and no sample is shared between pixels (filter importance sampling). They are
/// stratified: one in each cell of a samplesX x samplesY grid, anywhere there or in its middle.
/// Where a filter is negative, so is the sample's weight.
class PixelSampler {
public:
  explicit PixelSampler(const SceneDescription &scene);
  unsigned samplesPerPixel() const { return unsigned(countX * countY); }
  PixelSample sample(int x, int y, unsigned index) const;
  /// Whether samples have weights, whose sum a pixel has to be divided by.
  bool hasWeights() const { return !tableX.places.empty(); }

private:
  /// A filter of one direction in steps of equal weight, all of them counted as positive.
  struct Table {
    std::vector<double> places; ///< in pixels from the middle
    std::vector<double> signs;
  };
  static Table makeTable(FilterKind filter, double width);
  /// The place in [-1/2, 1/2] of the filter's width below which a share of its weight lies.
  double warp(double share) const;

  int countX, countY;
  bool jitter;
  FilterKind filter;
  double widthX, widthY;
  std::vector<double> gaussian; ///< warp() at evenly spaced shares
  Table tableX, tableY;         ///< of filters that are negative somewhere, and the like
};

} // namespace anysl::render

#endif
