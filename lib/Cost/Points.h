//===-- lib/Cost/Points.h - points of a shader made of others --------------------------------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_POINTS_H
#define ANYSL_LIB_COST_POINTS_H

#include "lib/Shade/Recording.h"

namespace anysl::cost {

/// A point on the way from one point of a recording to another.
struct Mixed {
  size_t from, to;
  double share; ///< of the way
};

/// Makes points of those of \p pool, in place of those that \p result has; numbers are rounded to
/// float.
void mix(const shade::RecordedShader &pool, const std::vector<Mixed> &wanted,
         shade::RecordedShader &result);

/// Puts more points of the same shader behind.
void append(shade::RecordedShader &pool, const shade::RecordedShader &more);

/// Sorts points by their seeds, which number them: a recorder scatters those of a grid.
void sortBySeed(shade::RecordedShader &shader);

/// The globals and varying parameters of a point, by name.
using Inputs = std::vector<std::pair<std::string, std::vector<float>>>;
/// Of the globals, those of the set \p globalsRead.
Inputs inputsOf(const shade::RecordedShader &pool, size_t point, uint64_t globalsRead);

} // namespace anysl::cost

#endif
