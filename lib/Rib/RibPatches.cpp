//===-- lib/Rib/RibPatches.cpp - requests that make patches -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <algorithm>
#include <numeric>

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

namespace {

/// Leaves of the part that is drawn what the knots reach; what is wrong, or nothing.
std::string clipToKnots(NurbsShape::Direction &direction, const std::string &what,
                        const std::string &where) {
  auto &[count, order, knots, min, max] = direction;
  if (order < 2 || order > 64 || count < order)
    return std::to_string(count) + " control points" + where + " do not make a " + what +
           " of order " + std::to_string(order);
  if (knots.size() != size_t(count) + order)
    return "expected " + std::to_string(size_t(count) + order) + " knots" + where + ", found " +
           std::to_string(knots.size());
  if (!std::is_sorted(knots.begin(), knots.end()))
    return "the knots" + where + " decrease";
  min = std::max(min, knots[order - 1]);
  max = std::min(max, knots[count]);
  return min < max ? "" : "nothing of the " + what + " lies between its ends" + where;
}

} // namespace

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
  for (NurbsShape::Direction *direction : {&shape.u, &shape.v})
    if (std::string fault =
            clipToKnots(*direction, "surface", direction == &shape.u ? " in u" : " in v");
        !fault.empty())
      throw ShapeError(arguments.where(), fault);
  size_t points = size_t(shape.u.count) * shape.v.count;
  checkPositions(variables, points, arguments);
  if (const Parameter *weighted = findParameter(variables, "Pw"))
    for (size_t i = 3; i < weighted->numbers.size(); i += 4)
      if (!(weighted->numbers[i] > 0))
        throw ShapeError(weighted->where, "\"Pw\": a weight is not positive");
  VariableCounts counts =
      VariableCounts::ofPatches(shape.u.segments(), shape.v.segments(), false, false, points);
  shape.trims = state.trims;
  if (const auto &attributes = state.appearance.attributes)
    if (auto sense = attributes->find("trimcurve:sense"); sense != attributes->end())
      shape.isOutsideTrims = sense->second.strings == std::vector<std::string>{"outside"};
  addShape(std::move(shape), std::move(variables), counts, arguments);
}

void RibState::trimCurve(RibArguments &arguments) {
  std::vector<uint32_t> loops = arguments.indices("the numbers of curves");
  std::vector<uint32_t> orders = arguments.indices("the orders");
  std::vector<double> knots = arguments.array("the knots");
  std::vector<double> mins = arguments.array("where the curves begin");
  std::vector<double> maxs = arguments.array("where the curves end");
  std::vector<uint32_t> counts = arguments.indices("the numbers of control points");
  std::array<std::vector<double>, 3> points;
  for (size_t k = 0; k < 3; ++k)
    points[k] = arguments.array("u, v and w of the control points");

  auto fail = [&](const std::string &what) {
    throw UserError(arguments.where(), "TrimCurve: " + what);
  };
  auto expect = [&](const char *what, size_t expected, size_t found) {
    if (found != expected)
      fail("expected " + std::to_string(expected) + " " + what + ", found " +
           std::to_string(found));
  };
  size_t curves = std::accumulate(loops.begin(), loops.end(), size_t(0));
  expect("orders", curves, orders.size());
  expect("beginnings", curves, mins.size());
  expect("ends", curves, maxs.size());
  expect("numbers of control points", curves, counts.size());
  size_t total = std::accumulate(counts.begin(), counts.end(), size_t(0));
  for (const std::vector<double> &each : points)
    expect("control points", total, each.size());
  expect("knots", std::accumulate(orders.begin(), orders.end(), total), knots.size());

  std::vector<NurbsShape::TrimLoop> trims;
  size_t curve = 0, point = 0;
  auto knot = knots.begin();
  for (uint32_t ofLoop : loops) {
    NurbsShape::TrimLoop &loop = trims.emplace_back();
    for (uint32_t i = 0; i < ofLoop; ++i, ++curve) {
      NurbsShape::Direction direction{counts[curve], orders[curve], {}, mins[curve], maxs[curve]};
      auto end = knot + std::ptrdiff_t(direction.count + size_t(direction.order));
      direction.knots.assign(knot, end);
      knot = end;
      if (std::string fault = clipToKnots(direction, "curve", ""); !fault.empty())
        fail(fault);
      loop.push_back({std::move(direction), {}});
      for (uint32_t k = 0; k < counts[curve]; ++k, ++point) {
        if (!(points[2][point] > 0))
          fail("a weight is not positive");
        loop.back().points.push_back({points[0][point], points[1][point], points[2][point]});
      }
    }
  }
  state.trims = trims.empty()
                    ? nullptr
                    : std::make_shared<const std::vector<NurbsShape::TrimLoop>>(std::move(trims));
}
