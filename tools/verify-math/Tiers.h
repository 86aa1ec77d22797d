//===-- tools/verify-math/Tiers.h - the tiers as functions over arrays ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Each tier's code compiled into this program, one translation unit a tier (TierBatch.cpp).
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_VERIFYMATH_TIERS_H
#define ANYSL_TOOLS_VERIFYMATH_TIERS_H

#include <cstddef>
#include <span>
#include <string_view>

namespace anysl::verify {

/// One function of one tier; one-argument functions do not look at y.
struct Batch {
  void (*ofFloats)(const float *x, const float *y, float *result, size_t count);
  void (*ofDoubles)(const double *x, const double *y, double *result, size_t count);
};

/// The functions of a tier in the order of MathFunctions.def.
struct Tier {
  std::string_view name;
  /// The bound on the error in ULP for float and for double. The tier `fast` has 0 for float: its
  /// bound is the table's fastBits.
  double bound, boundForDouble;
  const Batch *batches; ///< without fused multiply-adds in hardware
  const Batch *fused;   ///< with them, for a processor that has AVX2 and FMA
};

std::span<const Tier> tiers();
const Tier *findTier(std::string_view name);

} // namespace anysl::verify

#endif // ANYSL_TOOLS_VERIFYMATH_TIERS_H
