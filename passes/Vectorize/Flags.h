//===-- passes/Vectorize/Flags.h - floating-point exception flags -------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_FLAGS_H
#define ANYSL_PASSES_VECTORIZE_FLAGS_H

#include "llvm/IR/Function.h"

namespace anysl {

/// Turns all floating-point arithmetic of a function into LLVM's constrained intrinsics, rounding
/// to nearest, as clang does under -ffp-exception-behavior=strict: from here on no pass computes
/// early, twice or not at all what raises a flag. Saturating conversions have no such form.
void mindFlags(llvm::Function &function);

} // namespace anysl

#endif
