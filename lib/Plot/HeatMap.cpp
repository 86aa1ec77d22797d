//===-- lib/Plot/HeatMap.cpp - a value at every place of a grid, as a picture -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Plot/HeatMap.h"
#include "lib/Plot/Svg.h"
#include <algorithm>
#include <cmath>

namespace anysl::plot {
namespace {

constexpr double left = 60, top = 40, side = 440, bar = 16, below = 40;
constexpr int levels = 12; ///< of the colour

/// 0 to `levels`, one more above the largest; -1 where nothing is to be drawn.
int levelOf(const HeatMap &map, double value) {
  if (std::isnan(value) || value <= 0)
    return -1;
  if (value > map.largest)
    return levels + 1;
  return int(std::ceil(value / map.largest * levels));
}

std::string rectangle(double x, double y, double w, double h, int level) {
  const char *kind = level > levels ? "above" : "heat";
  double opacity = level > levels ? 1 : double(level) / levels;
  return format("<rect class=\"%s\" x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" "
                "fill-opacity=\"%.2f\" shape-rendering=\"crispEdges\"/>\n",
                kind, x, y, w, h, opacity);
}

/// The colours beside the map, the largest on top.
std::string scale(const HeatMap &map, double x, double height) {
  std::string text;
  double step = height / levels;
  for (int level = 1; level <= levels; ++level)
    text += rectangle(x, top + height - level * step, bar, step, level);
  text += format("<rect class=\"frame\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n",
                 x, top, bar, height);
  text += textAt(x + bar + 6, top + 9, "class=\"tick\"", shortNumber(map.largest) + " " + map.unit);
  text += textAt(x + bar + 6, top + height, "class=\"tick\"", "0");
  if (!map.aboveName.empty()) {
    text += rectangle(x, top + height + 12, bar, 12, levels + 1);
    text += textAt(x + bar + 6, top + height + 22, "class=\"tick\"", map.aboveName);
  }
  return text;
}

} // namespace

HeatMap reduced(const HeatMap &map, unsigned side) {
  if (map.width <= side && map.height <= side)
    return map;
  HeatMap result = map;
  result.width = std::min(map.width, side);
  result.height = std::min(map.height, side);
  result.values.assign(size_t(result.width) * result.height, std::nan(""));
  for (size_t y = 0; y < map.height; ++y)
    for (size_t x = 0; x < map.width; ++x) {
      double value = map.values[y * map.width + x];
      double &known =
          result
              .values[y * result.height / map.height * result.width + x * result.width / map.width];
      if (!std::isnan(value) && !(known >= value))
        known = value;
    }
  return result;
}

std::string svg(const HeatMap &map) {
  double cell = side / std::max({map.width, map.height, 1u});
  double w = cell * map.width, h = cell * map.height;
  double total = std::max(h, 120.0) + top + below;
  std::string text = format("<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" "
                            "viewBox=\"0 0 %g %g\" role=\"img\">\n",
                            980.0, total);
  text += textAt(left, 24, "class=\"title\"", map.title);
  for (unsigned y = 0; y < map.height; ++y)
    for (unsigned x = 0, end; x < map.width; x = end) {
      // Neighbours of one colour are one rectangle.
      int level = levelOf(map, map.values[size_t(y) * map.width + x]);
      for (end = x + 1; end < map.width; ++end)
        if (levelOf(map, map.values[size_t(y) * map.width + end]) != level)
          break;
      if (level >= 0)
        text += rectangle(left + x * cell, top + y * cell, (end - x) * cell, cell, level);
    }
  text += format("<rect class=\"frame\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n",
                 left, top, w, h);
  text += textAt(left + w / 2, top + h + 22, "class=\"tick\" text-anchor=\"middle\"", map.xLabel);
  text += textAt(left - 12, top + h / 2, "class=\"tick\" text-anchor=\"end\"", map.yLabel);
  return text + scale(map, left + w + 24, h) + "</svg>\n";
}

} // namespace anysl::plot
