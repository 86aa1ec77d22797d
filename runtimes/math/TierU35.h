//===-- runtimes/math/TierU35.h - the tier u35: within 3.5 ULP --------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_TIERU35_H
#define ANYSL_RUNTIMES_MATH_TIERU35_H

#include "runtimes/math/DoubleU10.h"
#include "runtimes/math/InFloat.h"

namespace anysl::tier::u35 {

inline constexpr int keepsFlags = 1;

#define TIER_POLYNOMIALS MediumPolynomials
#include "runtimes/math/TierInFloat.inc"

} // namespace anysl::tier::u35

#endif // ANYSL_RUNTIMES_MATH_TIERU35_H
