//===-- lib/Rib/Basis.cpp - bases of cubic curves and patches ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/Basis.h"
#include "lib/Rib/SceneDescription.h"

#include <utility>

using namespace anysl::render;

const Basis Basis::bezier = {{-1, 3, -3, 1, 3, -6, 3, 0, -3, 3, 0, 0, 1, 0, 0, 0}, 3};

const Basis *anysl::render::findBasis(std::string_view name) {
  static const std::pair<std::string_view, Basis> bases[] = {
      {"bezier", Basis::bezier},
      {"b-spline",
       {{-1. / 6, 3. / 6, -3. / 6, 1. / 6, 3. / 6, -6. / 6, 3. / 6, 0, -3. / 6, 0, 3. / 6, 0,
         1. / 6, 4. / 6, 1. / 6, 0},
        1}},
      {"catmull-rom", {{-.5, 1.5, -1.5, .5, 1, -2.5, 2, -.5, -.5, 0, .5, 0, 0, 1, 0, 0}, 1}},
      {"hermite", {{2, 1, -2, 1, -3, -2, 3, -1, 0, 1, 0, 0, 1, 0, 0, 0}, 2}},
      {"power", {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 4}}};
  for (const auto &[known, basis] : bases)
    if (known == name)
      return &basis;
  return nullptr;
}

void Basis::weights(double t, double value[4], double derivative[4]) const {
  for (size_t k = 0; k < 4; ++k) {
    double a = m[k], b = m[4 + k], c = m[8 + k], d = m[12 + k];
    value[k] = ((a * t + b) * t + c) * t + d;
    derivative[k] = (3 * a * t + 2 * b) * t + c;
  }
}

uint32_t Basis::segments(uint32_t count, bool wraps) const {
  if (count < (wraps ? 3 : 4) || step == 0)
    return 0;
  uint32_t beyond = wraps ? count : count - 4;
  return beyond % step != 0 ? 0 : beyond / step + !wraps;
}

uint32_t CurvesShape::segments(uint32_t count) const {
  return cubic ? basis.segments(count, wraps) : count < 2 ? 0 : count - !wraps;
}

uint32_t PatchShape::Direction::segments(bool cubic) const {
  return cubic ? basis.segments(count, wraps) : count - !wraps;
}
