//===-- tools/anysl-render/TrimRegion.h - what trim curves leave ------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_TRIMREGION_H
#define ANYSL_RENDER_TRIMREGION_H

#include <span>
#include <vector>

namespace anysl::render {

/// The part of a surface's parameters that closed outlines leave: what lies within an odd number of
/// them, or what does not. Rays that meet the surface elsewhere go on, so that a trimmed edge is
/// exact however coarse the facets are.
class TrimRegion {
public:
  struct Point {
    double u, v;
  };
  using Outline = std::vector<Point>; ///< from each point to the next, and back to the first

  TrimRegion(std::span<const Outline> outlines, bool isOutside);
  bool contains(double u, double v) const;

private:
  struct Line {
    Point from, to;
  };
  /// The row that v is in, or the one nearest to it.
  size_t rowOf(double v) const;

  bool isOutside;
  double low = 0, scale = 0;           ///< of v to rows
  std::vector<std::vector<Line>> rows; ///< the lines that reach into each
};

} // namespace anysl::render

#endif
