//===-- passes/Vectorize/AllActive.h - code for when all lanes are active -----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_ALLACTIVE_H
#define ANYSL_PASSES_VECTORIZE_ALLACTIVE_H

#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/IR/Function.h"

namespace anysl {

/// Gives stretches of a widened function that load and store under a mask a second form without it,
/// which runs when all lanes are active: where the processor has no masked loads and stores, as
/// before AVX, one instruction takes the place of two dozen, and members of records become whole
/// vectors. Where it has them, nothing is gained.
/// Returns whether anything changed.
bool addAllActiveForms(llvm::Function &function, const llvm::TargetTransformInfo &target);

} // namespace anysl

#endif
