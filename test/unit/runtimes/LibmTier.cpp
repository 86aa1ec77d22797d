//===-- test/unit/runtimes/LibmTier.cpp - the C library as a math tier ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The operators are tested against the C library's functions, so that a failure here is theirs and
// not a math tier's.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/math.h>
#include <cmath>

namespace {

double inversesqrt(double x) { return 1 / std::sqrt(x); }
double reciprocal(double x) { return 1 / x; }
double divide(double x, double y) { return x / y; }

} // namespace

using namespace std;

#define MATH_UNARY(name, ...)                                                                      \
  extern "C" float anysl_math_##name##f(float x) { return float(name(double(x))); }                \
  extern "C" double anysl_math_##name(double x) { return name(x); }
#define MATH_BINARY(name, ...)                                                                     \
  extern "C" float anysl_math_##name##f(float x, float y) {                                        \
    return float(name(double(x), double(y)));                                                      \
  }                                                                                                \
  extern "C" double anysl_math_##name(double x, double y) { return name(x, y); }
#include <anysl/MathFunctions.def>

extern "C" int anysl_math_keeps_flags(void) { return 1; }
