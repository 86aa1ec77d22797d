//===-- tools/anysl-render/RibShapes.cpp - requests that make surfaces ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/RibState.h"

#include <algorithm>

using namespace anysl::render;

void RibState::addShape(std::variant<QuadricShape, PolygonShape> geometry,
                        RibArguments &arguments) {
  if (!inWorld())
    throw UserError(arguments.where(), "a shape outside WorldBegin ... WorldEnd");
  if (scene.appearances.empty() || !(scene.appearances.back() == state.appearance))
    scene.appearances.push_back(state.appearance);
  Matrix4 test = state.transform;
  if (!test.invert()) {
    warnings.warn(arguments.where(), "the transformation makes this shape flat; it is left out");
    return;
  }
  scene.shapes.push_back({std::move(geometry), state.transform,
                          uint32_t(scene.appearances.size() - 1), arguments.where()});
}

void RibState::addQuadric(QuadricShape shape, RibArguments &arguments) {
  if (shape.thetaMax == 0) {
    warnings.warn(arguments.where(), "a sweep of 0 degrees; the shape is left out");
    return;
  }
  for (const Parameter &parameter : arguments.parameters())
    warnUnknown("parameter of a quadric,", parameter.name, parameter.where);
  addShape(shape, arguments);
}

void RibState::sphere(RibArguments &arguments) {
  auto n = arguments.numbers(4, "radius, zmin, zmax and sweep");
  QuadricShape shape;
  shape.kind = QuadricShape::Sphere;
  shape.radius = n[0];
  shape.zmin = std::min(n[1], n[2]);
  shape.zmax = std::max(n[1], n[2]);
  shape.thetaMax = n[3];
  if (shape.radius == 0)
    throw UserError(arguments.where(), "Sphere: the radius is 0");
  addQuadric(shape, arguments);
}

void RibState::cone(RibArguments &arguments) {
  auto n = arguments.numbers(3, "height, radius and sweep");
  QuadricShape shape;
  shape.kind = QuadricShape::Cone;
  shape.height = n[0];
  shape.radius = n[1];
  shape.thetaMax = n[2];
  if (shape.height == 0)
    throw UserError(arguments.where(), "Cone: the height is 0; use Disk");
  addQuadric(shape, arguments);
}

void RibState::cylinder(RibArguments &arguments) {
  auto n = arguments.numbers(4, "radius, zmin, zmax and sweep");
  QuadricShape shape;
  shape.kind = QuadricShape::Cylinder;
  shape.radius = n[0];
  shape.zmin = n[1];
  shape.zmax = n[2];
  shape.thetaMax = n[3];
  if (shape.radius == 0 || shape.zmin == shape.zmax)
    throw UserError(arguments.where(), "Cylinder: the radius or the height is 0");
  addQuadric(shape, arguments);
}

void RibState::hyperboloid(RibArguments &arguments) {
  auto n = arguments.numbers(7, "two points and a sweep");
  QuadricShape shape;
  shape.kind = QuadricShape::Hyperboloid;
  shape.point1 = {n[0], n[1], n[2]};
  shape.point2 = {n[3], n[4], n[5]};
  shape.thetaMax = n[6];
  addQuadric(shape, arguments);
}

void RibState::paraboloid(RibArguments &arguments) {
  auto n = arguments.numbers(4, "radius, zmin, zmax and sweep");
  QuadricShape shape;
  shape.kind = QuadricShape::Paraboloid;
  shape.radius = n[0];
  shape.zmin = n[1];
  shape.zmax = n[2];
  shape.thetaMax = n[3];
  if (shape.radius == 0 || shape.zmax == 0 || shape.zmin == shape.zmax)
    throw UserError(arguments.where(), "Paraboloid: the radius or the height is 0");
  addQuadric(shape, arguments);
}

void RibState::disk(RibArguments &arguments) {
  auto n = arguments.numbers(3, "height, radius and sweep");
  QuadricShape shape;
  shape.kind = QuadricShape::Disk;
  shape.height = n[0];
  shape.radius = n[1];
  shape.thetaMax = n[2];
  if (shape.radius == 0)
    throw UserError(arguments.where(), "Disk: the radius is 0");
  addQuadric(shape, arguments);
}

void RibState::torus(RibArguments &arguments) {
  auto n = arguments.numbers(5, "two radii, phimin, phimax and sweep");
  QuadricShape shape;
  shape.kind = QuadricShape::Torus;
  shape.radius = n[0];
  shape.minorRadius = n[1];
  shape.phiMin = n[2];
  shape.phiMax = n[3];
  shape.thetaMax = n[4];
  if (shape.minorRadius == 0 || shape.phiMin == shape.phiMax)
    throw UserError(arguments.where(), "Torus: the minor radius or its sweep is 0");
  addQuadric(shape, arguments);
}

//===-- Polygons ------------------------------------------------------------//

void RibState::polygon(RibArguments &arguments) {
  PolygonShape shape;
  shape.parameters = arguments.parameters();
  const Parameter *points = findParameter(shape.parameters, "P");
  size_t count = points ? points->numbers.size() / 3 : 0;
  shape.vertexCounts.push_back(uint32_t(count));
  for (uint32_t i = 0; i < count; ++i)
    shape.vertices.push_back(i);
  addPolygons(std::move(shape), arguments);
}

void RibState::pointsPolygons(RibArguments &arguments) {
  PolygonShape shape;
  shape.vertexCounts = arguments.indices("the numbers of vertices");
  shape.vertices = arguments.indices("the vertices");
  shape.parameters = arguments.parameters();
  addPolygons(std::move(shape), arguments);
}

void RibState::addPolygons(PolygonShape shape, RibArguments &arguments) {
  const Parameter *points = findParameter(shape.parameters, "P");
  if (!points)
    throw UserError(arguments.where(),
                    "a polygon needs its vertices, as in \"P\" [0 0 0  1 0 0  0 1 0]");
  if (points->numbers.empty() || points->numbers.size() % 3 != 0)
    throw UserError(points->where, "\"P\" needs three numbers for each vertex");
  for (size_t i = 0; i < points->numbers.size(); i += 3)
    shape.points.emplace_back(points->numbers[i], points->numbers[i + 1], points->numbers[i + 2]);

  size_t total = 0;
  for (uint32_t count : shape.vertexCounts) {
    if (count < 3)
      throw UserError(arguments.where(), "a polygon needs at least 3 vertices");
    total += count;
  }
  if (total != shape.vertices.size())
    throw UserError(arguments.where(),
                    "the numbers of vertices add up to " + std::to_string(total) + ", but " +
                        std::to_string(shape.vertices.size()) + " vertices are given");
  for (uint32_t vertex : shape.vertices)
    if (vertex >= shape.points.size())
      throw UserError(arguments.where(), "vertex " + std::to_string(vertex) + " of " +
                                             std::to_string(shape.points.size()) + " in \"P\"");

  std::erase_if(shape.parameters, [](const Parameter &parameter) { return parameter.name == "P"; });
  for (const Parameter &parameter : shape.parameters) {
    static const std::pair<const char *, size_t> known[] = {{"N", 3},  {"Cs", 3}, {"Os", 3},
                                                            {"st", 2}, {"s", 1},  {"t", 1}};
    auto entry = std::find_if(std::begin(known), std::end(known),
                              [&](auto &each) { return parameter.name == each.first; });
    if (entry == std::end(known)) {
      warnUnknown("parameter of a polygon,", parameter.name, parameter.where);
    } else if (parameter.numbers.size() != entry->second * shape.points.size()) {
      throw UserError(parameter.where, "\"" + parameter.name + "\": expected " +
                                           std::to_string(entry->second * shape.points.size()) +
                                           " numbers, one value for each vertex, found " +
                                           std::to_string(parameter.numbers.size()));
    }
  }
  addShape(std::move(shape), arguments);
}
