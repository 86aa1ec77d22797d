//===-- lib/Link/Needs.h - what is needed for what -----------------------------------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_NEEDS_H
#define ANYSL_LIB_LINK_NEEDS_H

#include "lib/STC/Ops.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/SmallPtrSet.h"
#include "llvm/Analysis/PostDominators.h"
#include "llvm/IR/Instructions.h"

namespace anysl::link {

/// The operator that an instruction calls; null: none.
const stc::OpInfo *opOf(const llvm::Instruction &instruction);
/// The number that a call of an operator names: of a global, a parameter, a cell ...
uint64_t idOf(const llvm::CallInst &call, const stc::OpInfo &op);

/// Tells, for one function of threaded code, which instructions others need: what computes their
/// operands, and the branches that decide whether they run. Loops are taken to end.
class Needs {
public:
  using Instructions = llvm::SmallPtrSet<const llvm::Instruction *, 32>;

  explicit Needs(llvm::Function &body);

  /// All that some instructions need. A point's random numbers come one after the other, and so do
  /// its rays: those before one that is needed are needed as well. `sequenceGoesOn`: others go on
  /// with the numbers, and all are.
  Instructions of(llvm::function_ref<bool(const llvm::Instruction &)> isRoot,
                  bool sequenceGoesOn) const;

  /// Where the ways of a branch meet again whatever it decides; null: nowhere.
  llvm::BasicBlock *meeting(const llvm::BranchInst &branch) const;

private:
  llvm::Function &body;
  llvm::PostDominatorTree after;
  llvm::DenseMap<const llvm::BasicBlock *, llvm::SmallVector<const llvm::BranchInst *, 2>> deciders;
};

} // namespace anysl::link

#endif
