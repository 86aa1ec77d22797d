//===-- tools/anysl-render/Nurbs.cpp - non-uniform rational B-spline surfaces -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-render/ControlPoints.h"
#include "tools/anysl-render/Tessellate.h"

#include <algorithm>

using namespace anysl::render;

namespace {

/// The B-splines that are not zero between two knots, at one place; their number is the order.
class Splines {
public:
  /// After Piegl and Tiller, The NURBS Book, algorithm 2.2; the derivative from the splines of one
  /// order less.
  Splines(const NurbsShape::Direction &d, uint32_t segment, double t) : first(segment) {
    uint32_t order = d.order, knot = segment + order - 1;
    value.assign(order, 0);
    derivative.assign(order, 0);
    value[0] = 1;
    auto span = [&](uint32_t begin, uint32_t end) { return d.knots[end] - d.knots[begin]; };
    for (uint32_t degree = 1; degree < order; ++degree) {
      double saved = 0, savedDerivative = 0;
      for (uint32_t k = 0; k < degree; ++k) {
        uint32_t left = knot + 1 + k - degree, right = knot + 1 + k;
        // Not zero, since the span that t lies in is part of it.
        double part = value[k] / span(left, right);
        double slope = degree * part;
        value[k] = saved + (d.knots[right] - t) * part;
        saved = (t - d.knots[left]) * part;
        if (degree + 1 == order) {
          derivative[k] = savedDerivative - slope;
          savedDerivative = slope;
        }
      }
      value[degree] = saved;
      if (degree + 1 == order)
        derivative[degree] = savedDerivative;
    }
  }

  uint32_t first; ///< control value
  std::vector<double> value, derivative;
};

/// Where in a segment, as far as it is drawn, x is, as the knots count.
double place(const NurbsShape::Direction &d, uint32_t segment, double x) {
  double begin = std::clamp(d.knots[segment + d.order - 1], d.min, d.max);
  double end = std::clamp(d.knots[segment + d.order], d.min, d.max);
  return begin + (end - begin) * x;
}

class NurbsGrid : public PatchGrid {
public:
  NurbsGrid(const NurbsShape &shape, ControlPoints points)
      : PatchGrid(shape.u.segments(), shape.v.segments(), false, false, shape.drawn), shape(shape),
        points(std::move(points)) {}

  bool isEmpty(uint32_t column, uint32_t row) const override {
    return !(place(shape.u, column, 1) > place(shape.u, column, 0)) ||
           !(place(shape.v, row, 1) > place(shape.v, row, 0));
  }

  SurfaceFrame evaluate(uint32_t column, uint32_t row, double x, double y) const override {
    double tu = place(shape.u, column, x), tv = place(shape.v, row, y);
    Splines u(shape.u, column, tu), v(shape.v, row, tv);
    ControlPoint p, byU, byV;
    for (uint32_t j = 0; j < shape.v.order; ++j)
      for (uint32_t i = 0; i < shape.u.order; ++i) {
        const ControlPoint &point = points[size_t(v.first + j) * shape.u.count + u.first + i];
        p.add(point, u.value[i] * v.value[j]);
        byU.add(point, u.derivative[i] * v.value[j]);
        byV.add(point, u.value[i] * v.derivative[j]);
      }
    SurfaceFrame frame = points.frame(p, byU, byV);
    // The shaders' parameters run from 0 to 1 over the range that is drawn.
    double rangeU = shape.u.max - shape.u.min, rangeV = shape.v.max - shape.v.min;
    frame.u = (tu - shape.u.min) / rangeU;
    frame.v = (tv - shape.v.min) / rangeV;
    frame.dPdu = frame.dPdu * rangeU;
    frame.dPdv = frame.dPdv * rangeV;
    return frame;
  }

  void vertexValue(const Variable &variable, uint32_t column, uint32_t row, double x, double y,
                   float *value) const override {
    Splines u(shape.u, column, place(shape.u, column, x)), v(shape.v, row, place(shape.v, row, y));
    for (uint32_t c = 0; c < variable.components; ++c) {
      double sum = 0, weight = 0;
      for (uint32_t j = 0; j < shape.v.order; ++j)
        for (uint32_t i = 0; i < shape.u.order; ++i) {
          size_t index = size_t(v.first + j) * shape.u.count + u.first + i;
          double factor = u.value[i] * v.value[j] * points[index].w;
          sum += factor * double(variable.at(index)[c]);
          weight += factor;
        }
      value[c] = float(sum / weight);
    }
  }

private:
  const NurbsShape &shape;
  ControlPoints points;
};

} // namespace

namespace {

/// Puts a curve's points at the end of an outline, in parameters that run from 0 to 1 over the part
/// of the surface that is drawn: its ends, and between them as many in each piece as make a bent
/// curve look like one.
void append(const NurbsShape &shape, const NurbsShape::TrimCurve &curve,
            TrimRegion::Outline &outline) {
  const NurbsShape::Direction &d = curve.direction;
  uint32_t steps = d.order > 2 ? 64 : 1;
  for (uint32_t segment = 0; segment < d.segments(); ++segment) {
    double begin = place(d, segment, 0), end = place(d, segment, 1);
    for (uint32_t step = 0; begin < end && step <= steps; ++step) {
      Splines splines(d, segment, begin + (end - begin) * step / steps);
      double u = 0, v = 0, w = 0;
      for (uint32_t k = 0; k < d.order; ++k) {
        const auto &[pu, pv, pw] = curve.points[splines.first + k];
        u += splines.value[k] * pu, v += splines.value[k] * pv, w += splines.value[k] * pw;
      }
      outline.push_back({(u / w - shape.u.min) / (shape.u.max - shape.u.min),
                         (v / w - shape.v.min) / (shape.v.max - shape.v.min)});
    }
  }
}

} // namespace

std::unique_ptr<Mesh> anysl::render::tessellate(const NurbsShape &shape,
                                                const ParameterList &variables,
                                                const Placement &placement, const Dicing &dicing) {
  std::unique_ptr<Mesh> mesh = dice(NurbsGrid(shape, ControlPoints(variables, placement.toCamera)),
                                    variables, placement, dicing);
  if (shape.trims) {
    std::vector<TrimRegion::Outline> outlines;
    for (const NurbsShape::TrimLoop &loop : *shape.trims) {
      outlines.emplace_back();
      for (const NurbsShape::TrimCurve &curve : loop)
        append(shape, curve, outlines.back());
    }
    mesh->trim.emplace(outlines, shape.isOutsideTrims);
  }
  return mesh;
}
