//===-- tools/verify-math/Tiers.cpp -----------------------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/verify-math/Tiers.h"

namespace anysl::verify {

#define MATH_TIER(name, bound, boundForDouble) extern const Batch name##Batches[], name##Fused[];
#include "runtimes/math/Tiers.def"

static constexpr Tier Table[] = {
#define MATH_TIER(name, bound, boundForDouble)                                                     \
  {#name, bound, boundForDouble, name##Batches, name##Fused},
#include "runtimes/math/Tiers.def"
};

std::span<const Tier> tiers() { return Table; }

const Tier *findTier(std::string_view name) {
  for (const Tier &t : Table)
    if (t.name == name)
      return &t;
  return nullptr;
}

} // namespace anysl::verify
