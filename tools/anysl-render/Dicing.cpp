//===-- tools/anysl-render/Dicing.cpp - smooth surfaces to fine facets ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/Dicing.h"

#include <algorithm>

using namespace anysl::render;

uint32_t Dicing::segments(std::span<const SurfaceFrame> curve) const {
  // How long the curve is in pixels, and how much the surface changes along it: its tangents, which
  // tell of curvature and of uneven parameters, as parts of the longest, and its unit normal.
  double pixels = 0, longestU = 0, longestV = 0, changeU = 0, changeV = 0, turn = 0;
  for (size_t i = 0; i < curve.size(); ++i) {
    const SurfaceFrame &here = curve[i];
    longestU = std::max(longestU, length(here.dPdu));
    longestV = std::max(longestV, length(here.dPdv));
    if (i == 0)
      continue;
    const SurfaceFrame &before = curve[i - 1];
    Vec3d middle = (here.P + before.P) * 0.5;
    pixels += length(here.P - before.P) * camera.pixelsPerUnit(middle);
    changeU += length(here.dPdu - before.dPdu);
    changeV += length(here.dPdv - before.dPdv);
    Vec3d n0 = normalized(cross(before.dPdu, before.dPdv));
    Vec3d n1 = normalized(cross(here.dPdu, here.dPdv));
    if (n0 != Vec3d() && n1 != Vec3d())
      turn += length(n1 - n0);
  }
  double count;
  if (edge > 0) {
    count = pixels / edge;
  } else {
    double change = std::max(turn, std::max(longestU > 0 ? changeU / longestU : 0,
                                            longestV > 0 ? changeV / longestV : 0));
    // A chord of length l over a turn of a is l a / 8 off the arc. The arcs of n pieces: l a / n².
    constexpr double tolerance = 0.05, mostTurn = 0.06;
    count = std::max(std::sqrt(pixels * change / (8 * tolerance)), change / mostTurn);
  }
  // Written so that NaN gives 1.
  return count > 1 ? uint32_t(std::min(std::ceil(count - 1e-6), double(most))) : 1;
}

uint32_t Dicing::segments(const std::function<SurfaceFrame(double)> &curve) const {
  SurfaceFrame samples[9];
  for (size_t i = 0; i < 9; ++i)
    samples[i] = curve(double(i) / 8);
  return segments(samples);
}

void PatchGrid::value(const Variable &variable, StorageClass storage, uint32_t column, uint32_t row,
                      double x, double y, float *value) const {
  if (storage == StorageClass::Vertex)
    return vertexValue(variable, column, row, x, y, value);
  const double weights[4] = {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
  size_t corner[4];
  uint32_t across = columns + !wrapsU, up = rows + !wrapsV;
  for (uint32_t k = 0; k < 4; ++k)
    corner[k] = storage == StorageClass::FaceVarying
                    ? (size_t(row) * columns + column) * 4 + k
                    : size_t((row + k / 2) % up) * across + (column + k % 2) % across;
  for (uint32_t c = 0; c < variable.components; ++c) {
    double sum = 0;
    for (size_t k = 0; k < 4; ++k)
      sum += weights[k] * double(variable.at(corner[k])[c]);
    value[c] = float(sum);
  }
}

namespace {

/// The lines of a grid in one direction: in each patch, pieces of equal steps.
struct Lines {
  std::vector<uint32_t> pieces; ///< of each patch
  std::vector<uint32_t> first;  ///< line at which each patch begins
  uint32_t last = 0;

  explicit Lines(std::vector<uint32_t> given) : pieces(std::move(given)) {
    for (uint32_t count : pieces) {
      first.push_back(last);
      last += count;
    }
  }
};

class GridDicer {
public:
  GridDicer(const PatchGrid &grid, const Placement &placement, const Dicing &dicing)
      : grid(grid), placement(placement), across(pieces(dicing, true)), up(pieces(dicing, false)) {}

  std::unique_ptr<Mesh> run(const ParameterList &variables);

private:
  std::vector<uint32_t> pieces(const Dicing &dicing, bool inU);
  void addPatch(uint32_t column, uint32_t row);
  Vec3d normal(const SurfaceFrame &frame, uint32_t column, uint32_t row, double x, double y) const;
  void weld();
  size_t pointAt(uint32_t i, uint32_t j) const { return size_t(j) * (across.last + 1) + i; }
  bool same(size_t a, size_t b) const {
    return double(maxAbs(mesh->points[a] - mesh->points[b])) <= tolerance;
  }

  const PatchGrid &grid;
  const Placement &placement;
  double longestU = 0, longestV = 0; ///< of the tangents
  Lines across, up;
  double tolerance = 0;
  std::unique_ptr<Mesh> mesh;
};

std::vector<uint32_t> GridDicer::pieces(const Dicing &dicing, bool inU) {
  // One number for a whole column or row, so that patches meet point by point.
  std::vector<uint32_t> result(inU ? grid.columns : grid.rows, 0);
  for (uint32_t row = 0; row < grid.rows; ++row)
    for (uint32_t column = 0; column < grid.columns; ++column)
      for (double side : {0.0, 0.5, 1.0}) {
        if (grid.isEmpty(column, row))
          continue;
        uint32_t count = dicing.segments([&](double x) {
          SurfaceFrame frame =
              inU ? grid.evaluate(column, row, x, side) : grid.evaluate(column, row, side, x);
          longestU = std::max(longestU, length(frame.dPdu));
          longestV = std::max(longestV, length(frame.dPdv));
          return frame;
        });
        uint32_t &most = result[inU ? column : row];
        most = std::max(most, count);
      }
  // No more in all than memory bears, by making all coarser.
  double sum = 0, limit = std::sqrt(double(Dicing::mostFacets) / 2);
  for (uint32_t count : result)
    sum += count;
  if (sum > limit)
    for (uint32_t &count : result)
      count = std::max(std::min(count, 1u), uint32_t(count * (limit / sum)));
  return result;
}

Vec3d GridDicer::normal(const SurfaceFrame &frame, uint32_t column, uint32_t row, double x,
                        double y) const {
  auto isDegenerate = [&](const SurfaceFrame &f) {
    double u = length(f.dPdu), v = length(f.dPdv);
    return !(u > 1e-6 * longestU && v > 1e-6 * longestV &&
             length(cross(f.dPdu, f.dPdv)) > 1e-9 * u * v);
  };
  // Where a side of the patch has shrunk to a point, the normal is that of the surface beside it.
  SurfaceFrame beside = frame;
  double towards = x < 0.5 ? 1 : -1, upwards = y < 0.5 ? 1 : -1;
  for (double step = 1e-5; step < 0.1 && isDegenerate(beside); step *= 4)
    beside = grid.evaluate(column, row, x + towards * step, y + upwards * step);
  Vec3d n = cross(beside.dPdu, beside.dPdv);
  return normalized(n) * placement.normalSign;
}

/// Makes one point of those that lie in the same place where the surface closes upon itself.
void GridDicer::weld() {
  std::vector<uint32_t> target(mesh->points.size());
  for (size_t i = 0; i < target.size(); ++i)
    target[i] = uint32_t(i);
  auto joinLines = [&](uint32_t count, auto from, auto to) {
    for (uint32_t i = 0; i <= count; ++i)
      if (!same(from(i), to(i)))
        return;
    for (uint32_t i = 0; i <= count; ++i)
      target[to(i)] = target[from(i)];
  };
  auto left = [&](uint32_t j) { return pointAt(0, j); };
  auto right = [&](uint32_t j) { return pointAt(across.last, j); };
  auto bottom = [&](uint32_t i) { return pointAt(i, 0); };
  auto top = [&](uint32_t i) { return pointAt(i, up.last); };
  joinLines(up.last, left, right);
  joinLines(across.last, bottom, top);
  joinLines(up.last, [&](uint32_t) { return left(0); }, left);
  joinLines(up.last, [&](uint32_t) { return right(0); }, right);
  joinLines(across.last, [&](uint32_t) { return bottom(0); }, bottom);
  joinLines(across.last, [&](uint32_t) { return top(0); }, top);
  for (size_t i = 0; i < target.size(); ++i)
    mesh->points[i] = mesh->points[target[i]];
  size_t kept = 0;
  for (size_t i = 0; i < mesh->triangles.size(); ++i) {
    auto [a, b, c] = mesh->triangles[i];
    std::array<uint32_t, 3> joined{target[a], target[b], target[c]};
    if (joined[0] == joined[1] || joined[1] == joined[2] || joined[0] == joined[2])
      continue;
    mesh->triangles[kept] = joined;
    mesh->corners[kept] = mesh->corners[i];
    mesh->faces[kept++] = mesh->faces[i];
  }
  mesh->triangles.resize(kept);
  mesh->corners.resize(kept);
  mesh->faces.resize(kept);
}

void GridDicer::addPatch(uint32_t column, uint32_t row) {
  uint32_t nx = across.pieces[column], ny = up.pieces[row];
  bool isDrawn = grid.isDrawn(column, row);
  uint32_t firstCorner = uint32_t(mesh->parameters.size());
  for (uint32_t j = 0; j <= ny; ++j)
    for (uint32_t i = 0; i <= nx; ++i) {
      double x = double(i) / nx, y = double(j) / ny;
      SurfaceFrame frame = grid.evaluate(column, row, x, y);
      mesh->points[pointAt(across.first[column] + i, up.first[row] + j)] = Vec3f(frame.P);
      if (!isDrawn)
        continue;
      Vec3d n = normal(frame, column, row, x, y);
      mesh->parameters.push_back({float(frame.u), float(frame.v)});
      mesh->dPdu.push_back(Vec3f(frame.dPdu));
      mesh->dPdv.push_back(Vec3f(frame.dPdv));
      for (int k = 0; k < 3; ++k)
        mesh->normals.values.push_back(float(n[k]));
    }
  for (uint32_t j = 0; j < ny && isDrawn; ++j)
    for (uint32_t i = 0; i < nx; ++i) {
      uint32_t corner = firstCorner + j * (nx + 1) + i, above = corner + nx + 1;
      auto point = [&](uint32_t di, uint32_t dj) {
        return uint32_t(pointAt(across.first[column] + i + di, up.first[row] + j + dj));
      };
      mesh->addTriangle(point(0, 0), point(1, 0), point(1, 1));
      mesh->addTriangle(point(0, 0), point(1, 1), point(0, 1));
      mesh->corners.push_back({corner, corner + 1, above + 1});
      mesh->corners.push_back({corner, above + 1, above});
      mesh->faces.insert(mesh->faces.end(), 2, grid.face(column, row));
    }
}

std::unique_ptr<Mesh> GridDicer::run(const ParameterList &variables) {
  mesh = std::make_unique<Mesh>(placement);
  mesh->points.resize(size_t(across.last + 1) * (up.last + 1));
  mesh->normals.name = "N";
  mesh->normals.type = ValueType::Normal;
  mesh->normals.domain = Domain::Corner;
  mesh->normals.components = 3;
  for (uint32_t row = 0; row < grid.rows; ++row)
    for (uint32_t column = 0; column < grid.columns; ++column)
      if (!grid.isEmpty(column, row))
        addPatch(column, row);
  for (const Vec3f &p : mesh->points)
    tolerance = std::max(tolerance, 4e-7 * double(maxAbs(p)));
  weld();
  mesh->dropUnusedPoints();

  std::vector<Variable> values;
  for (const Parameter &parameter : variables) {
    if (isPosition(parameter.name) || parameter.declaration->type == ValueType::String)
      continue;
    Variable given = cameraVariable(parameter, placement);
    StorageClass storage = parameter.declaration->storage;
    given.domain = storage == StorageClass::Uniform ? Domain::Face : Domain::Constant;
    if (storage == StorageClass::Constant || storage == StorageClass::Uniform) {
      values.push_back(std::move(given));
      continue;
    }
    Variable diced = given;
    diced.domain = Domain::Corner;
    diced.values.clear();
    std::vector<float> value(given.components);
    for (uint32_t row = 0; row < grid.rows; ++row)
      for (uint32_t column = 0; column < grid.columns; ++column) {
        uint32_t nx = across.pieces[column], ny = up.pieces[row];
        if (!grid.isDrawn(column, row))
          continue;
        for (uint32_t j = 0; j <= ny; ++j)
          for (uint32_t i = 0; i <= nx; ++i) {
            grid.value(given, storage, column, row, double(i) / nx, double(j) / ny, value.data());
            diced.values.insert(diced.values.end(), value.begin(), value.end());
          }
      }
    if (diced.name == "N")
      mesh->normals = diced;
    values.push_back(std::move(diced));
  }
  mesh->values = SurfaceVariables(std::move(values));
  return std::move(mesh);
}

} // namespace

std::unique_ptr<Mesh> anysl::render::dice(const PatchGrid &grid, const ParameterList &variables,
                                          const Placement &placement, const Dicing &dicing) {
  GridDicer dicer(grid, placement, dicing);
  return dicer.run(variables);
}
