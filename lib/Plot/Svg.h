//===-- lib/Plot/Svg.h - text for SVG ---------------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_PLOT_SVG_H
#define ANYSL_LIB_PLOT_SVG_H

#include "lib/Plot/Plot.h"
#include <cstdarg>
#include <cstdio>

namespace anysl::plot {

/// What printf() would print, 511 characters at most.
__attribute__((format(printf, 1, 2))) inline std::string format(const char *text, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, text);
  std::vsnprintf(buffer, sizeof buffer, text, arguments);
  va_end(arguments);
  return buffer;
}

/// Text at a place, with more attributes.
inline std::string textAt(double x, double y, const char *attributes, const std::string &text) {
  return format("<text x=\"%.1f\" y=\"%.1f\" %s>", x, y, attributes) + escaped(text) + "</text>\n";
}

} // namespace anysl::plot

#endif
