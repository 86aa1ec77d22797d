//===-- lib/Plot/HeatMap.h - a value at every place of a grid, as a picture --------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_PLOT_HEATMAP_H
#define ANYSL_LIB_PLOT_HEATMAP_H

#include <string>
#include <vector>

namespace anysl::plot {

struct HeatMap {
  std::string title, xLabel, yLabel;
  unsigned width = 0, height = 0;
  /// Row by row from the top: from 0 to `largest`; above, a colour of its own; NaN: none is known.
  std::vector<double> values;
  double largest = 1;
  std::string unit;      ///< of the values, for the scale beside the map
  std::string aboveName; ///< what it means to be above `largest`; empty: nothing is
};

/// The map as an <svg> element for a page().
std::string svg(const HeatMap &map);

/// At most \p side columns and rows: each of the new ones has the largest of those that it stands
/// for.
HeatMap reduced(const HeatMap &map, unsigned side);

} // namespace anysl::plot

#endif
