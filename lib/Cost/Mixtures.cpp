//===-- lib/Cost/Mixtures.cpp - tiers function by function ------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Mixtures.h"
#include "llvm/ADT/STLExtras.h"
#include <cmath>

using namespace llvm;

namespace anysl::cost {

ArrayRef<StringRef> tiers() {
  static const StringRef names[] = {
#define MATH_TIER(name, bound, boundForDouble) #name,
#include "runtimes/math/Tiers.def"
  };
  return names;
}

std::vector<std::string> functionsWithTiers(ArrayRef<std::string> functions) {
  // A float has 24 bits: what is as exact as that in the cheapest tier is rounded once in all.
  static const std::pair<StringRef, int> bits[] = {
#define MATH_UNARY(name, coreLow, coreHigh, fastBits) {#name, fastBits},
#define MATH_BINARY(name, coreLowX, coreHighX, coreLowY, coreHighY, fastBits) {#name, fastBits},
#include <anysl/MathFunctions.def>
  };
  std::vector<std::string> result;
  for (auto [name, fastBits] : bits)
    if (fastBits < 23 && is_contained(functions, name))
      result.push_back(name.str());
  return result;
}

std::string Mixture::name() const {
  std::string result = tiers()[0].str();
  for (const auto &[function, tier] : tierOf)
    if (tier != tiers()[0])
      result += "," + function + "=" + tier;
  return result;
}

std::vector<Move> greedyOrder(std::vector<Move> moves) {
  auto rank = [](const Move &move) { return find(tiers(), move.tier) - tiers().begin(); };
  std::vector<Move> order;
  std::map<std::string, Move> current; // of each subject, the move made last
  for (;;) {
    const Move *best = nullptr;
    double bestSaved = 0, bestValue = 0;
    for (const Move &move : moves) {
      auto made = current.find(move.subject);
      bool first = made == current.end();
      if (!first && rank(move) <= rank(made->second))
        continue;
      double saved = move.saved - (first ? 0 : made->second.saved);
      double added = move.added - (first ? 0 : made->second.added);
      // What costs no exactness comes before all else.
      double value = added > 0 ? saved / added : HUGE_VAL;
      if (saved > 0 && (!best || value > bestValue || (value == bestValue && saved > bestSaved))) {
        best = &move;
        bestSaved = saved;
        bestValue = value;
      }
    }
    if (!best)
      return order;
    current[best->subject] = *best;
    order.push_back(*best);
  }
}

} // namespace anysl::cost
