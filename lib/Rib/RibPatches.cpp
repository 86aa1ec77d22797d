//===-- lib/Rib/RibPatches.cpp - requests that make patches -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <algorithm>

using namespace anysl::render;

void RibState::basis(RibArguments &arguments) {
  for (Basis *basis : {&state.basisU, &state.basisV}) {
    if (arguments.nextIsText()) {
      std::string name = arguments.string("a basis");
      const Basis *known = findBasis(name);
      if (!known)
        throw UserError(arguments.where(),
                        "Basis: \"" + name +
                            "\" is none of bezier, b-spline, catmull-rom, hermite, power");
      *basis = *known;
    } else {
      std::vector<double> matrix = arguments.numbers(16, "a basis");
      std::copy(matrix.begin(), matrix.end(), basis->m.begin());
    }
    double step = arguments.number("a step");
    if (!(step >= 1 && step <= 1e6 && step == std::floor(step)))
      throw UserError(arguments.where(), "Basis: the step must be a whole number of at least 1");
    basis->step = uint32_t(step);
  }
}

namespace {

/// How many control points a patch has: the positions must be as many.
void checkPositions(const ParameterList &variables, size_t expected,
                    const RibArguments &arguments) {
  for (const char *name : {"P", "Pw"})
    if (const Parameter *p = findParameter(variables, name)) {
      size_t each = name[1] ? 4 : 3;
      if (p->numbers.size() != each * expected)
        throw ShapeError(p->where, "\"" + p->name + "\": expected " +
                                       std::to_string(each * expected) + " numbers, " +
                                       std::to_string(expected) + " control points, found " +
                                       std::to_string(p->numbers.size()));
      return;
    }
  throw ShapeError(arguments.where(), "this shape needs its control points, \"P\" or \"Pw\"");
}

/// Heights "Pz" stand on the unit square, over which the control points are spread evenly.
void expandHeights(ParameterList &variables, uint32_t nu, uint32_t nv) {
  auto heights = std::find_if(variables.begin(), variables.end(),
                              [](const Parameter &p) { return p.name == "Pz"; });
  if (heights == variables.end() || heights->numbers.size() != size_t(nu) * nv ||
      findParameter(variables, "P"))
    return;
  Parameter points = *heights;
  points.name = "P";
  points.declaration = *standardVariable("P");
  points.numbers.clear();
  for (size_t i = 0; i < heights->numbers.size(); ++i)
    points.numbers.insert(points.numbers.end(), {double(i % nu) / (nu - 1),
                                                 double(i / nu) / (nv - 1), heights->numbers[i]});
  variables.erase(heights);
  variables.push_back(std::move(points));
}

} // namespace

void RibState::addPatches(PatchShape shape, RibArguments &arguments) {
  ParameterList variables = arguments.parameters();
  expandHeights(variables, shape.u.count, shape.v.count);
  checkPositions(variables, size_t(shape.u.count) * shape.v.count, arguments);
  VariableCounts counts = VariableCounts::ofPatches(
      shape.u.segments(shape.cubic), shape.v.segments(shape.cubic), shape.u.wraps, shape.v.wraps,
      size_t(shape.u.count) * shape.v.count);
  addShape(std::move(shape), std::move(variables), counts, arguments);
}

namespace {

bool isCubic(RibArguments &arguments) {
  std::string type = arguments.string("bilinear or bicubic");
  if (type != "bilinear" && type != "bicubic")
    throw ShapeError(arguments.where(), "\"" + type + "\" is neither bilinear nor bicubic");
  return type == "bicubic";
}

} // namespace

void RibState::patch(RibArguments &arguments) {
  PatchShape shape;
  shape.cubic = isCubic(arguments);
  shape.u.basis = state.basisU;
  shape.v.basis = state.basisV;
  shape.u.count = shape.v.count = shape.cubic ? 4 : 2;
  addPatches(std::move(shape), arguments);
}

void RibState::patchMesh(RibArguments &arguments) {
  PatchShape shape;
  shape.cubic = isCubic(arguments);
  shape.u.basis = state.basisU;
  shape.v.basis = state.basisV;
  for (PatchShape::Direction *direction : {&shape.u, &shape.v}) {
    direction->count = arguments.count("the number of control points");
    std::string wrap = arguments.string("periodic or nonperiodic");
    if (wrap != "periodic" && wrap != "nonperiodic")
      throw ShapeError(arguments.where(), "\"" + wrap + "\" is neither periodic nor nonperiodic");
    direction->wraps = wrap == "periodic";
    bool fits = shape.cubic ? direction->segments(true) > 0 : direction->count >= 2;
    if (!fits)
      throw ShapeError(arguments.where(),
                       std::to_string(direction->count) + " control points in " +
                           (direction == &shape.u ? "u" : "v") + " do not make patches" +
                           (shape.cubic ? ", with a step of " +
                                              std::to_string(direction->basis.step) + " in Basis"
                                        : ""));
  }
  addPatches(std::move(shape), arguments);
}

void RibState::nuPatch(RibArguments &arguments) {
  NurbsShape shape;
  for (NurbsShape::Direction *direction : {&shape.u, &shape.v}) {
    direction->count = arguments.count("the number of control points");
    direction->order = arguments.count("the order");
    direction->knots = arguments.array("the knots");
    direction->min = arguments.number("where the surface begins");
    direction->max = arguments.number("where the surface ends");
  }
  ParameterList variables = arguments.parameters();
  for (NurbsShape::Direction *direction : {&shape.u, &shape.v}) {
    std::string where = direction == &shape.u ? " in u" : " in v";
    auto &[count, order, knots, min, max] = *direction;
    if (order < 2 || order > 64 || count < order)
      throw ShapeError(arguments.where(), std::to_string(count) + " control points" + where +
                                              " do not make a surface of order " +
                                              std::to_string(order));
    if (knots.size() != size_t(count) + order)
      throw ShapeError(arguments.where(), "expected " + std::to_string(count + order) + " knots" +
                                              where + ", found " + std::to_string(knots.size()));
    if (!std::is_sorted(knots.begin(), knots.end()))
      throw ShapeError(arguments.where(), "the knots" + where + " decrease");
    min = std::max(min, knots[order - 1]);
    max = std::min(max, knots[count]);
    if (!(min < max))
      throw ShapeError(arguments.where(), "nothing of the surface lies between its ends" + where);
  }
  size_t points = size_t(shape.u.count) * shape.v.count;
  checkPositions(variables, points, arguments);
  if (const Parameter *weighted = findParameter(variables, "Pw"))
    for (size_t i = 3; i < weighted->numbers.size(); i += 4)
      if (!(weighted->numbers[i] > 0))
        throw ShapeError(weighted->where, "\"Pw\": a weight is not positive");
  VariableCounts counts =
      VariableCounts::ofPatches(shape.u.segments(), shape.v.segments(), false, false, points);
  addShape(std::move(shape), std::move(variables), counts, arguments);
}

void RibState::trimCurve(RibArguments &arguments) {
  while (!arguments.empty())
    arguments.array("numbers");
  warnings.warnOnce("TrimCurve", arguments.where(),
                    "TrimCurve has no effect: the NuPatch that follows is shown whole");
}
