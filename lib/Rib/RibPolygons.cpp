//===-- lib/Rib/RibPolygons.cpp - requests that make polygons ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <numeric>

using namespace anysl::render;

void RibState::polygon(RibArguments &arguments) {
  PolygonShape shape;
  ParameterList variables = arguments.parameters();
  shape.loopCounts = {1};
  shape.vertexCounts = {uint32_t(positions(variables).size())};
  addPolygons(std::move(shape), std::move(variables), arguments);
}

void RibState::generalPolygon(RibArguments &arguments) {
  PolygonShape shape;
  shape.vertexCounts = arguments.indices("the numbers of vertices");
  shape.loopCounts = {uint32_t(shape.vertexCounts.size())};
  addPolygons(std::move(shape), arguments.parameters(), arguments);
}

void RibState::pointsPolygons(RibArguments &arguments) {
  PolygonShape shape;
  shape.vertexCounts = arguments.indices("the numbers of vertices");
  shape.loopCounts.assign(shape.vertexCounts.size(), 1);
  shape.vertices = arguments.indices("the vertices");
  addPolygons(std::move(shape), arguments.parameters(), arguments);
}

void RibState::pointsGeneralPolygons(RibArguments &arguments) {
  PolygonShape shape;
  shape.loopCounts = arguments.indices("the numbers of loops");
  shape.vertexCounts = arguments.indices("the numbers of vertices");
  shape.vertices = arguments.indices("the vertices");
  addPolygons(std::move(shape), arguments.parameters(), arguments);
}

void RibState::addPolygons(PolygonShape shape, ParameterList variables, RibArguments &arguments) {
  const Parameter *points = findParameter(variables, "P");
  if (!points)
    points = findParameter(variables, "Pw");
  if (!points || points->numbers.empty())
    throw ShapeError(arguments.where(),
                     "a polygon needs its vertices, as in \"P\" [0 0 0  1 0 0  0 1 0]");
  size_t each = points->name == "P" ? 3 : 4;
  if (points->numbers.size() % each != 0)
    throw ShapeError(points->where, "\"" + points->name + "\" needs " + std::to_string(each) +
                                        " numbers for each vertex");
  size_t count = points->numbers.size() / each;

  size_t loops = 0, total = 0;
  for (uint32_t ofFace : shape.loopCounts) {
    if (ofFace == 0)
      throw ShapeError(arguments.where(), "a polygon needs an outline");
    loops += ofFace;
  }
  if (loops != shape.vertexCounts.size())
    throw ShapeError(arguments.where(), "the numbers of loops add up to " + std::to_string(loops) +
                                            ", but " + std::to_string(shape.vertexCounts.size()) +
                                            " numbers of vertices are given");
  for (uint32_t ofLoop : shape.vertexCounts) {
    if (ofLoop < 3)
      throw ShapeError(arguments.where(), "a polygon needs at least 3 vertices");
    total += ofLoop;
  }
  if (shape.vertices.empty()) { // in order
    if (total != count)
      throw ShapeError(arguments.where(), "the numbers of vertices add up to " +
                                              std::to_string(total) + ", but \"" + points->name +
                                              "\" has " + std::to_string(count));
    shape.vertices.resize(count);
    std::iota(shape.vertices.begin(), shape.vertices.end(), 0);
  }
  if (total != shape.vertices.size())
    throw ShapeError(arguments.where(),
                     "the numbers of vertices add up to " + std::to_string(total) + ", but " +
                         std::to_string(shape.vertices.size()) + " vertices are given");
  for (uint32_t vertex : shape.vertices)
    if (vertex >= count)
      throw ShapeError(arguments.where(), "vertex " + std::to_string(vertex) + " of " +
                                              std::to_string(count) + " in \"" + points->name +
                                              "\"");
  VariableCounts counts{
      .uniform = shape.loopCounts.size(), .varying = count, .vertex = count, .faceVarying = total};
  addShape(std::move(shape), std::move(variables), counts, arguments);
}
