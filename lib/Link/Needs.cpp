//===-- lib/Link/Needs.cpp - what is needed for what --------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Needs.h"

#include "llvm/IR/CFG.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/InstIterator.h"

using namespace llvm;

namespace anysl::link {

using stc::Op;
using stc::ParamKind;

const stc::OpInfo *opOf(const Instruction &instruction) {
  auto *call = dyn_cast<CallInst>(&instruction);
  const Function *callee = call ? call->getCalledFunction() : nullptr;
  return callee ? stc::opOfSymbol(callee->getName()) : nullptr;
}

uint64_t idOf(const CallInst &call, const stc::OpInfo &op) {
  for (auto [param, operand] : zip_equal(op.params, call.args()))
    if (param.kind == ParamKind::Id)
      return cast<ConstantInt>(operand)->getZExtValue();
  return ~uint64_t(0);
}

namespace {

/// What a pointer is an element of.
const Value *slotOf(const Value *value) {
  while (auto *call = dyn_cast<CallInst>(value)) {
    const stc::OpInfo *op = opOf(*call);
    if (!op || op->op != Op::element)
      break;
    value = call->getArgOperand(0);
  }
  return value;
}

/// What of a point is numbered: random numbers, and rays.
enum : unsigned { Numbers, Rays, SequenceCount };

/// The sequences that an instruction has members of, as bits.
unsigned sequencesOf(const Instruction &instruction) {
  const stc::OpInfo *op = opOf(instruction);
  if (!op)
    return isa<CallInst>(instruction) ? 1 << Numbers | 1 << Rays : 0;
  bool isStateful = op->purity == stc::Purity::Stateful;
  bool hasRays = stc::tracesSurfaces(op->effect) || op->effect == stc::Effect::Indirect ||
                 (isStateful && op->effect != stc::Effect::Random);
  return unsigned(isStateful) << Numbers | unsigned(hasRays) << Rays;
}

/// Of one of these, which members are needed for the number that others have.
class Sequence {
public:
  /// A member is needed, and all that may come before it.
  void needUpTo(const Instruction &member) {
    const BasicBlock *block = member.getParent();
    const Instruction *&its = last[block];
    if (!its || its->comesBefore(&member))
      its = &member;
    SmallVector<const BasicBlock *> blocks(predecessors(block));
    while (!blocks.empty()) {
      const BasicBlock *next = blocks.pop_back_val();
      if (before.insert(next).second)
        append_range(blocks, predecessors(next));
    }
  }

  bool needs(const Instruction &member) const {
    const Instruction *its = last.lookup(member.getParent());
    return before.contains(member.getParent()) || (its && member.comesBefore(its));
  }

private:
  DenseMap<const BasicBlock *, const Instruction *> last; ///< of each block, itself needed
  SmallPtrSet<const BasicBlock *, 16> before;             ///< whole blocks
};

/// One question: grows from the roots until nothing is missing.
class Search {
public:
  Search(Function &body, function_ref<ArrayRef<const BranchInst *>(const BasicBlock *)> deciders,
         bool sequenceGoesOn)
      : body(body), deciders(deciders), sequenceGoesOn(sequenceGoesOn) {}

  Needs::Instructions run(function_ref<bool(const Instruction &)> isRoot) {
    SmallVector<const CallInst *> calls;
    for (const Instruction &instruction : instructions(body)) {
      const stc::OpInfo *op = opOf(instruction);
      if (auto *call = dyn_cast<CallInst>(&instruction);
          call && !(op && op->purity == stc::Purity::Structural))
        calls.push_back(call);
      // What leads on whatever happens costs nothing.
      auto *branch = dyn_cast<BranchInst>(&instruction);
      if ((branch && branch->isUnconditional()) || isRoot(instruction))
        enliven(&instruction);
    }
    for (bool changed = true; changed;) {
      while (!worklist.empty())
        visit(*worklist.pop_back_val());
      changed = false;
      for (const CallInst *call : calls)
        if (!live.contains(call) && isUsed(*call)) {
          enliven(call);
          changed = true;
        }
    }
    return std::move(live);
  }

private:
  void enliven(const Instruction *instruction) {
    if (live.insert(instruction).second)
      worklist.push_back(instruction);
  }

  void visit(const Instruction &instruction) {
    auto *branch = dyn_cast<BranchInst>(&instruction);
    if (!branch || branch->isConditional())
      enlivenDeciders(instruction.getParent());
    // A phi's value is which way led here.
    if (auto *phi = dyn_cast<PHINode>(&instruction))
      for (const BasicBlock *block : phi->blocks()) {
        enliven(block->getTerminator());
        enlivenDeciders(block);
      }
    for (unsigned sequence = 0; sequence < SequenceCount; ++sequence)
      if (sequencesOf(instruction) >> sequence & 1)
        sequences[sequence].needUpTo(instruction);
    auto *call = dyn_cast<CallInst>(&instruction);
    const stc::OpInfo *op = opOf(instruction);
    for (auto [i, operand] : enumerate(instruction.operands())) {
      bool isSlot = call && i < call->arg_size() && operand->getType()->isPointerTy();
      if (isSlot && (!op || (op->params[i].isValue() && op->params[i].kind != ParamKind::Out)))
        liveSlots.insert(slotOf(operand));
      if (auto *used = dyn_cast<Instruction>(operand))
        enliven(used);
    }
  }

  void enlivenDeciders(const BasicBlock *block) {
    for (const BranchInst *decider : deciders(block))
      enliven(decider);
  }

  bool isUsed(const CallInst &call) const {
    for (unsigned sequence = 0; sequence < SequenceCount; ++sequence)
      if ((sequencesOf(call) >> sequence & 1) &&
          (sequenceGoesOn || sequences[sequence].needs(call)))
        return true;
    const stc::OpInfo *op = opOf(call);
    for (unsigned i = 0; i < call.arg_size(); ++i) {
      const Value *operand = call.getArgOperand(i);
      bool isWritten = !op ? operand->getType()->isPointerTy()
                           : op->params[i].isValue() && op->params[i].kind != ParamKind::In;
      if (isWritten && liveSlots.contains(slotOf(operand)))
        return true;
    }
    return false;
  }

  Function &body;
  function_ref<ArrayRef<const BranchInst *>(const BasicBlock *)> deciders;
  bool sequenceGoesOn;
  Needs::Instructions live;
  SmallVector<const Instruction *> worklist;
  SmallPtrSet<const Value *, 32> liveSlots;
  Sequence sequences[SequenceCount];
};

} // namespace

Needs::Needs(Function &body) : body(body), after(body) {
  for (const BasicBlock &block : body) {
    auto *branch = dyn_cast<BranchInst>(block.getTerminator());
    if (!branch || !branch->isConditional())
      continue;
    // What lies on one way only, up to where all ways meet.
    const BasicBlock *end = meeting(*branch);
    for (const BasicBlock *successor : branch->successors())
      for (const DomTreeNode *node = after.getNode(successor);
           node && node->getBlock() && node->getBlock() != end; node = node->getIDom())
        deciders[node->getBlock()].push_back(branch);
  }
}

BasicBlock *Needs::meeting(const BranchInst &branch) const {
  const DomTreeNode *node = after.getNode(branch.getParent());
  return node && node->getIDom() ? node->getIDom()->getBlock() : nullptr;
}

Needs::Instructions Needs::of(function_ref<bool(const Instruction &)> isRoot,
                              bool sequenceGoesOn) const {
  auto decidersOf = [&](const BasicBlock *block) -> ArrayRef<const BranchInst *> {
    auto found = deciders.find(block);
    return found == deciders.end() ? ArrayRef<const BranchInst *>() : found->second;
  };
  auto isRootOrEndless = [&](const Instruction &instruction) {
    auto *branch = dyn_cast<BranchInst>(&instruction);
    bool isEndless = branch && branch->isConditional() && !meeting(*branch);
    return isEndless || isa<ReturnInst>(instruction) || isa<UnreachableInst>(instruction) ||
           isRoot(instruction);
  };
  return Search(body, decidersOf, sequenceGoesOn).run(isRootOrEndless);
}

} // namespace anysl::link
