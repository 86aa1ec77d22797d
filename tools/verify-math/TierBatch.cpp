//===-- tools/verify-math/TierBatch.cpp - one tier over arrays --------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Compiled once for each tier, with ANYSL_TIER_NAME its namespace, ANYSL_TIER_HEADER its header and
// ANYSL_TIER_BATCHES the name of the table to define.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/verify-math/Tiers.h"

#include ANYSL_TIER_HEADER

namespace anysl::verify {

namespace math = anysl::tier::ANYSL_TIER_NAME;

namespace {

template <auto F, class T>
void unary(const T *x, const T *, T *result, size_t count) {
  for (size_t i = 0; i < count; ++i)
    result[i] = F(x[i]);
}
template <auto F, class T>
void binary(const T *x, const T *y, T *result, size_t count) {
  for (size_t i = 0; i < count; ++i)
    result[i] = F(x[i], y[i]);
}

} // namespace

extern const Batch ANYSL_TIER_BATCHES[];
const Batch ANYSL_TIER_BATCHES[] = {
#define MATH_UNARY(name, low, high, bits)                                                          \
  {unary<static_cast<float (*)(float)>(math::name), float>,                                        \
   unary<static_cast<double (*)(double)>(math::name), double>},
#define MATH_BINARY(name, lowX, highX, lowY, highY, bits)                                          \
  {binary<static_cast<float (*)(float, float)>(math::name), float>,                                \
   binary<static_cast<double (*)(double, double)>(math::name), double>},
#include <anysl/MathFunctions.def>
};

} // namespace anysl::verify
