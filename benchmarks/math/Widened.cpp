//===-- benchmarks/math/Widened.cpp - one tier, for anysl-vectorize to widen ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Compiled to LLVM IR for each tier and width, with ANYSL_TIER_NAME, ANYSL_TIER_HEADER, ANYSL_WIDTH
// and ANYSL_ISA (d for AVX2, e for AVX-512); anysl-vectorize then defines the functions that the
// loops call.
//
//===------------------------------------------------------------------------------------------===//

#include "benchmarks/math/Contestants.h"

#include ANYSL_TIER_HEADER

#define JOIN2(a, b) a##b
#define JOIN(a, b) JOIN2(a, b)
#define TEXT2(x) #x
#define TEXT(x) TEXT2(x)

// bench_u10_sin, bench_u10_sin_loop and the vector variant, whose name is the vector function ABI's
#define POINT(name) JOIN(JOIN(bench_, ANYSL_TIER_NAME), JOIN(ANYSL_WIDTH, _##name))
#define LOOP(name) JOIN(POINT(name), _loop)
#define VARIANT(name)                                                                              \
  JOIN(JOIN(JOIN(_ZGV, ANYSL_ISA), JOIN(N, ANYSL_WIDTH)), JOIN(uuul_, POINT(name)))
#define ARGUMENTS const float *__restrict x, const float *__restrict y, float *__restrict r

#define KERNEL(name, call)                                                                         \
  _Pragma(TEXT(omp declare simd simdlen(ANYSL_WIDTH) notinbranch uniform(x, y, r) linear(i))) void \
  POINT(name)(ARGUMENTS, int i) {                                                                  \
    r[i] = anysl::tier::ANYSL_TIER_NAME::call;                                                     \
  }                                                                                                \
  void VARIANT(name)(ARGUMENTS, int i);                                                            \
  static void LOOP(name)(const float *x, const float *y, float *r, size_t count) {                 \
    for (size_t i = 0; i < count; i += ANYSL_WIDTH)                                                \
      VARIANT(name)(x, y, r, int(i));                                                              \
  }

extern "C" {
#define MATH_UNARY(name, low, high, bits) KERNEL(name, name(x[i]))
#define MATH_BINARY(name, lowX, highX, lowY, highY, bits) KERNEL(name, name(x[i], y[i]))
#include <anysl/MathFunctions.def>
}

namespace anysl::bench {

#define TABLE JOIN(ANYSL_TIER_NAME, JOIN(Widened, ANYSL_WIDTH))
extern const Kernel TABLE[];
const Kernel TABLE[] = {
#define MATH_UNARY(name, low, high, bits) LOOP(name),
#define MATH_BINARY(name, lowX, highX, lowY, highY, bits) LOOP(name),
#include <anysl/MathFunctions.def>
};

} // namespace anysl::bench
