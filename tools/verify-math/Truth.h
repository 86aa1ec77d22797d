//===-- tools/verify-math/Truth.h - what the elementary functions should give -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The true value of a function of floats comes from the C library's double function. Where that
// lies so near the middle between two floats that its own error could decide the rounding, MPFR
// computes the value anew, with more and more bits until the rounding is certain. For functions of
// double the truth is MPFR's always.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_VERIFYMATH_TRUTH_H
#define ANYSL_TOOLS_VERIFYMATH_TRUTH_H

#include <cstdint>
#include <mpfr.h>
#include <span>
#include <string_view>

namespace anysl::verify {

/// The value of a function of floats.
struct Truth {
  double value;  ///< within a few units of 2^-53
  float rounded; ///< the correctly rounded float
};

/// One entry of MathFunctions.def.
struct Function {
  std::string_view name;
  int arguments;
  double low[2], high[2]; ///< core range
  int fastBits;
  double (*approximate)(double x, double y); ///< the C library's
  void (*exact)(mpfr_ptr result, mpfr_srcptr x, mpfr_srcptr y);
};

/// All functions, in the table's order.
std::span<const Function> functions();
/// The function of that name, or null.
const Function *findFunction(std::string_view name);

/// The truth for float arguments (y is ignored by one-argument functions).
Truth truthOf(const Function &f, float x, float y);

/// |got − true value| in units in the last place of a float (of a double) near the true value;
/// where the true value is below the normal range, units of the smallest denormal. An infinite
/// result counts as 2^128 (2^1024), a NaN on one side only and a wrong sign of zero count as
/// infinite.
double errorInUlp(Truth truth, float got);
double errorInUlp(const Function &f, double x, double y, double got);

} // namespace anysl::verify

#endif // ANYSL_TOOLS_VERIFYMATH_TRUTH_H
