//===-- tools/anysl-render/Patches.cpp - bilinear and bicubic patches and meshes --------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/ControlPoints.h"
#include "tools/anysl-render/Tessellate.h"

using namespace anysl::render;

namespace {

/// The control values that count at a place of one direction.
struct Weights {
  uint32_t count, index[4];
  double value[4], derivative[4];

  Weights(const PatchShape::Direction &direction, bool cubic, uint32_t segment, double t) {
    uint32_t first = segment;
    if (cubic) {
      count = 4;
      direction.basis.weights(t, value, derivative);
      first *= direction.basis.step;
    } else {
      count = 2;
      value[0] = 1 - t, value[1] = t;
      derivative[0] = -1, derivative[1] = 1;
    }
    for (uint32_t k = 0; k < count; ++k)
      index[k] = (first + k) % direction.count;
  }
};

class PatchMesh : public PatchGrid {
public:
  PatchMesh(const PatchShape &shape, ControlPoints points)
      : PatchGrid(shape.u.segments(shape.cubic), shape.v.segments(shape.cubic), shape.u.wraps,
                  shape.v.wraps, shape.drawn),
        shape(shape), points(std::move(points)) {}

  SurfaceFrame evaluate(uint32_t column, uint32_t row, double x, double y) const override {
    Weights u(shape.u, shape.cubic, column, x), v(shape.v, shape.cubic, row, y);
    ControlPoint p, byX, byY;
    for (uint32_t j = 0; j < v.count; ++j)
      for (uint32_t i = 0; i < u.count; ++i) {
        const ControlPoint &point = points[size_t(v.index[j]) * shape.u.count + u.index[i]];
        p.add(point, u.value[i] * v.value[j]);
        byX.add(point, u.derivative[i] * v.value[j]);
        byY.add(point, u.value[i] * v.derivative[j]);
      }
    SurfaceFrame frame = points.frame(p, byX, byY);
    frame.u = (column + x) / columns;
    frame.v = (row + y) / rows;
    frame.dPdu = frame.dPdu * double(columns);
    frame.dPdv = frame.dPdv * double(rows);
    return frame;
  }

  void vertexValue(const Variable &variable, uint32_t column, uint32_t row, double x, double y,
                   float *value) const override {
    Weights u(shape.u, shape.cubic, column, x), v(shape.v, shape.cubic, row, y);
    for (uint32_t c = 0; c < variable.components; ++c) {
      double sum = 0;
      for (uint32_t j = 0; j < v.count; ++j)
        for (uint32_t i = 0; i < u.count; ++i)
          sum += u.value[i] * v.value[j] *
                 double(variable.at(size_t(v.index[j]) * shape.u.count + u.index[i])[c]);
      value[c] = float(sum);
    }
  }

private:
  const PatchShape &shape;
  ControlPoints points;
};

} // namespace

std::unique_ptr<Mesh> anysl::render::tessellate(const PatchShape &shape,
                                                const ParameterList &variables,
                                                const Placement &placement, const Dicing &dicing) {
  return dice(PatchMesh(shape, ControlPoints(variables, placement.toCamera)), variables, placement,
              dicing);
}
