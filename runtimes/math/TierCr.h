//===-- runtimes/math/TierCr.h - the tier cr: correctly rounded floats ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_TIERCR_H
#define ANYSL_RUNTIMES_MATH_TIERCR_H

#include "runtimes/math/Correct.h"
#include "runtimes/math/DoubleU10.h"
#include "runtimes/math/InDouble.h"

namespace anysl::tier::cr {

inline constexpr int keepsFlags = 1;

ANYSL_TIER float sin(float x) { return sinInDouble<LongPolynomials>(x); }
ANYSL_TIER float cos(float x) { return cosInDouble<LongPolynomials>(x); }
ANYSL_TIER float tan(float x) { return tanInDouble<LongPolynomials>(x); }
ANYSL_TIER float asin(float x) { return asinCorrect(x); }
ANYSL_TIER float acos(float x) { return acosCorrect(x); }
ANYSL_TIER float atan(float x) { return atanCorrect(x); }
ANYSL_TIER float atan2(float y, float x) { return atan2Correct(y, x); }
ANYSL_TIER float sinh(float x) { return sinhInDouble<LongPolynomials>(x); }
ANYSL_TIER float cosh(float x) { return coshInDouble<LongPolynomials>(x); }
ANYSL_TIER float tanh(float x) { return tanhInDouble<LongPolynomials>(x); }
ANYSL_TIER float exp(float x) { return expInDouble<LongPolynomials>(x); }
ANYSL_TIER float exp2(float x) { return exp2Correct(x); }
ANYSL_TIER float log(float x) { return logCorrect(x); }
ANYSL_TIER float log2(float x) { return log2InDouble<LongPolynomials>(x); }
ANYSL_TIER float log10(float x) { return log10Correct(x); }
ANYSL_TIER float pow(float x, float y) { return powCorrect(x, y); }
ANYSL_TIER float cbrt(float x) { return cbrtInDouble<LongPolynomials>(x); }
ANYSL_TIER float sqrt(float x) { return squareRoot(x); }
ANYSL_TIER float inversesqrt(float x) { return inverseSqrtCorrect(x); }
ANYSL_TIER float reciprocal(float x) { return 1 / x; }
ANYSL_TIER float divide(float x, float y) { return x / y; }
ANYSL_TIER float hypot(float x, float y) { return hypotCorrect(x, y); }

#define MATH_UNARY(name, coreLow, coreHigh, fastBits) using u10double::name;
#define MATH_BINARY(name, coreLowX, coreHighX, coreLowY, coreHighY, fastBits) using u10double::name;
#include <anysl/MathFunctions.def>

} // namespace anysl::tier::cr

#endif // ANYSL_RUNTIMES_MATH_TIERCR_H
