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

/// The mask, known only when it runs, of a load or store of consecutive memory that the processor
/// does lane by lane; null for all other instructions.
llvm::Value *maskDoneLaneByLane(const llvm::Instruction &instruction,
                                const llvm::TargetTransformInfo &target);

/// Takes the masks off loads, stores, gathers and scatters that the processor does lane by lane:
/// idle lanes access a place of their own on the stack instead. LLVM would test each lane's bit of
/// the mask and jump. Returns whether anything changed.
bool unmaskAccesses(llvm::Function &function, const llvm::TargetTransformInfo &target);

} // namespace anysl

#endif
