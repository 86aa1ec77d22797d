//===-- tools/anysl-render/TrimRegion.cpp - what trim curves leave ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/TrimRegion.h"

#include <algorithm>

using namespace anysl::render;

TrimRegion::TrimRegion(std::span<const Outline> outlines, bool isOutside) : isOutside(isOutside) {
  double high = 0;
  size_t lines = 0;
  for (const Outline &outline : outlines)
    for (Point p : outline) {
      low = lines == 0 ? p.v : std::min(low, p.v);
      high = lines == 0 ? p.v : std::max(high, p.v);
      ++lines;
    }
  if (!(high > low))
    return;
  rows.resize(std::clamp<size_t>(lines / 2, 1, 1024));
  scale = double(rows.size()) / (high - low);
  for (const Outline &outline : outlines)
    for (size_t i = 0; i < outline.size(); ++i) {
      Line line{outline[i], outline[(i + 1) % outline.size()]};
      auto [first, last] = std::minmax(rowOf(line.from.v), rowOf(line.to.v));
      for (size_t row = first; row <= last; ++row)
        rows[row].push_back(line);
    }
}

size_t TrimRegion::rowOf(double v) const {
  double row = (v - low) * scale;
  return row > 0 ? size_t(std::min(row, double(rows.size()) - 0.5)) : 0; // 0 for what is no number
}

bool TrimRegion::contains(double u, double v) const {
  bool isInside = false;
  if (!rows.empty())
    for (const auto &[a, b] : rows[rowOf(v)])
      // Of a line that goes on where another ends, one of the two counts.
      if ((a.v > v) != (b.v > v) && u < a.u + (b.u - a.u) * ((v - a.v) / (b.v - a.v)))
        isInside = !isInside;
  return isInside != isOutside;
}
