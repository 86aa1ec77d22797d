//===-- tools/verify-math/Inputs.h - the arguments that a check goes through ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Numbered arguments: the number alone decides them, so that a run can stop and go on, and a
// failure can be met again.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_VERIFYMATH_INPUTS_H
#define ANYSL_TOOLS_VERIFYMATH_INPUTS_H

#include "tools/verify-math/Truth.h"

namespace anysl::verify {

/// Float number `index` of all 2^32.
float floatAt(uint64_t index);

template <class T>
struct Arguments {
  T x, y;
};

/// Pair number `index` of an endless list: special values, the core range, random bit patterns,
/// wide exponents, exact cases, nearly equal sides, powers near overflow and near 1.
Arguments<float> pairAt(const Function &f, uint64_t index);

/// The same for double; also for functions of one argument.
Arguments<double> doublesAt(const Function &f, uint64_t index);

} // namespace anysl::verify

#endif // ANYSL_TOOLS_VERIFYMATH_INPUTS_H
