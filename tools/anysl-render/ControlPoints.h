//===-- tools/anysl-render/ControlPoints.h - points with weights ------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_CONTROLPOINTS_H
#define ANYSL_RENDER_CONTROLPOINTS_H

#include "tools/anysl-render/Surface.h"

namespace anysl::render {

/// A homogeneous point: its place times its weight, and the weight.
struct ControlPoint {
  Vec3d p;
  double w = 0;

  void add(const ControlPoint &other, double factor) {
    p += other.p * factor;
    w += other.w * factor;
  }
};

/// The control points of a surface in object space: "P", or "Pw" with weights. They go to camera
/// space only as points of the surface, since some bases mix points and vectors.
class ControlPoints {
public:
  ControlPoints(const ParameterList &variables, const Matrix4 &toCamera) : toCamera(toCamera) {
    const Parameter *parameter = findParameter(variables, "P");
    rational = !parameter;
    if (rational)
      parameter = findParameter(variables, "Pw");
    size_t each = rational ? 4 : 3;
    for (size_t i = 0; parameter && i + each <= parameter->numbers.size(); i += each) {
      const double *n = parameter->numbers.data() + i;
      points.push_back({{n[0], n[1], n[2]}, rational ? n[3] : 1});
    }
  }

  const ControlPoint &operator[](size_t index) const { return points[index]; }

  /// A surface's place and derivatives in camera space from those of its homogeneous points.
  SurfaceFrame frame(const ControlPoint &p, const ControlPoint &byU,
                     const ControlPoint &byV) const {
    SurfaceFrame frame;
    if (rational) {
      double scale = 1 / p.w;
      frame.P = p.p * scale;
      frame.dPdu = (byU.p - frame.P * byU.w) * scale;
      frame.dPdv = (byV.p - frame.P * byV.w) * scale;
    } else {
      frame.P = p.p, frame.dPdu = byU.p, frame.dPdv = byV.p;
    }
    frame.P = toCamera.affinePoint(frame.P);
    frame.dPdu = toCamera.vector(frame.dPdu);
    frame.dPdv = toCamera.vector(frame.dPdv);
    return frame;
  }

private:
  const Matrix4 &toCamera;
  bool rational;
  std::vector<ControlPoint> points;
};

} // namespace anysl::render

#endif
