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

ANYSL_TIER float sin(float x) { return sinInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float cos(float x) { return cosInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float tan(float x) { return tanInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float asin(float x) { return asinInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float acos(float x) { return acosInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float atan(float x) { return atanInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float atan2(float y, float x) { return atan2InFloat<CoarsePolynomials>(y, x); }
ANYSL_TIER float sinh(float x) { return sinhInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float cosh(float x) { return coshInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float tanh(float x) { return tanhInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float exp(float x) { return expInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float exp2(float x) { return exp2InFloat<CoarsePolynomials>(x); }
ANYSL_TIER float log(float x) { return logInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float log2(float x) { return log2InFloat<CoarsePolynomials>(x); }
ANYSL_TIER float log10(float x) { return log10InFloat<CoarsePolynomials>(x); }
ANYSL_TIER float pow(float x, float y) { return powInFloat<CoarsePolynomials>(x, y); }
ANYSL_TIER float cbrt(float x) { return cbrtInFloat<CoarsePolynomials>(x); }
ANYSL_TIER float sqrt(float x) { return squareRoot(x); }
ANYSL_TIER float inversesqrt(float x) { return inverseSqrtInFloat(x); }
ANYSL_TIER float reciprocal(float x) { return 1 / x; }
ANYSL_TIER float divide(float x, float y) { return x / y; }
ANYSL_TIER float hypot(float x, float y) { return hypotInFloat(x, y); }

#define MATH_UNARY(name, coreLow, coreHigh, fastBits) using u10double::name;
#define MATH_BINARY(name, coreLowX, coreHighX, coreLowY, coreHighY, fastBits) using u10double::name;
#include <anysl/MathFunctions.def>

} // namespace anysl::tier::fast

#endif // ANYSL_RUNTIMES_MATH_TIERFAST_H
