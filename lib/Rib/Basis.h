//===-- lib/Rib/Basis.h - bases of cubic curves and patches -----------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_RIB_BASIS_H
#define ANYSL_LIB_RIB_BASIS_H

#include <array>
#include <cstdint>
#include <string_view>

namespace anysl::render {

/// How four control values in a row make a cubic curve: (t³ t² t 1) M (g0 g1 g2 g3), M row by row.
/// The next segment's values begin `step` further on.
struct Basis {
  std::array<double, 16> m;
  uint32_t step;

  /// The weights of the four control values at t, and their derivatives by t.
  void weights(double t, double value[4], double derivative[4]) const;
  /// How many segments `count` control values make, where they go round or not; 0: they do not fit.
  uint32_t segments(uint32_t count, bool wraps) const;
  friend bool operator==(const Basis &, const Basis &) = default;

  static const Basis bezier;
};

/// "bezier", "b-spline", "catmull-rom", "hermite" or "power"; null for another name.
const Basis *findBasis(std::string_view name);

} // namespace anysl::render

#endif
