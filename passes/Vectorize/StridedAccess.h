//===-- passes/Vectorize/StridedAccess.h - records in memory, lane by lane ----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_STRIDEDACCESS_H
#define ANYSL_PASSES_VECTORIZE_STRIDEDACCESS_H

#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/IR/Function.h"

namespace anysl {

/// Replaces gathers and scatters whose lanes' addresses lie two, three or four elements apart, as
/// the x of an array of points does, by loads and stores of whole vectors and shuffles. Returns
/// whether anything changed.
///
/// A gather of all lanes may stand alone: what lies between two lanes is in the same object, and
/// reading it does no harm. Where some lanes are idle, or scatters are not all members of the
/// record, the vectors are masked, on processors that do so in one instruction.
bool widenStridedAccess(llvm::Function &function, const llvm::TargetTransformInfo &target);

/// The mask of a gather or scatter that could be part of whole vectors if all lanes were active, and
/// otherwise not, for want of masked loads and stores; null for all other instructions.
llvm::Value *maskOfRecords(llvm::Instruction &instruction, const llvm::TargetTransformInfo &target);

} // namespace anysl

#endif
