//===-- runtimes/math/DoubleU10.h - functions of double within 1 ULP, by name -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_DOUBLEU10_H
#define ANYSL_RUNTIMES_MATH_DOUBLEU10_H

#include "runtimes/math/DoubleExpLog.h"
#include "runtimes/math/DoubleTrig.h"

namespace anysl::tier::u10double {

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

} // namespace anysl::tier::u10double

#endif // ANYSL_RUNTIMES_MATH_DOUBLEU10_H
