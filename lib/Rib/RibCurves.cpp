//===-- lib/Rib/RibCurves.cpp - requests that make curves and points --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

using namespace anysl::render;

void RibState::curves(RibArguments &arguments) {
  CurvesShape shape;
  std::string type = arguments.string("linear or cubic");
  shape.counts = arguments.indices("the numbers of vertices");
  std::string wrap = arguments.string("periodic or nonperiodic");
  ParameterList variables = arguments.parameters();
  if (type != "linear" && type != "cubic")
    throw ShapeError(arguments.where(), "\"" + type + "\" is neither linear nor cubic");
  if (wrap != "periodic" && wrap != "nonperiodic")
    throw ShapeError(arguments.where(), "\"" + wrap + "\" is neither periodic nor nonperiodic");
  shape.cubic = type == "cubic";
  shape.wraps = wrap == "periodic";
  shape.basis = state.basisV;

  VariableCounts counts{.uniform = shape.counts.size(), .varying = 0, .vertex = 0};
  for (uint32_t count : shape.counts) {
    uint32_t segments = shape.segments(count);
    if (segments == 0)
      throw ShapeError(
          arguments.where(),
          std::to_string(count) + " vertices do not make a " + wrap + " " + type + " curve" +
              (shape.cubic ? ", with a step of " + std::to_string(shape.basis.step) + " in Basis"
                           : ""));
    counts.vertex += count;
    counts.varying += segments + !shape.wraps;
  }
  counts.faceVarying = counts.varying;
  if (counts.vertex == 0 || !hasPositions(variables))
    throw ShapeError(arguments.where(), "curves need their vertices, \"P\"");
  addShape(std::move(shape), std::move(variables), counts, arguments);
}

void RibState::points(RibArguments &arguments) {
  ParameterList variables = arguments.parameters();
  size_t count = positions(variables).size();
  if (count == 0)
    throw ShapeError(arguments.where(), "points need their places, \"P\"");
  addShape(PointsShape(), std::move(variables),
           {.uniform = 1, .varying = count, .vertex = count, .faceVarying = count}, arguments);
}
