//===-- tools/anysl-render/Subdivision.cpp - subdivision surfaces to facets -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The facets are cut here and not by Embree, so that hits, normals and values agree about where on
// the surface they are. A face with four corners is one grid of facets; another is one at each of
// its corners. Every edge has a number of pieces of its own, by how it bends. A grid has as many
// lines as its finest side asks for, and on its coarser sides lines run together in the points of
// the edge, so that grids meet without cracks.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/LimitSurface.h"
#include "tools/anysl-render/Tessellate.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>

using namespace anysl::render;

namespace {

/// A grid of facets: a whole face, or the part of it at one of its corners.
struct Quad {
  uint32_t face, corner, first; ///< the face's first place in shape.vertices
  bool whole;
};

/// The sides of a grid: y = 0, x = 1, y = 1, x = 0, each counted from where x and y are less.
constexpr uint32_t sides = 4;

struct Place {
  double x, y;
};

Place onSide(uint32_t side, double t) {
  return side == 0 ? Place{t, 0} : side == 1 ? Place{1, t} : side == 2 ? Place{t, 1} : Place{0, t};
}

class SubdivisionDicer {
public:
  SubdivisionDicer(const SubdivisionShape &shape, const ParameterList &variables,
                   const Placement &placement);
  std::unique_ptr<Mesh> run(const Dicing &dicing);

private:
  using Key = std::array<uint32_t, 4>; ///< of a point on the border of a grid

  void collect();
  uint32_t vertex(const Quad &quad, uint32_t k) const {
    return shape.vertices[quad.first + (quad.corner + k) % shape.vertexCounts[quad.face]];
  }
  /// The number of pieces of the edge, or of the line to a face's centre, that a side lies on.
  uint32_t &pieces(const Quad &quad, uint32_t side);
  bool isHalfEdge(const Quad &quad, uint32_t side) const {
    return !quad.whole && (side == 0 || side == 3);
  }
  std::pair<uint32_t, uint32_t> edge(const Quad &quad, uint32_t side) const;
  Key key(const Quad &quad, uint32_t side, uint32_t j, uint32_t count) const;
  void addQuad(const Quad &quad);
  /// Where to evaluate instead of a place on a side that is as sharp as can be.
  Place besideSharp(const Quad &quad, Place at) const;
  SurfaceFrame evaluate(const Quad &quad, Place at) const;
  Vec3d normal(const Quad &quad, const SurfaceFrame &frame, Place at) const;
  void cornerValue(const Variable &variable, bool perFace, const Quad &quad, Place at,
                   float *value) const;
  void addValues(const Quad &quad, Place at);

  const SubdivisionShape &shape;
  const Placement &placement;
  struct Source {
    Variable given, diced;
    StorageClass storage;
    size_t limitIndex; ///< of those that follow the surface
  };
  std::vector<Source> sources;
  std::vector<Variable> smooth; ///< those of class vertex
  std::unique_ptr<LimitSurface> limit;
  std::vector<Quad> quads;
  std::set<std::pair<uint32_t, uint32_t>> sharpEdges;
  std::map<Key, uint32_t> borderPieces, borderPoints;
  std::unique_ptr<Mesh> mesh;
};

/// Kinds of key.
enum : uint32_t { AtVertex, OnEdge, AtCenter, OnSpoke };

SubdivisionDicer::SubdivisionDicer(const SubdivisionShape &given, const ParameterList &variables,
                                   const Placement &placement)
    : shape(given), placement(placement) {
  for (const Parameter &parameter : variables) {
    if (isPosition(parameter.name) || parameter.declaration->type == ValueType::String)
      continue;
    Source source{cameraVariable(parameter, placement), {}, parameter.declaration->storage, 0};
    source.diced = source.given;
    source.diced.domain = Domain::Corner;
    source.diced.values.clear();
    if (source.storage == StorageClass::Vertex) {
      source.limitIndex = smooth.size();
      smooth.push_back(source.given);
    }
    sources.push_back(std::move(source));
  }
  std::vector<Vec3d> points = positions(variables);
  for (Vec3d &p : points)
    p = placement.toCamera.point(p);
  limit = std::make_unique<LimitSurface>(shape, points, smooth);
  for (const auto &[a, b, sharpness] : shape.creases)
    if (std::isinf(sharpness))
      sharpEdges.insert(std::minmax(a, b));
  collect();
}

void SubdivisionDicer::collect() {
  // Without a rule for it, the surface ends where a vertex is not surrounded by faces.
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> faceCounts;
  auto eachEdge = [&](auto visit) {
    size_t first = 0;
    for (uint32_t count : shape.vertexCounts) {
      for (uint32_t k = 0; k < count; ++k) {
        uint32_t a = shape.vertices[first + k], b = shape.vertices[first + (k + 1) % count];
        visit(std::pair(std::min(a, b), std::max(a, b)));
      }
      first += count;
    }
  };
  std::set<uint32_t> onBorder;
  if (shape.boundary == SubdivisionShape::Boundary::None) {
    eachEdge([&](auto edge) { ++faceCounts[edge]; });
    for (const auto &[edge, count] : faceCounts)
      if (count == 1)
        onBorder.insert({edge.first, edge.second});
  }
  uint32_t first = 0;
  for (uint32_t face = 0; face < shape.vertexCounts.size(); ++face) {
    uint32_t count = shape.vertexCounts[face];
    bool shown = std::find(shape.holes.begin(), shape.holes.end(), face) == shape.holes.end();
    for (uint32_t k = 0; k < count; ++k)
      shown &= !onBorder.contains(shape.vertices[first + k]);
    if (shown && count == 4)
      quads.push_back({face, 0, first, true});
    for (uint32_t k = 0; k < count && shown && count != 4; ++k)
      quads.push_back({face, k, first, false});
    first += count;
  }
}

std::pair<uint32_t, uint32_t> SubdivisionDicer::edge(const Quad &quad, uint32_t side) const {
  constexpr uint32_t from[] = {0, 1, 3, 0}, to[] = {1, 2, 2, 3};
  if (quad.whole)
    return {vertex(quad, from[side]), vertex(quad, to[side])};
  uint32_t last = shape.vertexCounts[quad.face] - 1;
  bool next = side == 0 || side == 1; // else the edge to the corner before
  return {vertex(quad, 0), vertex(quad, next ? 1 : last)};
}

uint32_t &SubdivisionDicer::pieces(const Quad &quad, uint32_t side) {
  auto [a, b] = edge(quad, side);
  if (quad.whole || isHalfEdge(quad, side))
    return borderPieces[{OnEdge, std::min(a, b), std::max(a, b), 0}];
  return borderPieces[{AtCenter, quad.face, 0, 0}];
}

SubdivisionDicer::Key SubdivisionDicer::key(const Quad &quad, uint32_t side, uint32_t j,
                                            uint32_t count) const {
  auto [a, b] = edge(quad, side);
  auto onEdge = [&](uint32_t i, uint32_t n) -> Key {
    if (i == 0 || i == n)
      return {AtVertex, i == 0 ? a : b, 0, 0};
    return {OnEdge, std::min(a, b), std::max(a, b), a < b ? i : n - i};
  };
  if (quad.whole)
    return onEdge(j, count);
  if (isHalfEdge(quad, side))
    return onEdge(j, 2 * count);
  if (j == count)
    return {AtCenter, quad.face, 0, 0};
  if (j == 0) { // the middle of the edge
    uint32_t n = borderPieces.at({OnEdge, std::min(a, b), std::max(a, b), 0});
    return onEdge(n / 2, n);
  }
  uint32_t corners = shape.vertexCounts[quad.face];
  uint32_t spoke = side == 1 ? quad.corner : (quad.corner + corners - 1) % corners;
  return {OnSpoke, quad.face, spoke, j};
}

Place SubdivisionDicer::besideSharp(const Quad &quad, Place at) const {
  // Embree stops dividing the faces beside an infinitely sharp edge when they are this small.
  constexpr double step = 0x1p-8;
  bool x0 = at.x == 0, x1 = at.x == 1, y0 = at.y == 0, y1 = at.y == 1;
  auto isSharp = [&](uint32_t side) {
    return (quad.whole || isHalfEdge(quad, side)) &&
           sharpEdges.contains(std::minmax(edge(quad, side).first, edge(quad, side).second));
  };
  if ((x0 && isSharp(3)) || (x1 && isSharp(1)))
    at.x += x0 ? step : -step;
  if ((y0 && isSharp(0)) || (y1 && isSharp(2)))
    at.y += y0 ? step : -step;
  return at;
}

SurfaceFrame SubdivisionDicer::evaluate(const Quad &quad, Place at) const {
  Place place = besideSharp(quad, at);
  SurfaceFrame frame = limit->evaluate(quad.face, quad.corner, place.x, place.y);
  frame.P += frame.dPdu * (at.x - place.x) + frame.dPdv * (at.y - place.y);
  return frame;
}

Vec3d SubdivisionDicer::normal(const Quad &quad, const SurfaceFrame &frame, Place at) const {
  auto isDegenerate = [](const SurfaceFrame &f) {
    double size = length(f.dPdu) * length(f.dPdv);
    return !(length(cross(f.dPdu, f.dPdv)) > 1e-5 * size && size > 0);
  };
  SurfaceFrame beside = frame;
  double towards = at.x < 0.5 ? 1 : -1, upwards = at.y < 0.5 ? 1 : -1;
  for (double step = 1e-4; step < 0.1 && isDegenerate(beside); step *= 4)
    beside = limit->evaluate(quad.face, quad.corner, at.x + towards * step, at.y + upwards * step);
  return normalized(cross(beside.dPdu, beside.dPdv)) * placement.normalSign;
}

/// Values at the corners of a face run bilinearly over it, and over its parts.
void SubdivisionDicer::cornerValue(const Variable &variable, bool perFace, const Quad &quad,
                                   Place at, float *value) const {
  uint32_t count = shape.vertexCounts[quad.face];
  auto corner = [&](uint32_t k) {
    return variable.at(perFace ? quad.first + (quad.corner + k) % count : vertex(quad, k));
  };
  double x = at.x, y = at.y;
  for (uint32_t c = 0; c < variable.components; ++c) {
    double v[4]; // at (0,0) (1,0) (1,1) (0,1)
    if (quad.whole) {
      for (uint32_t k = 0; k < 4; ++k)
        v[k] = corner(k)[c];
    } else {
      v[0] = corner(0)[c];
      v[1] = 0.5 * (v[0] + double(corner(1)[c]));
      v[3] = 0.5 * (v[0] + double(corner(count - 1)[c]));
      v[2] = 0;
      for (uint32_t k = 0; k < count; ++k)
        v[2] += double(corner(k)[c]) / count;
    }
    value[c] = float((1 - y) * ((1 - x) * v[0] + x * v[1]) + y * ((1 - x) * v[3] + x * v[2]));
  }
}

void SubdivisionDicer::addValues(const Quad &quad, Place at) {
  for (Source &source : sources) {
    if (source.storage == StorageClass::Constant || source.storage == StorageClass::Uniform)
      continue;
    std::vector<float> &values = source.diced.values;
    values.resize(values.size() + source.given.components);
    float *value = values.data() + values.size() - source.given.components;
    if (source.storage == StorageClass::Vertex) {
      Place place = besideSharp(quad, at);
      limit->value(source.limitIndex, quad.face, quad.corner, place.x, place.y, value);
      if (place.x == at.x && place.y == at.y)
        continue;
      std::vector<float> further(source.given.components);
      limit->value(source.limitIndex, quad.face, quad.corner, 2 * place.x - at.x,
                   2 * place.y - at.y, further.data());
      for (size_t k = 0; k < further.size(); ++k)
        value[k] = 2 * value[k] - further[k];
    } else {
      cornerValue(source.given, source.storage == StorageClass::FaceVarying, quad, at, value);
    }
  }
}

void SubdivisionDicer::addQuad(const Quad &quad) {
  uint32_t count[sides];
  for (uint32_t side = 0; side < sides; ++side)
    count[side] = pieces(quad, side) / (isHalfEdge(quad, side) ? 2 : 1);
  uint32_t nx = std::max(count[0], count[2]), ny = std::max(count[1], count[3]);
  uint32_t firstCorner = uint32_t(mesh->parameters.size());
  bool isDrawn = shape.drawn.contain(quad.face);
  std::vector<uint32_t> pointOf;
  for (uint32_t j = 0; j <= ny; ++j)
    for (uint32_t i = 0; i <= nx; ++i) {
      Place at{double(i) / nx, double(j) / ny};
      uint32_t side = j == 0 ? 0 : j == ny ? 2 : i == nx ? 1 : i == 0 ? 3 : sides;
      if (side == sides && !isDrawn) // only what other faces may share
        continue;
      uint32_t point = uint32_t(mesh->points.size());
      if (side < sides) {
        uint32_t along = side % 2 ? j : i, lines = side % 2 ? ny : nx, n = count[side];
        uint32_t nearest = uint32_t((uint64_t(along) * n * 2 + lines) / (2 * uint64_t(lines)));
        at = onSide(side, double(nearest) / n);
        point = borderPoints.try_emplace(key(quad, side, nearest, n), point).first->second;
      }
      SurfaceFrame frame = evaluate(quad, at);
      if (point == mesh->points.size())
        mesh->points.push_back(Vec3f(frame.P));
      if (!isDrawn)
        continue;
      pointOf.push_back(point);
      Vec3d n = normal(quad, frame, at);
      mesh->parameters.push_back({float(at.x), float(at.y)});
      mesh->dPdu.push_back(Vec3f(frame.dPdu));
      mesh->dPdv.push_back(Vec3f(frame.dPdv));
      for (int k = 0; k < 3; ++k)
        mesh->normals.values.push_back(float(n[k]));
      addValues(quad, at);
    }
  auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
    uint32_t p = pointOf[a], q = pointOf[b], r = pointOf[c];
    if (p == q || q == r || p == r)
      return;
    mesh->addTriangle(p, q, r);
    mesh->corners.push_back({firstCorner + a, firstCorner + b, firstCorner + c});
    mesh->faces.push_back(quad.face);
  };
  for (uint32_t j = 0; j < ny && isDrawn; ++j)
    for (uint32_t i = 0; i < nx; ++i) {
      uint32_t corner = j * (nx + 1) + i, above = corner + nx + 1;
      add(corner, corner + 1, above + 1);
      add(corner, above + 1, above);
    }
}

std::unique_ptr<Mesh> SubdivisionDicer::run(const Dicing &dicing) {
  std::vector<std::array<uint32_t, sides>> counts(quads.size());
  tbb::parallel_for(size_t(0), quads.size(), [&](size_t i) {
    for (uint32_t side = 0; side < sides; ++side)
      counts[i][side] = dicing.segments([&](double t) {
        Place at = onSide(side, t);
        return limit->evaluate(quads[i].face, quads[i].corner, at.x, at.y);
      });
  });
  for (size_t i = 0; i < quads.size(); ++i)
    for (uint32_t side = 0; side < sides; ++side) {
      // Edges can be halved.
      const Quad &quad = quads[i];
      uint32_t count = counts[i][side];
      count = isHalfEdge(quad, side) ? 2 * count : quad.whole ? count + count % 2 : count;
      uint32_t &most = pieces(quad, side);
      most = std::max(most, count);
    }
  double facets = 0;
  for (const Quad &quad : quads)
    facets += 2.0 * pieces(quad, 0) * pieces(quad, 1);
  if (double coarser = std::sqrt(facets / double(Dicing::mostFacets)); coarser > 1)
    for (auto &[border, count] : borderPieces) {
      count = std::max(1u, uint32_t(count / coarser));
      count += border[0] == OnEdge ? count % 2 : 0;
    }

  mesh = std::make_unique<Mesh>(placement);
  mesh->normals.name = "N";
  mesh->normals.type = ValueType::Normal;
  mesh->normals.domain = Domain::Corner;
  mesh->normals.components = 3;
  for (const Quad &quad : quads)
    addQuad(quad);
  mesh->dropUnusedPoints();
  std::vector<Variable> values;
  for (Source &source : sources) {
    if (source.storage == StorageClass::Constant || source.storage == StorageClass::Uniform) {
      source.diced.values = std::move(source.given.values);
      source.diced.domain =
          source.storage == StorageClass::Uniform ? Domain::Face : Domain::Constant;
    }
    values.push_back(std::move(source.diced));
  }
  mesh->values = SurfaceVariables(std::move(values));
  return std::move(mesh);
}

} // namespace

std::unique_ptr<Mesh> anysl::render::tessellate(const SubdivisionShape &shape,
                                                const ParameterList &variables,
                                                const Placement &placement, const Dicing &dicing) {
  return SubdivisionDicer(shape, variables, placement).run(dicing);
}
