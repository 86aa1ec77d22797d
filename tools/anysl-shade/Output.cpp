//===-- tools/anysl-shade/Output.cpp - results as text, JSON, an image ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-shade/Output.h"
#include "lib/Shade/ImageModule.h"
#include "lib/Shade/Pictures.h"
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace anysl::shade {
namespace {

/// A number that reads back as the same float or double.
std::string number(double value, bool isDouble) {
  if (std::isnan(value))
    return "NaN";
  if (std::isinf(value))
    return value < 0 ? "-Infinity" : "Infinity";
  char text[40];
  std::snprintf(text, sizeof text, isDouble ? "%.17g" : "%.9g", value);
  return text;
}

/// A text as JSON has it.
std::string quoted(const std::string &text) {
  std::string result = "\"";
  for (unsigned char c : text) {
    char escaped[8];
    if (c == '"' || c == '\\')
      result += '\\';
    std::snprintf(escaped, sizeof escaped, "\\u%04x", c);
    if (c < 0x20)
      result += escaped;
    else
      result += char(c);
  }
  return result + "\"";
}

/// Element number `index` of a result's numbers or texts.
std::string element(const Result &result, size_t index, bool isDouble) {
  return result.isText ? quoted(result.texts[index]) : number(result.values[index], isDouble);
}

std::string jsonElement(const Result &result, size_t index, bool isDouble) {
  uint32_t components = result.components;
  if (components == 1)
    return element(result, index, isDouble);
  std::string text = "[";
  for (uint32_t c = 0; c < components; ++c)
    text += (c ? "," : "") + element(result, index + c, isDouble);
  return text + "]";
}

std::string jsonPoint(const Result &result, size_t point, bool isDouble) {
  size_t first = point * result.perPoint();
  if (!result.elements)
    return jsonElement(result, first, isDouble);
  std::string text = "[";
  for (uint32_t e = 0; e < result.elements; ++e)
    text += (e ? "," : "") + jsonElement(result, first + size_t(e) * result.components, isDouble);
  return text + "]";
}

} // namespace

void printText(const Options &options, const std::vector<Result> &results, bool isDouble) {
  size_t points = size_t(options.gridWidth) * options.gridHeight;
  for (size_t point = 0; point < points; ++point) {
    std::string line =
        std::to_string(point % options.gridWidth) + " " + std::to_string(point / options.gridWidth);
    for (const Result &result : results) {
      line += "  " + result.name;
      for (uint32_t k = 0; k < result.perPoint(); ++k)
        line += " " + element(result, point * result.perPoint() + k, isDouble);
    }
    std::puts(line.c_str());
  }
}

void printJson(const Options &options, const std::vector<Result> &results, bool isDouble) {
  size_t points = size_t(options.gridWidth) * options.gridHeight;
  std::printf("{\"width\":%u,\"height\":%u", options.gridWidth, options.gridHeight);
  for (const Result &result : results) {
    std::printf(",\n\"%s\":[", result.name.c_str());
    for (size_t point = 0; point < points; ++point) {
      const char *separator = !point ? "" : point % options.gridWidth ? "," : ",\n ";
      std::printf("%s%s", separator, jsonPoint(result, point, isDouble).c_str());
    }
    std::printf("]");
  }
  std::puts("}");
}

void writeImage(const Options &options, const std::vector<Result> &results) {
  // Grid adds Ci to the results of a run that writes an image.
  auto color = std::find_if(results.begin(), results.end(),
                            [](const Result &result) { return result.name == "Ci"; });
  std::string problem;
  auto write = reinterpret_cast<decltype(&anyslWriteImage)>(imageFunction("anyslWriteImage"));
  write(options.image.c_str(), int(options.gridWidth), int(options.gridHeight),
        color->values.data(), &problem);
  if (!problem.empty())
    throw UserError("cannot write '" + options.image + "': " + problem);
}

} // namespace anysl::shade
