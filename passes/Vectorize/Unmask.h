//===-- passes/Vectorize/Unmask.h - gathers where processors have none --------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_UNMASK_H
#define ANYSL_PASSES_VECTORIZE_UNMASK_H

#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/IR/Function.h"

namespace anysl {

/// Takes the masks off gathers and scatters that the processor does lane by lane: idle lanes access
/// a place of their own on the stack instead. LLVM would test each lane's bit of the mask and jump.
/// Returns whether anything changed.
bool unmaskGathers(llvm::Function &function, const llvm::TargetTransformInfo &target);

} // namespace anysl

#endif
