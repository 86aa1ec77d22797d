//===-- lib/Cost/Choosing.h - the cheapest that is exact enough -------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_CHOOSING_H
#define ANYSL_LIB_COST_CHOOSING_H

#include "lib/Cost/Sites.h"

namespace anysl::cost {

/// What was chosen, and what it is worth. Times are nanoseconds for a point of every shader.
struct Chosen {
  std::string real;
  Choice choice;
  double time = 0, exactTime = 0; ///< of the choice; of the same inputs in the exact build
  std::string exactReal; ///< of the exact build: the first real that stays within the error
  double error = 0;      ///< the largest, against the oracle
};

/// Measures which choice of tiers, of one for all and of one for each site, and which real is the
/// fastest whose largest error against the oracle is at most \p error for every shader. The exact
/// build is the one with functions rounded correctly in the first real with which that holds.
/// Nothing, with \p best set to the smallest error that was met, where nothing is exact enough.
/// \p width 0 is the widest that is built.
std::optional<Chosen> chooseWithin(std::vector<Bench *> benches,
                                   const std::vector<std::string> &reals, unsigned width,
                                   double error, const Timing &timing, double &best);

} // namespace anysl::cost

#endif
