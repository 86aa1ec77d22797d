//===-- lib/Rib/RibShapes.cpp - requests that make surfaces -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <algorithm>

using namespace anysl::render;

void RibState::addShape(ShapeGeometry geometry, ParameterList variables,
                        const VariableCounts &counts, RibArguments &arguments) {
  if (!inWorld()) {
    const std::string message = "a shape outside WorldBegin ... WorldEnd";
    if (!warnings.keepGoing)
      throw UserError(arguments.where(), message);
    warnings.warnOnce(message, arguments.where(), message + "; such shapes are left out");
    return;
  }
  if (state.isLeftOut)
    return;
  checkVariables(variables, counts, warnings);
  if (scene.appearances.empty() || !(scene.appearances.back() == state.appearance))
    scene.appearances.push_back(state.appearance);
  Matrix4 test = state.transform;
  if (!test.invert())
    throw ShapeError(arguments.where(), "the transformation makes this shape flat");
  scene.shapes.push_back({std::move(geometry), std::move(variables), state.transform,
                          uint32_t(scene.appearances.size() - 1), arguments.where()});
  if (state.areaLight >= 0 && size_t(state.areaLight) < scene.lights.size())
    scene.lights[size_t(state.areaLight)].shapes.push_back(uint32_t(scene.shapes.size() - 1));
}

void RibState::addQuadric(QuadricShape shape, RibArguments &arguments) {
  if (shape.thetaMax == 0)
    throw ShapeError(arguments.where(), "a sweep of 0 degrees");
  // One value at each corner of the square of u and v.
  addShape(shape, arguments.parameters(),
           {.uniform = 1, .varying = 4, .vertex = 4, .faceVarying = 4}, arguments);
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
    throw ShapeError(arguments.where(), "Sphere: the radius is 0");
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
    throw ShapeError(arguments.where(), "Cone: the height is 0; use Disk");
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
    throw ShapeError(arguments.where(), "Cylinder: the radius or the height is 0");
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
    throw ShapeError(arguments.where(), "Paraboloid: the radius or the height is 0");
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
    throw ShapeError(arguments.where(), "Disk: the radius is 0");
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
    throw ShapeError(arguments.where(), "Torus: the minor radius or its sweep is 0");
  addQuadric(shape, arguments);
}
