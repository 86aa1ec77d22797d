//===-- runtimes/math/Tier.cpp - one tier as the functions of <anysl/math.h> ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Compiled once for each tier, with ANYSL_TIER_NAME its namespace and ANYSL_TIER_HEADER its header.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/math.h>
#include ANYSL_TIER_HEADER

extern "C" {

#define MATH_UNARY(name, coreLow, coreHigh, fastBits)                                              \
  float anysl_math_##name##f(float x) { return anysl::tier::ANYSL_TIER_NAME::name(x); }            \
  double anysl_math_##name(double x) { return anysl::tier::ANYSL_TIER_NAME::name(x); }
#define MATH_BINARY(name, coreLowX, coreHighX, coreLowY, coreHighY, fastBits)                      \
  float anysl_math_##name##f(float x, float y) {                                                   \
    return anysl::tier::ANYSL_TIER_NAME::name(x, y);                                               \
  }                                                                                                \
  double anysl_math_##name(double x, double y) { return anysl::tier::ANYSL_TIER_NAME::name(x, y); }
#include <anysl/MathFunctions.def>

int anysl_math_keeps_flags(void) { return anysl::tier::ANYSL_TIER_NAME::keepsFlags; }
}
