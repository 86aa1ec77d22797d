//===-- runtimes/math/TierFast.h - the tier fast: to about 12 bits ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_TIERFAST_H
#define ANYSL_RUNTIMES_MATH_TIERFAST_H

#include "runtimes/math/DoubleU10.h"
#include "runtimes/math/InFloat.h"

namespace anysl::tier::fast {

inline constexpr int keepsFlags = 0;

#define TIER_POLYNOMIALS CoarsePolynomials
#include "runtimes/math/TierInFloat.inc"

} // namespace anysl::tier::fast

#endif // ANYSL_RUNTIMES_MATH_TIERFAST_H
