//===-- lib/Rib/RibSubdivision.cpp - the request SubdivisionMesh ------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <algorithm>
#include <limits>
#include <set>

using namespace anysl::render;

namespace {

/// Tags of a mesh, with their arguments in the order in which all are given. `hasTexts`: integers,
/// numbers and texts; else there are no texts.
class TagReader {
public:
  TagReader(SubdivisionShape &shape, size_t vertices, bool hasTexts, RibArguments &arguments)
      : shape(shape), vertices(vertices), kinds(hasTexts ? 3 : 2), where(arguments.where()) {
    names = arguments.strings("the tags");
    counts = arguments.indices("the numbers of the tags' arguments");
    integers = arguments.array("the tags' integers");
    floats = arguments.array("the tags' numbers");
    if (hasTexts)
      arguments.strings("the tags' texts"); // which no tag that is known has
  }

  void read(Warnings &warnings) {
    if (counts.size() != kinds * names.size())
      throw ShapeError(where, "the " + std::to_string(names.size()) + " tags need " +
                                  std::to_string(kinds * names.size()) +
                                  " numbers of arguments, found " + std::to_string(counts.size()));
    for (size_t i = 0; i < names.size(); ++i) {
      std::vector<double> whole = take(integers, counts[kinds * i], names[i]);
      std::vector<double> values = take(floats, counts[kinds * i + 1], names[i]);
      readTag(names[i], whole, values, warnings);
    }
  }

private:
  static std::vector<double> take(std::vector<double> &from, size_t count, const Location &where,
                                  const std::string &tag) {
    if (count > from.size())
      throw ShapeError(where, "tag \"" + tag + "\" has fewer arguments than it says");
    std::vector<double> taken(from.begin(), from.begin() + ptrdiff_t(count));
    from.erase(from.begin(), from.begin() + ptrdiff_t(count));
    return taken;
  }
  std::vector<double> take(std::vector<double> &from, size_t count, const std::string &tag) const {
    return take(from, count, where, tag);
  }
  uint32_t index(double value, size_t limit, const std::string &tag) const {
    if (!(value >= 0 && value < double(limit) && value == std::floor(value)))
      throw ShapeError(where, "tag \"" + tag + "\": there is no number " + std::to_string(value));
    return uint32_t(value);
  }
  /// Sharpness, of which 10 and more are as sharp as can be.
  static double sharpness(double value) {
    return value >= 10 ? std::numeric_limits<double>::infinity() : std::max(0.0, value);
  }
  void readTag(const std::string &tag, const std::vector<double> &whole,
               const std::vector<double> &values, Warnings &warnings);

  SubdivisionShape &shape;
  size_t vertices, kinds; ///< of arguments
  Location where;
  std::vector<std::string> names;
  std::vector<uint32_t> counts;
  std::vector<double> integers, floats;
};

void TagReader::readTag(const std::string &tag, const std::vector<double> &whole,
                        const std::vector<double> &values, Warnings &warnings) {
  auto needValues = [&](size_t each) {
    if (values.size() != 1 && values.size() != each)
      throw ShapeError(where, "tag \"" + tag + "\" needs one number, or " + std::to_string(each));
  };
  if (tag == "hole") {
    for (double face : whole)
      shape.holes.push_back(index(face, shape.vertexCounts.size(), tag));
  } else if (tag == "crease") {
    if (whole.size() < 2)
      throw ShapeError(where, "tag \"crease\" needs at least two vertices");
    needValues(whole.size() - 1);
    for (size_t i = 0; i + 1 < whole.size(); ++i)
      shape.creases.push_back({index(whole[i], vertices, tag), index(whole[i + 1], vertices, tag),
                               sharpness(values[values.size() == 1 ? 0 : i])});
  } else if (tag == "corner") {
    needValues(whole.size());
    for (size_t i = 0; i < whole.size(); ++i)
      shape.corners.push_back(
          {index(whole[i], vertices, tag), sharpness(values[values.size() == 1 ? 0 : i])});
  } else if (tag == "interpolateboundary") {
    using Boundary = SubdivisionShape::Boundary;
    double kind = whole.empty() ? values.empty() ? 1 : values[0] : whole[0];
    shape.boundary = kind == 0   ? Boundary::None
                     : kind == 2 ? Boundary::Edges
                                 : Boundary::EdgesAndCorners;
  } else if (!tag.starts_with("facevarying")) { // those steer what is bilinear here
    warnings.warnOnce("tag " + tag, where,
                      "tag \"" + tag + "\" of a subdivision mesh is not known and has no effect");
  }
}

} // namespace

void RibState::subdivisionMesh(RibArguments &arguments) { addSubdivision(arguments, false); }

void RibState::hierarchicalSubdivisionMesh(RibArguments &arguments) {
  addSubdivision(arguments, true);
}

void RibState::addSubdivision(RibArguments &arguments, bool hasTexts) {
  SubdivisionShape shape;
  std::string scheme = arguments.string("a scheme");
  shape.vertexCounts = arguments.indices("the numbers of vertices");
  shape.vertices = arguments.indices("the vertices");
  std::optional<TagReader> tags;
  uint32_t points = 0;
  for (uint32_t vertex : shape.vertices)
    points = std::max(points, vertex + 1);
  if (arguments.nextIsArray())
    tags.emplace(shape, points, hasTexts, arguments);
  ParameterList variables = arguments.parameters();
  if (scheme != "catmull-clark")
    throw ShapeError(arguments.where(), "\"" + scheme + "\" is not the scheme catmull-clark");
  if (tags)
    tags->read(warnings);

  size_t given = positions(variables).size(), total = 0;
  if (given == 0 || points > given)
    throw ShapeError(arguments.where(), "\"P\" has " + std::to_string(given) +
                                            " vertices, but vertex " + std::to_string(points - 1) +
                                            " is used");
  std::vector<uint32_t> facesAt(points);
  for (uint32_t count : shape.vertexCounts) {
    if (count < 3 || count > SubdivisionShape::mostCorners)
      throw ShapeError(arguments.where(), "a face with " + std::to_string(count) +
                                              " vertices; there must be 3 to " +
                                              std::to_string(SubdivisionShape::mostCorners));
    if (total + count > shape.vertices.size())
      throw ShapeError(arguments.where(), "there are fewer vertices than the faces need");
    std::set<uint32_t> distinct(shape.vertices.begin() + ptrdiff_t(total),
                                shape.vertices.begin() + ptrdiff_t(total + count));
    if (distinct.size() != count)
      throw ShapeError(arguments.where(), "a face has the same vertex twice");
    for (uint32_t vertex : distinct)
      if (++facesAt[vertex] > SubdivisionShape::mostFaces)
        throw ShapeError(arguments.where(), "more than " +
                                                std::to_string(SubdivisionShape::mostFaces) +
                                                " faces meet at vertex " + std::to_string(vertex));
    total += count;
  }
  if (total != shape.vertices.size())
    throw ShapeError(arguments.where(),
                     "the numbers of vertices add up to " + std::to_string(total) + ", but " +
                         std::to_string(shape.vertices.size()) + " vertices are given");
  VariableCounts counts{.uniform = shape.vertexCounts.size(),
                        .varying = given,
                        .vertex = given,
                        .faceVarying = total};
  addShape(std::move(shape), std::move(variables), counts, arguments);
}
