//===-- runtimes/math/TierCr.h - the tier cr: correctly rounded floats
//---------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_TIERCR_H
#define ANYSL_RUNTIMES_MATH_TIERCR_H

#include "runtimes/math/Correct.h"
#include "runtimes/math/DoubleExpLog.h"
#include "runtimes/math/DoubleTrig.h"
#include "runtimes/math/InDouble.h"

namespace anysl::tier::cr {

ANYSL_TIER float sin(float x) { return sinInDouble<LongPolynomials>(x); }
ANYSL_TIER float cos(float x) { return cosInDouble<LongPolynomials>(x); }
ANYSL_TIER float tan(float x) { return tanInDouble<LongPolynomials>(x); }
ANYSL_TIER float asin(float x) { return asinInDouble<LongPolynomials>(x); }
ANYSL_TIER float acos(float x) { return acosInDouble<LongPolynomials>(x); }
ANYSL_TIER float atan(float x) { return atanInDouble<LongPolynomials>(x); }
ANYSL_TIER float atan2(float y, float x) { return atan2InDouble<LongPolynomials>(y, x); }
ANYSL_TIER float sinh(float x) { return sinhInDouble<LongPolynomials>(x); }
ANYSL_TIER float cosh(float x) { return coshInDouble<LongPolynomials>(x); }
ANYSL_TIER float tanh(float x) { return tanhInDouble<LongPolynomials>(x); }
ANYSL_TIER float exp(float x) { return expInDouble<LongPolynomials>(x); }
ANYSL_TIER float exp2(float x) { return exp2InDouble<LongPolynomials>(x); }
ANYSL_TIER float log(float x) { return logInDouble<LongPolynomials>(x); }
ANYSL_TIER float log2(float x) { return log2InDouble<LongPolynomials>(x); }
ANYSL_TIER float log10(float x) { return log10InDouble<LongPolynomials>(x); }
ANYSL_TIER float pow(float x, float y) { return powCorrect(x, y); }
ANYSL_TIER float cbrt(float x) { return cbrtInDouble<LongPolynomials>(x); }
ANYSL_TIER float sqrt(float x) { return squareRoot(x); }
ANYSL_TIER float inversesqrt(float x) { return inverseSqrtInDouble(x); }
ANYSL_TIER float reciprocal(float x) { return 1 / x; }
ANYSL_TIER float divide(float x, float y) { return x / y; }
ANYSL_TIER float hypot(float x, float y) { return hypotCorrect(x, y); }

ANYSL_TIER double sin(double x) { return sinOf(x); }
ANYSL_TIER double cos(double x) { return cosOf(x); }
ANYSL_TIER double tan(double x) { return tanOf(x); }
ANYSL_TIER double asin(double x) { return asinOf(x); }
ANYSL_TIER double acos(double x) { return acosOf(x); }
ANYSL_TIER double atan(double x) { return atanOf(x); }
ANYSL_TIER double atan2(double y, double x) { return atan2Of(y, x); }
ANYSL_TIER double sinh(double x) { return sinhOf(x); }
ANYSL_TIER double cosh(double x) { return coshOf(x); }
ANYSL_TIER double tanh(double x) { return tanhOf(x); }
ANYSL_TIER double exp(double x) { return expOf(x); }
ANYSL_TIER double exp2(double x) { return exp2Of(x); }
ANYSL_TIER double log(double x) { return logOf(x); }
ANYSL_TIER double log2(double x) { return log2Of(x); }
ANYSL_TIER double log10(double x) { return log10Of(x); }
ANYSL_TIER double pow(double x, double y) { return powOf(x, y); }
ANYSL_TIER double cbrt(double x) { return cbrtOf(x); }
ANYSL_TIER double sqrt(double x) { return squareRoot(x); }
ANYSL_TIER double inversesqrt(double x) { return inverseSqrtOf(x); }
ANYSL_TIER double reciprocal(double x) { return 1 / x; }
ANYSL_TIER double divide(double x, double y) { return x / y; }
ANYSL_TIER double hypot(double x, double y) { return hypotOf(x, y); }

} // namespace anysl::tier::cr

#endif // ANYSL_RUNTIMES_MATH_TIERCR_H
