//===-- passes/Vectorize/Counters.cpp - counters that lanes leave a loop with -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What lanes leave a loop with is kept in a phi of the loop's header, and blended at each place at
// which lanes may leave: kept = select(active, counter + k, kept). Fewer and fewer lanes are active
// from one such place to the next, and those that are had the counter blended in before. So their
// value grows by a constant, and one addition under the mask does.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Counters.h"

#include "passes/Vectorize/IntegerMasks.h"

#include "llvm/Analysis/LoopInfo.h"
#include "llvm/Analysis/VectorUtils.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/PatternMatch.h"
#include "llvm/Transforms/Utils/Local.h"

using namespace llvm;
using namespace llvm::PatternMatch;

namespace anysl {

/// Whether all lanes of one mask are lanes of another.
static bool isSubset(Value *mask, Value *of, unsigned depth = 0) {
  if (mask == of || match(mask, m_Zero()))
    return true;
  Value *a, *b;
  if (depth == 8)
    return false;
  if (match(mask, m_LogicalAnd(m_Value(a), m_Value(b))))
    return isSubset(a, of, depth + 1) || isSubset(b, of, depth + 1);
  if (match(mask, m_Select(m_Value(), m_Zero(), m_Value(a))) ||
      match(mask, m_Select(m_Value(), m_Value(a), m_Zero())))
    return isSubset(a, of, depth + 1);
  return false;
}

/// Blends in what the same lanes, and perhaps more, have already.
static bool dropRepeatedBlends(Function &function) {
  bool changed = false;
  for (Instruction &instruction : make_early_inc_range(instructions(function))) {
    Value *mask, *value, *before, *wider;
    if (match(&instruction, m_Select(m_Value(mask), m_Value(value), m_Value(before))) &&
        match(before, m_Select(m_Value(wider), m_Specific(value), m_Value())) &&
        mask->getType()->isVectorTy() && mask->getType() == wider->getType() &&
        isSubset(mask, wider)) {
      instruction.replaceAllUsesWith(before);
      instruction.eraseFromParent();
      changed = true;
    }
  }
  return changed;
}

namespace {

/// A number as counter + k, or a constant.
struct Number {
  PHINode *counter = nullptr;
  APInt k;
};

/// From here on the lanes of a mask have a certain number.
struct Step {
  SelectInst *blend;
  SmallVector<Value *, 2> masks; ///< all of which a lane is in
  Number number;
};

/// What lanes keep of a counter when they leave a loop.
class KeptCounter {
public:
  KeptCounter(const Loop &loop, PHINode &kept) : loop(loop), kept(kept) {}
  /// Whether the phi is one, and understood.
  bool find();
  void rewrite();

private:
  std::optional<Number> numberOf(Value *lanes) const;
  bool findSteps();
  bool followsLastStep(Value *repeating);

  const Loop &loop;
  PHINode &kept;
  SmallVector<Step, 8> steps;
  PHINode *counter = nullptr;
  APInt increment; ///< of the counter, in an iteration
  APInt ahead;     ///< how much a lane has more than the counter when an iteration begins
};

} // namespace

/// What one scalar gives to all lanes.
std::optional<Number> KeptCounter::numberOf(Value *lanes) const {
  Value *scalar = getSplatValue(lanes);
  if (!scalar)
    return std::nullopt;
  Number number;
  const APInt *constant;
  if (match(scalar, m_APInt(constant))) {
    number.k = *constant;
    return number;
  }
  number.k = APInt::getZero(scalar->getType()->getScalarSizeInBits());
  Value *rest = scalar;
  if (match(scalar, m_Add(m_Value(rest), m_APInt(constant))) ||
      match(scalar, m_DisjointOr(m_Value(rest), m_APInt(constant))))
    number.k = *constant;
  number.counter = dyn_cast<PHINode>(rest);
  if (!number.counter || number.counter->getParent() != loop.getHeader())
    return std::nullopt;
  return number;
}

/// Follows the blends from the end of an iteration to its beginning.
bool KeptCounter::findSteps() {
  constexpr unsigned most = 64;
  Value *value = kept.getIncomingValueForBlock(loop.getLoopLatch());
  while (value != &kept) {
    Value *mask, *chosen, *before, *inner, *one, *other;
    auto *blend = dyn_cast<SelectInst>(value);
    if (!blend || !loop.contains(blend) || steps.size() > most ||
        any_of(loop.getSubLoops(), [&](const Loop *inner) { return inner->contains(blend); }) ||
        !match(blend, m_Select(m_Value(mask), m_Value(chosen), m_Value(before))) ||
        !mask->getType()->isVectorTy())
      return false;
    if (std::optional<Number> number = numberOf(chosen)) {
      steps.push_back({blend, {mask}, *number});
    } else if (match(chosen, m_Select(m_Value(inner), m_Value(one), m_Value(other))) &&
               inner->getType()->isVectorTy()) {
      // Some of the lanes take another step at once.
      std::optional<Number> first = numberOf(other), second = numberOf(one);
      if (!first || !second)
        return false;
      steps.push_back({blend, {mask, inner}, *second});
      steps.push_back({blend, {mask}, *first});
    } else {
      return false;
    }
    value = before;
  }
  std::reverse(steps.begin(), steps.end());
  return !steps.empty();
}

/// Whether lanes that begin another iteration have taken the last step, and nobody else sees what
/// those have that do. \p repeating is their mask.
bool KeptCounter::followsLastStep(Value *repeating) {
  Step &last = steps.back();
  if (last.number.counter) {
    ahead = last.number.k - increment;
    return all_of(last.masks, [&](Value *mask) { return isSubset(repeating, mask); });
  }
  // The counter's end stands for the counter where all lanes leave.
  ahead = APInt::getZero(increment.getBitWidth());
  Value *condition, *going;
  ICmpInst::Predicate predicate;
  const APInt *end;
  BasicBlock *latch = loop.getLoopLatch();
  Value *next = counter->getIncomingValueForBlock(latch);
  bool isEnd = match(repeating, m_Select(m_Value(condition), m_Zero(), m_Value(going))) &&
               match(condition, m_ICmp(predicate, m_Specific(next), m_APInt(end))) &&
               predicate == ICmpInst::ICMP_EQ && *end == last.number.k && last.masks.size() == 1 &&
               going == last.masks[0];
  last.number = {counter, increment};
  return isEnd && all_of(last.blend->uses(), [&](const Use &use) {
           auto *phi = dyn_cast<PHINode>(use.getUser());
           return phi && phi->getIncomingBlock(use) == latch;
         });
}

bool KeptCounter::find() {
  BasicBlock *latch = loop.getLoopLatch();
  if (!kept.getType()->isVectorTy() || !kept.getType()->isIntOrIntVectorTy() || !kept.hasOneUse() ||
      !isa<UndefValue>(kept.getIncomingValueForBlock(loop.getLoopPredecessor())) || !findSteps())
    return false;
  // Whoever is in the loop takes the first step.
  auto *active = dyn_cast<PHINode>(steps[0].masks[0]);
  counter = steps[0].number.counter;
  if (!active || active->getParent() != loop.getHeader() || steps[0].masks.size() > 1 || !counter)
    return false;
  const APInt *constant;
  if (!match(counter->getIncomingValueForBlock(latch),
             m_Add(m_Specific(counter), m_APInt(constant))))
    return false;
  increment = *constant;
  for (unsigned i = 1; i < steps.size(); ++i) {
    bool isLast = i + 1 == steps.size();
    if (steps[i].number.counter != counter && !(isLast && !steps[i].number.counter))
      return false;
    for (Value *wider : steps[i - 1].masks)
      if (none_of(steps[i].masks, [&](Value *mask) { return isSubset(mask, wider); }))
        return false;
  }
  return followsLastStep(active->getIncomingValueForBlock(latch));
}

void KeptCounter::rewrite() {
  auto *type = cast<FixedVectorType>(kept.getType());
  BasicBlock *before = loop.getLoopPredecessor();
  IRBuilder<> builder(before->getTerminator());
  auto lanes = [&](const APInt &number) { return ConstantInt::get(type, number); };
  Value *start =
      builder.CreateVectorSplat(type->getNumElements(), counter->getIncomingValueForBlock(before));
  start = builder.CreateAdd(start, lanes(ahead));
  builder.SetInsertPoint(&kept);
  PHINode *counted = builder.CreatePHI(type, 2, kept.getName());
  counted->addIncoming(start, before);

  Value *value = counted;
  APInt had = ahead;
  for (unsigned i = 0; i < steps.size(); ++i) {
    const Step &step = steps[i];
    builder.SetInsertPoint(step.blend);
    APInt more = step.number.k - had;
    had = step.number.k;
    if (!more.isZero()) {
      Value *mask = step.masks[0];
      if (step.masks.size() > 1)
        mask = builder.CreateLogicalAnd(mask, step.masks[1]);
      Value *minusOne = builder.CreateSExt(mask, type);
      value = more.isOne() ? builder.CreateSub(value, minusOne)
                           : builder.CreateAdd(value, builder.CreateAnd(minusOne, lanes(more)));
    }
    if (i + 1 == steps.size() || steps[i + 1].blend != step.blend)
      step.blend->replaceAllUsesWith(value);
  }
  counted->addIncoming(value, loop.getLoopLatch());
  SmallVector<WeakTrackingVH, 8> dead;
  for (const Step &step : steps)
    dead.push_back(step.blend);
  RecursivelyDeleteTriviallyDeadInstructionsPermissive(dead);
}

bool countInLanes(Function &function, const TargetTransformInfo &target) {
  bool changed = dropRepeatedBlends(function);
  // A mask register is no number to subtract, and a blend by one costs nothing.
  if (hasMaskRegisters(function, target))
    return changed;
  DominatorTree dominators(function);
  LoopInfo loops(dominators);
  for (Loop *loop : loops.getLoopsInPreorder()) {
    if (!loop->getLoopPredecessor() || !loop->getLoopLatch())
      continue;
    SmallVector<WeakTrackingVH, 8> phis;
    for (PHINode &phi : loop->getHeader()->phis())
      phis.push_back(&phi);
    for (Value *phi : phis) {
      if (!phi)
        continue;
      KeptCounter counter(*loop, *cast<PHINode>(phi));
      if (!counter.find())
        continue;
      counter.rewrite();
      changed = true;
    }
  }
  return changed;
}

} // namespace anysl
