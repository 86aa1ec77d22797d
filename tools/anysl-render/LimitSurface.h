//===-- tools/anysl-render/LimitSurface.h - what subdivision leads to -------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_LIMITSURFACE_H
#define ANYSL_RENDER_LIMITSURFACE_H

#include "tools/anysl-render/Surface.h"

#include <span>

namespace anysl::render {

/// The limit of a Catmull-Clark surface, evaluated by Embree: places, derivatives, and values that
/// follow the same rules.
class LimitSurface {
public:
  /// `points` in camera space; variables with as many values.
  LimitSurface(const SubdivisionShape &shape, std::span<const Vec3d> points,
               std::span<const Variable> variables);
  ~LimitSurface();
  LimitSurface(const LimitSurface &) = delete;
  LimitSurface &operator=(const LimitSurface &) = delete;

  /// At (x, y) of a face with four corners, which lie at (0,0) (1,0) (1,1) (0,1); of a face with
  /// another number, at a place of the quarter at one corner, which has that corner at (0,0), the
  /// middle of the edge to the next one at (1,0) and the face's centre at (1,1).
  SurfaceFrame evaluate(uint32_t face, uint32_t corner, double x, double y) const;
  void value(size_t variable, uint32_t face, uint32_t corner, double x, double y,
             float *result) const;

private:
  std::pair<float, float> place(uint32_t face, uint32_t corner, double x, double y) const;
  template <typename T>
  void fill(RTCBufferType type, RTCFormat format, const std::vector<T> &values);
  float *makeValues(RTCBufferType type, unsigned slot, unsigned width, size_t count);

  const SubdivisionShape &shape;
  RTCScene scene;
  RTCGeometry geometry;
  /// Embree's buffers of values are at most 16 wide.
  struct Part {
    unsigned slot, first, width;
  };
  std::vector<std::vector<Part>> parts; ///< of each variable
};

} // namespace anysl::render

#endif
