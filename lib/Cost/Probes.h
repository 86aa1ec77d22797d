//===-- lib/Cost/Probes.h - which arguments functions see -------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_PROBES_H
#define ANYSL_LIB_COST_PROBES_H

#include "lib/Cost/Bench.h"

namespace anysl::cost {

/// What a site was called with.
struct SiteArguments {
  Site site;
  uint64_t calls = 0; ///< over all points
  unsigned count = 1; ///< arguments of the function: one or two
  /// The range of each argument, without NaN; no call, no range (low > high).
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
};

/// Runs shaders on their points in a build that notes arguments, one point at a time.
std::vector<SiteArguments> probe(const std::vector<Bench *> &benches, const std::string &real);

} // namespace anysl::cost

#endif
