//===-- passes/Vectorize/Intrinsics.h - what is known of LLVM's intrinsics ----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_INTRINSICS_H
#define ANYSL_PASSES_VECTORIZE_INTRINSICS_H

#include "llvm/IR/IRBuilder.h"

namespace anysl {

/// Whether an intrinsic on vectors does in each lane what it does on scalars.
bool worksOnLanes(llvm::Intrinsic::ID id);

/// What <math.h> calls the function of double that an intrinsic stands for, and that processors
/// have no instruction for; empty for other intrinsics.
llvm::StringRef mathFunctionOf(llvm::Intrinsic::ID id);

/// Whether an instruction becomes a call of a function in C's library: llvm.sin, frem and the like.
bool callsMathLibrary(const llvm::Instruction &instruction);

/// Calls an intrinsic on these arguments; null if it does not exist for their types.
llvm::CallInst *callIntrinsic(llvm::IRBuilderBase &builder, llvm::Intrinsic::ID id,
                              llvm::Type *result, llvm::ArrayRef<llvm::Value *> arguments);

} // namespace anysl

#endif
