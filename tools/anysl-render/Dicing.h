//===-- tools/anysl-render/Dicing.h - smooth surfaces to fine facets --------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_DICING_H
#define ANYSL_RENDER_DICING_H

#include "lib/Rib/Camera.h"
#include "tools/anysl-render/Mesh.h"

#include <functional>
#include <span>

namespace anysl::render {

/// How finely surfaces are cut: so that no facet is further from the surface than a tenth of a
/// pixel, as the camera sees it, and normals turn little from one corner to the next; displaced
/// ones into facets of a size in pixels.
class Dicing {
public:
  explicit Dicing(const Camera &camera) : camera(camera) {}

  /// Facets of about so many pixels square; 0: by how the surface bends.
  double edge = 0;

  /// Into how many pieces to cut a curve on a surface that is seen at some points of it.
  uint32_t segments(std::span<const SurfaceFrame> curve) const;
  /// The same for the curve from 0 to 1 of a function.
  uint32_t segments(const std::function<SurfaceFrame(double)> &curve) const;

  /// Whether an edge between two places is longer than facets are meant to be.
  bool isLong(Vec3d a, Vec3d b) const {
    return edge > 0 && length(b - a) * camera.pixelsPerUnit((a + b) * 0.5) > 1.5 * edge;
  }

  static constexpr uint32_t most = 1024;         ///< pieces of one curve
  static constexpr size_t mostFacets = 1u << 22; ///< of one shape, about

private:
  const Camera &camera;
};

/// A surface of columns x rows patches, each with parameters x and y in the unit square.
class PatchGrid {
public:
  PatchGrid(uint32_t columns, uint32_t rows, bool wrapsU, bool wrapsV, DrawnFaces drawn = {})
      : columns(columns), rows(rows), wrapsU(wrapsU), wrapsV(wrapsV), drawn(std::move(drawn)) {}
  virtual ~PatchGrid() = default;

  /// The surface in camera space, with its parameters and the derivatives by them. The normal is
  /// left out.
  virtual SurfaceFrame evaluate(uint32_t column, uint32_t row, double x, double y) const = 0;
  /// Whether a patch has no extent, as between equal knots; it is not evaluated.
  virtual bool isEmpty(uint32_t, uint32_t) const { return false; }
  /// A variable of class vertex.
  virtual void vertexValue(const Variable &variable, uint32_t column, uint32_t row, double x,
                           double y, float *value) const = 0;

  uint32_t columns, rows;
  bool wrapsU, wrapsV; ///< the last patches border on the first
  DrawnFaces drawn;

  uint32_t face(uint32_t column, uint32_t row) const { return row * columns + column; }
  bool isDrawn(uint32_t column, uint32_t row) const {
    return !isEmpty(column, row) && drawn.contain(face(column, row));
  }

  /// The value of a variable of any class that is not the same all over a patch.
  void value(const Variable &variable, StorageClass storage, uint32_t column, uint32_t row,
             double x, double y, float *value) const;
};

/// Cuts a grid of patches into facets.
std::unique_ptr<Mesh> dice(const PatchGrid &grid, const ParameterList &variables,
                           const Placement &placement, const Dicing &dicing);

} // namespace anysl::render

#endif
