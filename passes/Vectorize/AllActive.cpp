//===-- passes/Vectorize/AllActive.cpp - code for when all lanes are active -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A stretch is the part of a block from the first to the last instruction that looks at one mask.
// It is copied; in the copy the mask is a constant, and a test of the mask chooses between the two.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/AllActive.h"

#include "passes/Vectorize/StridedAccess.h"
#include "passes/Vectorize/Unmask.h"

#include "llvm/ADT/MapVector.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/Transforms/Utils/BasicBlockUtils.h"
#include "llvm/Transforms/Utils/Cloning.h"
#include "llvm/Transforms/Utils/ValueMapper.h"

using namespace llvm;

namespace anysl {

namespace {
struct Stretch {
  Instruction *first = nullptr, *last = nullptr;
};
} // namespace

/// What the copies of a stretch hold for the instructions after it.
static void joinValues(BasicBlock *masked, BasicBlock *full, BasicBlock *tail,
                       const ValueToValueMapTy &copies) {
  IRBuilder<> builder(tail, tail->begin());
  for (Instruction &instruction : *masked) {
    SmallVector<Use *, 8> outside;
    for (Use &use : instruction.uses())
      if (cast<Instruction>(use.getUser())->getParent() != masked)
        outside.push_back(&use);
    if (outside.empty())
      continue;
    PHINode *joined = builder.CreatePHI(instruction.getType(), 2, instruction.getName());
    joined->addIncoming(&instruction, masked);
    joined->addIncoming(copies.lookup(&instruction), full);
    for (Use *use : outside)
      use->set(joined);
  }
}

static void addForm(Value *mask, const Stretch &stretch) {
  BasicBlock *head = stretch.first->getParent();
  BasicBlock *masked = SplitBlock(head, stretch.first);
  BasicBlock *tail = SplitBlock(masked, stretch.last->getNextNode());
  masked->setName("some");
  tail->setName("joined");
  ValueToValueMapTy copies;
  BasicBlock *full = CloneBasicBlock(masked, copies, "", head->getParent());
  full->setName("all");
  full->moveBefore(masked);
  remapInstructionsInBlocks({full}, copies);
  mask->replaceUsesWithIf(Constant::getAllOnesValue(mask->getType()), [&](Use &use) {
    return cast<Instruction>(use.getUser())->getParent() == full;
  });

  Instruction *jump = head->getTerminator();
  IRBuilder<> builder(jump);
  unsigned lanes = cast<FixedVectorType>(mask->getType())->getNumElements();
  Value *bits = builder.CreateBitCast(mask, builder.getIntNTy(lanes));
  Value *areAll = builder.CreateICmpEQ(bits, Constant::getAllOnesValue(bits->getType()));
  builder.CreateCondBr(areAll, full, masked);
  jump->eraseFromParent();
  joinValues(masked, full, tail, copies);
}

bool addAllActiveForms(Function &function, const TargetTransformInfo &target) {
  constexpr unsigned longest = 200; // instructions; a copy of more makes code too large
  SmallVector<BasicBlock *, 16> blocks;
  for (BasicBlock &block : function)
    blocks.push_back(&block);
  bool changed = false;
  for (BasicBlock *block : blocks) {
    // Of the masks of a block the first will do: others' stretches may overlap with its.
    Value *mask = nullptr;
    Stretch stretch;
    unsigned length = 0, end = 0;
    for (Instruction &instruction : *block) {
      Value *own = maskDoneLaneByLane(instruction, target);
      if (!own)
        own = maskOfRecords(instruction, target);
      if (own && !mask) {
        mask = own;
        stretch.first = &instruction;
      }
      if (!mask)
        continue;
      ++length;
      const auto *blend = dyn_cast<SelectInst>(&instruction);
      if (own == mask || (blend && blend->getCondition() == mask)) {
        stretch.last = &instruction;
        end = length;
      }
    }
    if (!mask || end > longest)
      continue;
    addForm(mask, stretch);
    changed = true;
  }
  return changed;
}

} // namespace anysl
