//===-- anysl/math.h - elementary functions, as a math tier defines them ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Declares `float anysl_math_sinf(float)`, `double anysl_math_sin(double)` and so on for every
// function of MathFunctions.def, and for C++ the overloads anysl::math::sin(float), sin(double), ….
// Which definition is linked decides how exact a shader is: lib/anysl/math/<tier>.bc, see
// docs/numerics.md. Special values are C's (Annex F); there is no errno. The functions read no
// memory and no rounding mode: they want round-to-nearest, and no flushing of denormals.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_MATH_H
#define ANYSL_MATH_H

#define ANYSL_MATH_ATTRIBUTES __attribute__((const))

#ifdef __cplusplus
extern "C" {
#endif

#define MATH_UNARY(name, coreLow, coreHigh, fastBits)                                              \
  ANYSL_MATH_ATTRIBUTES float anysl_math_##name##f(float x);                                       \
  ANYSL_MATH_ATTRIBUTES double anysl_math_##name(double x);
#define MATH_BINARY(name, coreLowX, coreHighX, coreLowY, coreHighY, fastBits)                      \
  ANYSL_MATH_ATTRIBUTES float anysl_math_##name##f(float x, float y);                              \
  ANYSL_MATH_ATTRIBUTES double anysl_math_##name(double x, double y);
#include <anysl/MathFunctions.def>

/* Whether operators take care that no finite operand raises the flag of an invalid operation or of a
   division by zero. It costs instructions, and a tier may do without (docs/numerics.md). */
ANYSL_MATH_ATTRIBUTES int anysl_math_keeps_flags(void);

#ifdef __cplusplus
}

namespace anysl::math {

#define MATH_UNARY(name, coreLow, coreHigh, fastBits)                                              \
  inline float name(float x) { return anysl_math_##name##f(x); }                                   \
  inline double name(double x) { return anysl_math_##name(x); }
#define MATH_BINARY(name, coreLowX, coreHighX, coreLowY, coreHighY, fastBits)                      \
  inline float name(float x, float y) { return anysl_math_##name##f(x, y); }                       \
  inline double name(double x, double y) { return anysl_math_##name(x, y); }
#include <anysl/MathFunctions.def>

inline bool keepsFlags() { return anysl_math_keeps_flags() != 0; }

} // namespace anysl::math
#endif

#endif // ANYSL_MATH_H
