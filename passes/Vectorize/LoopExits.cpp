//===-- passes/Vectorize/LoopExits.cpp - exits of a loop that may be one ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A loop that was unrolled before it is widened has as many exits as it has copies of its body,
// each of which adds another number to the loop's counter, and all lead to the same place.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/LoopExits.h"

#include "llvm/ADT/MapVector.h"
#include "llvm/Analysis/LoopInfo.h"
#include "llvm/Analysis/ValueTracking.h"
#include "llvm/IR/CFG.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/Transforms/Utils/BasicBlockUtils.h"

using namespace llvm;

namespace anysl {

static bool isCheap(const Instruction &instruction) {
  switch (instruction.getOpcode()) {
  case Instruction::FDiv:
  case Instruction::FRem:
  case Instruction::UDiv:
  case Instruction::SDiv:
  case Instruction::URem:
  case Instruction::SRem:
    return false;
  default:
    return (isa<BinaryOperator>(instruction) || isa<CastInst>(instruction) ||
            isa<SelectInst>(instruction) || isa<GetElementPtrInst>(instruction) ||
            isa<CmpInst>(instruction) || isa<UnaryOperator>(instruction)) &&
           isSafeToSpeculativelyExecute(&instruction);
  }
}

/// Where the exit block \p exit of \p loop leads if all it does may as well be done before: no more
/// operations than there are values that a separate exit would have to keep.
static BasicBlock *endOf(BasicBlock *exit, const Loop &loop, const LoopInfo &loops) {
  BasicBlock *exiting = exit->getSinglePredecessor(), *end = exit->getSingleSuccessor();
  if (!exiting || !end || !isa<BranchInst>(exiting->getTerminator()) || loop.contains(end) ||
      loops.isLoopHeader(end) || is_contained(successors(exiting), end))
    return nullptr;
  SmallPtrSet<const Value *, 4> kept;
  for (const PHINode &phi : end->phis())
    if (!isa<Constant>(phi.getIncomingValueForBlock(exit)))
      kept.insert(phi.getIncomingValueForBlock(exit));
  unsigned operations = 0;
  for (const Instruction &instruction : *exit) {
    if (isa<PHINode>(instruction) || isa<DbgInfoIntrinsic>(instruction) ||
        instruction.isTerminator())
      continue;
    if (!isCheap(instruction) || ++operations > kept.size())
      return nullptr;
  }
  return end;
}

/// Moves what an exit block does to the end of the block before it, which then leads to the exit's
/// successor.
static void dissolve(BasicBlock *exit) {
  BasicBlock *exiting = exit->getSinglePredecessor(), *end = exit->getSingleSuccessor();
  FoldSingleEntryPHINodes(exit);
  Instruction *terminator = exiting->getTerminator();
  for (Instruction &instruction : make_early_inc_range(*exit)) {
    if (instruction.isTerminator())
      break;
    if (isa<DbgInfoIntrinsic>(instruction))
      instruction.eraseFromParent();
    else
      instruction.moveBefore(terminator);
  }
  end->replacePhiUsesWith(exit, exiting);
  terminator->replaceSuccessorWith(exit, end);
  exit->getTerminator()->eraseFromParent();
  exit->eraseFromParent();
}

bool mergeLoopExits(Function &function) {
  DominatorTree dominators(function);
  LoopInfo loops(dominators);
  bool changed = false;
  for (Loop *loop : loops.getLoopsInPreorder()) {
    SmallVector<BasicBlock *, 8> exits;
    loop->getUniqueExitBlocks(exits);
    MapVector<BasicBlock *, SmallVector<BasicBlock *, 4>> meeting;
    for (BasicBlock *exit : exits)
      if (BasicBlock *end = endOf(exit, *loop, loops))
        meeting[end].push_back(exit);
    for (auto &[end, parts] : meeting) {
      bool isDirect = any_of(predecessors(end), [&](BasicBlock *b) { return loop->contains(b); });
      if (parts.size() + isDirect < 2)
        continue;
      for (BasicBlock *exit : parts) {
        // Two sides of one branch that meet at once are no exits any more.
        if (is_contained(successors(exit->getSinglePredecessor()), end))
          continue;
        loops.removeBlock(exit);
        dissolve(exit);
        changed = true;
      }
    }
  }
  return changed;
}

} // namespace anysl
