//===-- test/unit/math/ReproducibilityTests.cpp - the same bits on every instruction set ------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Each tier compiled without vectors, and 4, 8 and 16 wide for SSE4, AVX2 and AVX-512, over the
// same arguments. NaNs are compared as NaNs: which payload an operation hands on is the processor's
// choice.
//
//===------------------------------------------------------------------------------------------===//

#include "tools/verify-math/Inputs.h"
#include "tools/verify-math/Tiers.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <vector>

namespace anysl::verify {
#define MATH_TIER(name, bound, boundForDouble)                                                     \
  extern const Batch name##_scalar[], name##_sse4[], name##_avx2[], name##_avx512[];
#include "runtimes/math/Tiers.def"
} // namespace anysl::verify

using namespace anysl::verify;

namespace {

struct Compiled {
  const char *tier, *set;
  const Batch *reference, *batches;
  bool supported;
};

template <class T, class Arguments, class Call>
void compare(const Compiled &c, Arguments argumentsOf, Call call) {
  constexpr size_t count = 40000 + 7;
  std::vector<T> x(count), y(count), wanted(count), got(count);
  for (size_t f = 0; f < functions().size(); ++f) {
    for (size_t i = 0; i < count; ++i) {
      auto a = argumentsOf(functions()[f], i);
      x[i] = a.x;
      y[i] = a.y;
    }
    call(c.reference[f])(x.data(), y.data(), wanted.data(), count);
    call(c.batches[f])(x.data(), y.data(), got.data(), count);
    size_t different = 0, where = 0;
    for (size_t i = 0; i < count; ++i)
      if (std::memcmp(&wanted[i], &got[i], sizeof(T)) != 0 &&
          !(std::isnan(wanted[i]) && std::isnan(got[i]))) {
        ++different;
        where = i;
      }
    INFO(c.tier << ' ' << functions()[f].name << ' ' << c.set << ": at " << x[where] << ", "
                << y[where] << " scalar " << wanted[where] << ", wide " << got[where]);
    CHECK(different == 0);
  }
}

void compareSet(const char *set) {
  const Compiled all[] = {
#define MATH_TIER(name, bound, boundForDouble)                                                     \
  {#name, "sse4", name##_scalar, name##_sse4, bool(__builtin_cpu_supports("sse4.2"))},             \
      {#name, "avx2", name##_scalar, name##_avx2, bool(__builtin_cpu_supports("avx2"))},           \
      {#name, "avx512", name##_scalar, name##_avx512, bool(__builtin_cpu_supports("avx512vl"))},
#include "runtimes/math/Tiers.def"
  };
  for (const Compiled &c : all)
    if (std::strcmp(c.set, set) == 0) {
      if (!c.supported) {
        WARN("skipped: this processor has no " << set);
        return;
      }
      compare<float>(c, pairAt, [](const Batch &b) { return b.ofFloats; });
      compare<double>(c, doublesAt, [](const Batch &b) { return b.ofDoubles; });
    }
}

} // namespace

TEST_CASE("SSE4 code gives the scalar code's bits") { compareSet("sse4"); }
TEST_CASE("AVX2 code gives the scalar code's bits") { compareSet("avx2"); }
TEST_CASE("AVX-512 code gives the scalar code's bits") { compareSet("avx512"); }
