//===-- lib/Cost/Mixtures.h - tiers function by function --------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_MIXTURES_H
#define ANYSL_LIB_COST_MIXTURES_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"
#include <map>
#include <string>
#include <vector>

namespace anysl::cost {

/// The math tiers from the most exact to the cheapest, as runtimes/math/Tiers.def has them.
llvm::ArrayRef<llvm::StringRef> tiers();

/// Of the functions named, those of which the tiers' floats differ; the others are IEEE's own
/// operations in each.
std::vector<std::string> functionsWithTiers(llvm::ArrayRef<std::string> functions);

/// A tier for each function that has another than the first tier: "cr,sin=u35,pow=fast".
struct Mixture {
  std::map<std::string, std::string> tierOf;
  std::string name() const;
};

/// A change of one thing, a function or a place, from one tier to the next cheaper one.
struct Move {
  std::string subject, tier;
  double saved = 0; ///< time, in any unit
  double added = 0; ///< error, in any unit
};

/// The order in which to make moves so that each step buys the most time for the error that it
/// adds. Moves that save nothing are left out; of one subject, the more exact come first.
std::vector<Move> greedyOrder(std::vector<Move> moves);

} // namespace anysl::cost

#endif
