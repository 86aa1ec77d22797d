//===-- lib/Plot/Plot.h - error against time, as a picture ------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A scatter plot of costs on two logarithmic axes, lower left is best, with the Pareto front drawn
// in; as SVG that stands alone or inside a page, in light and dark colours, with nothing fetched
// from elsewhere and no script. What is under the pointer shows its numbers beside the plot.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_PLOT_PLOT_H
#define ANYSL_LIB_PLOT_PLOT_H

#include <string>
#include <utility>
#include <vector>

namespace anysl::plot {

struct Point {
  double x = 0, y = 0; ///< x >= 0, where 0 has a place of its own; y > 0
  std::string name{};  ///< in full, for who points at it
  std::string label{}; ///< beside the point, where there is room; empty: none
  std::string mark{};  ///< inside it: two characters at most
  unsigned series = 0; ///< its colour
  unsigned shape = 0;  ///< its outline: circle, square, diamond
  /// What is shown when the pointer is on it, a line each: name and value.
  std::vector<std::pair<std::string, std::string>> details{};
};

struct Plot {
  std::string title, xLabel, yLabel;
  std::vector<std::string>
      series; ///< names of the colours, at most six; those without are not used
  std::vector<std::string> shapes; ///< names of the outlines, at most three
  std::string markMeaning;         ///< what the marks inside the points say; empty: nothing
  std::vector<Point> points;
  /// Lines across, at an x: what one should know of it.
  std::vector<std::pair<double, std::string>> guides{};
};

/// Which points no other is at least as good as in both and better in one. Of equal points, the
/// first. By ascending x. Points that are not finite are on no front.
std::vector<size_t> paretoFront(const std::vector<Point> &points);

/// The plot as an <svg> element; \p standalone brings its style with it, as a file of its own
/// needs.
std::string svg(const Plot &plot, bool standalone);

/// Text as HTML and XML take it.
std::string escaped(const std::string &text);

/// Three digits: "0.00123", "9.43e-07", "12.3"; "0" and "inf".
std::string shortNumber(double value);

/// A page around a body; its style has the plot's as well, and tables.
std::string page(const std::string &title, const std::string &body);

/// A table: a row of names, and rows of cells, which are HTML already. Rows whose number is in
/// \p highlighted stand out.
std::string table(const std::vector<std::string> &names,
                  const std::vector<std::vector<std::string>> &rows,
                  const std::vector<size_t> &highlighted = {});

} // namespace anysl::plot

#endif
