//===-- benchmarks/math/Contestants.h - who computes elementary functions ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_BENCHMARKS_MATH_CONTESTANTS_H
#define ANYSL_BENCHMARKS_MATH_CONTESTANTS_H

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace anysl::bench {

/// One function over an array, in one way; a multiple of 16 elements.
using Kernel = void (*)(const float *x, const float *y, float *result, size_t count);

struct Contestant {
  std::string name; ///< "u10", "SLEEF u10", …
  int width;        ///< lanes: 1, 8 (AVX2) or 16 (AVX-512)
  Kernel kernel;
};

/// Everyone who has that function and whose instructions this processor has.
std::vector<Contestant> contestantsFor(std::string_view function, size_t index);

} // namespace anysl::bench

#endif // ANYSL_BENCHMARKS_MATH_CONTESTANTS_H
