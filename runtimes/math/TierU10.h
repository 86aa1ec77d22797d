//===-- runtimes/math/TierU10.h - the tier u10: within 1 ULP ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_TIERU10_H
#define ANYSL_RUNTIMES_MATH_TIERU10_H

#include "runtimes/math/Compensated.h"
#include "runtimes/math/DoubleU10.h"
#include "runtimes/math/InDouble.h"

namespace anysl::tier::u10 {

inline constexpr int keepsFlags = 1;

ANYSL_TIER float sin(float x) { return sinInDouble<ShortPolynomials>(x); }
ANYSL_TIER float cos(float x) { return cosInDouble<ShortPolynomials>(x); }
ANYSL_TIER float tan(float x) { return tanInDouble<ShortPolynomials>(x); }
ANYSL_TIER float asin(float x) { return asinInFloatOnly(x); }
ANYSL_TIER float acos(float x) { return acosInFloatOnly(x); }
ANYSL_TIER float atan(float x) { return atanInFloatOnly(x); }
ANYSL_TIER float atan2(float y, float x) { return atan2InFloatOnly(y, x); }
ANYSL_TIER float sinh(float x) { return sinhInDouble<ShortPolynomials>(x); }
ANYSL_TIER float cosh(float x) { return coshInDouble<ShortPolynomials>(x); }
ANYSL_TIER float tanh(float x) { return tanhInDouble<ShortPolynomials>(x); }
ANYSL_TIER float exp(float x) { return expInFloatOnly(x); }
ANYSL_TIER float exp2(float x) { return exp2InFloatOnly(x); }
ANYSL_TIER float log(float x) { return logInFloatOnly(x); }
ANYSL_TIER float log2(float x) { return logScaled(x, Base2()); }
ANYSL_TIER float log10(float x) { return logScaled(x, Base10()); }
ANYSL_TIER float pow(float x, float y) { return powInDouble<ShortPower>(x, y); }
ANYSL_TIER float cbrt(float x) { return cbrtInDouble<ShortPolynomials>(x); }
ANYSL_TIER float sqrt(float x) { return squareRoot(x); }
ANYSL_TIER float inversesqrt(float x) { return inverseSqrtInDouble(x); }
ANYSL_TIER float reciprocal(float x) { return 1 / x; }
ANYSL_TIER float divide(float x, float y) { return x / y; }
ANYSL_TIER float hypot(float x, float y) { return hypotInDouble(x, y); }

#define MATH_UNARY(name, coreLow, coreHigh, fastBits) using u10double::name;
#define MATH_BINARY(name, coreLowX, coreHighX, coreLowY, coreHighY, fastBits) using u10double::name;
#include <anysl/MathFunctions.def>

} // namespace anysl::tier::u10

#endif // ANYSL_RUNTIMES_MATH_TIERU10_H
