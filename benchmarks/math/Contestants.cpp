//===-- benchmarks/math/Contestants.cpp -------------------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "benchmarks/math/Contestants.h"

#include "benchmarks/math/Peers.h"
#include "tools/verify-math/Tiers.h"

#include <cmath>

namespace anysl::verify {
#define MATH_TIER(name, bound, boundForDouble) extern const Batch name##_scalar[];
#include "runtimes/math/Tiers.def"
} // namespace anysl::verify

namespace anysl::bench {

#define MATH_TIER(name, bound, boundForDouble)                                                     \
  extern const Kernel name##Widened8[], name##Widened16[];
#include "runtimes/math/Tiers.def"

namespace {

struct Scalar {
  const char *function;
  Kernel kernel;
};

#define C1(name)                                                                                   \
  {#name, [](const float *x, const float *, float *r, size_t n) {                                  \
     for (size_t i = 0; i < n; ++i)                                                                \
       r[i] = std::name(x[i]);                                                                     \
   }}
#define C2(name)                                                                                   \
  {#name, [](const float *x, const float *y, float *r, size_t n) {                                 \
     for (size_t i = 0; i < n; ++i)                                                                \
       r[i] = std::name(x[i], y[i]);                                                               \
   }}
const Scalar glibc[] = {C1(sin),  C1(cos),  C1(tan), C1(asin),  C1(acos), C1(atan), C1(sinh),
                        C1(cosh), C1(tanh), C1(exp), C1(exp2),  C1(log),  C1(log2), C1(log10),
                        C1(cbrt), C1(sqrt), C2(pow), C2(atan2), C2(hypot)};

} // namespace

std::vector<Contestant> contestantsFor(std::string_view function, size_t index) {
  bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq");
  std::vector<Contestant> result;
#define MATH_TIER(name, bound, boundForDouble)                                                     \
  result.push_back({#name, 1, verify::name##_scalar[index].ofFloats});                             \
  if (avx2)                                                                                        \
    result.push_back({#name, 8, name##Widened8[index]});                                           \
  if (avx512)                                                                                      \
    result.push_back({#name, 16, name##Widened16[index]});
#include "runtimes/math/Tiers.def"
  for (const Scalar &s : glibc)
    if (function == s.function)
      result.push_back({"glibc", 1, s.kernel});
  for (bool wide : {false, true})
    if (wide ? avx512 : avx2)
      for (const Peer &p : wide ? peers16() : peers8())
        if (function == p.function)
          result.push_back({p.library, wide ? 16 : 8, p.kernel});
  return result;
}

} // namespace anysl::bench
