//===-- passes/Vectorize/IntegerMasks.cpp - masks where there are no mask registers -----------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Every operation of logic on vectors of i1 (phi, and, or, xor, select, freeze, shuffle) gets a
// twin on integers. What feeds logic from outside, a comparison for instance, is extended where it
// is made; what uses logic, a blend for instance, looks at the twin's sign bits. The originals are
// left without users and removed.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/IntegerMasks.h"

#include "llvm/ADT/PostOrderIterator.h"
#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/Analysis/ValueTracking.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Module.h"
#include "llvm/IR/PatternMatch.h"
#include "llvm/TargetParser/Triple.h"
#include "llvm/Transforms/Utils/Local.h"

using namespace llvm;
using namespace llvm::PatternMatch;

namespace anysl {

namespace {

bool isMask(const Value *value) {
  auto *type = dyn_cast<FixedVectorType>(value->getType());
  return type && type->getElementType()->isIntegerTy(1) && type->getNumElements() > 1;
}

/// The scalar that all lanes of a shufflevector repeat.
Value *broadcastOf(const Value *value) {
  Value *scalar;
  if (match(value, m_Shuffle(m_InsertElt(m_Value(), m_Value(scalar), m_ZeroInt()), m_Value(),
                             m_ZeroMask())))
    return scalar;
  return nullptr;
}

/// Lanes of one or two masks of the same size in another order, none of them left open.
bool isPermutation(const ShuffleVectorInst &shuffle) {
  return shuffle.getType() == shuffle.getOperand(0)->getType() &&
         !is_contained(shuffle.getShuffleMask(), PoisonMaskElem);
}

bool isLogic(const Instruction &instruction) {
  if (!isMask(&instruction))
    return false;
  switch (instruction.getOpcode()) {
  case Instruction::PHI:
  case Instruction::And:
  case Instruction::Or:
  case Instruction::Xor:
  case Instruction::Select:
  case Instruction::Freeze:
    return true;
  case Instruction::ShuffleVector:
    return broadcastOf(&instruction) || isPermutation(cast<ShuffleVectorInst>(instruction));
  default:
    return false;
  }
}

class MaskRewriter {
public:
  explicit MaskRewriter(Function &function) : function(function), builder(function.getContext()) {}

  bool run();

private:
  Value *integer(Value *mask);
  Value *signBits(Value *twin);
  Value *makeTwin(Instruction &mask);

  /// Lanes of 32 bits, as most values have; of more where that leaves a register half empty.
  static Type *integerType(const Value *mask) {
    unsigned lanes = cast<FixedVectorType>(mask->getType())->getNumElements();
    unsigned bits = lanes == 2 ? 64 : 32;
    return FixedVectorType::get(IntegerType::get(mask->getContext(), bits), lanes);
  }

  Function &function;
  IRBuilder<> builder;
  DenseMap<Value *, Value *> twins;
};

} // namespace

/// The twin of a mask from anywhere. It is never poison: `select m, c, false` is false where m is,
/// even if c is poison there, and becomes an `and` of twins.
Value *MaskRewriter::integer(Value *mask) {
  if (Value *twin = twins.lookup(mask))
    return twin;
  Type *type = integerType(mask);
  if (isa<UndefValue>(mask))
    return Constant::getNullValue(type);
  IRBuilderBase::InsertPointGuard guard(builder);
  if (auto *instruction = dyn_cast<Instruction>(mask)) {
    auto place = instruction->getInsertionPointAfterDef();
    builder.SetInsertPoint((*place)->getParent(), *place);
    builder.SetCurrentDebugLocation(instruction->getDebugLoc());
  } else {
    builder.SetInsertPointPastAllocas(&function);
  }
  Value *twin = builder.CreateSExt(mask, type, mask->getName() + ".wide");
  if (!isGuaranteedNotToBeUndefOrPoison(mask))
    twin = builder.CreateFreeze(twin);
  return twins[mask] = twin;
}

Value *MaskRewriter::makeTwin(Instruction &mask) {
  builder.SetInsertPoint(&mask);
  Type *type = integerType(&mask);
  if (auto *phi = dyn_cast<PHINode>(&mask))
    return builder.CreatePHI(type, phi->getNumIncomingValues(), mask.getName() + ".wide");
  if (Value *scalar = broadcastOf(&mask)) {
    if (!isGuaranteedNotToBeUndefOrPoison(scalar))
      scalar = builder.CreateFreeze(scalar);
    auto *vector = cast<FixedVectorType>(type);
    return builder.CreateVectorSplat(vector->getNumElements(),
                                     builder.CreateSExt(scalar, vector->getElementType()));
  }
  if (auto *shuffle = dyn_cast<ShuffleVectorInst>(&mask))
    return builder.CreateShuffleVector(integer(shuffle->getOperand(0)),
                                       integer(shuffle->getOperand(1)), shuffle->getShuffleMask());
  if (auto *select = dyn_cast<SelectInst>(&mask)) {
    Value *condition = select->getCondition(), *yes = select->getTrueValue(),
          *no = select->getFalseValue();
    if (!isMask(condition)) {
      if (!isGuaranteedNotToBeUndefOrPoison(condition))
        condition = builder.CreateFreeze(condition);
      return builder.CreateSelect(condition, integer(yes), integer(no));
    }
    Value *wide = integer(condition);
    if (match(no, m_ZeroInt()))
      return builder.CreateAnd(wide, integer(yes));
    if (match(yes, m_AllOnes()))
      return builder.CreateOr(wide, integer(no));
    return builder.CreateSelect(signBits(wide), integer(yes), integer(no));
  }
  if (mask.getOpcode() == Instruction::Freeze)
    return integer(mask.getOperand(0));
  return builder.CreateBinOp(cast<BinaryOperator>(mask).getOpcode(), integer(mask.getOperand(0)),
                             integer(mask.getOperand(1)));
}

/// A mask for an instruction that wants one. It is made at its user: across a block it would be
/// narrowed again.
Value *MaskRewriter::signBits(Value *twin) {
  return builder.CreateICmpSLT(twin, Constant::getNullValue(twin->getType()));
}

bool MaskRewriter::run() {
  // A mask's operands come first, apart from those of phis.
  SmallVector<Instruction *, 32> logic;
  ReversePostOrderTraversal<Function *> order(&function);
  for (BasicBlock *block : order)
    for (Instruction &instruction : *block)
      if (isLogic(instruction))
        logic.push_back(&instruction);
  if (logic.empty())
    return false;

  for (Instruction *mask : logic)
    twins[mask] = makeTwin(*mask);
  for (Instruction *mask : logic)
    if (auto *phi = dyn_cast<PHINode>(mask))
      for (auto [block, value] : zip(phi->blocks(), phi->incoming_values()))
        cast<PHINode>(twins[mask])->addIncoming(integer(value), block);

  SmallPtrSet<Instruction *, 32> replaced(logic.begin(), logic.end());
  for (Instruction *mask : logic)
    for (Use &use : make_early_inc_range(mask->uses())) {
      auto *user = cast<Instruction>(use.getUser());
      if (replaced.contains(user))
        continue;
      if (isa<SExtInst>(user) && user->getType() == integerType(mask)) {
        user->replaceAllUsesWith(twins[mask]);
        user->eraseFromParent();
        continue;
      }
      builder.SetInsertPoint(user);
      builder.SetCurrentDebugLocation(user->getDebugLoc());
      use.set(signBits(twins[mask]));
    }
  for (Instruction *mask : logic)
    mask->replaceAllUsesWith(PoisonValue::get(mask->getType()));
  for (Instruction *mask : logic)
    mask->eraseFromParent();
  return true;
}

/// A sign bit in the lanes in which \p condition is \p holds. That of a test of one bit is the bit
/// itself, moved.
static Value *signsWhere(IRBuilder<> &builder, Value *condition, bool holds, Type *integers) {
  unsigned bits = integers->getScalarSizeInBits();
  Constant *sign = ConstantInt::get(integers, APInt::getSignMask(bits));
  CmpInst::Predicate predicate;
  Value *number;
  const APInt *bit;
  if (match(condition, m_ICmp(predicate, m_And(m_Value(number), m_Power2(bit)), m_Zero())) &&
      number->getType() == integers && ICmpInst::isEquality(predicate)) {
    unsigned up = bits - 1 - bit->countr_zero();
    Value *moved = builder.CreateShl(number, ConstantInt::get(integers, up));
    if (holds != (predicate == CmpInst::ICMP_NE))
      return builder.CreateAnd(builder.CreateNot(moved), sign);
    return up == bits - 1 ? moved : builder.CreateAnd(moved, sign);
  }
  Value *wide = builder.CreateSExt(condition, integers);
  return builder.CreateAnd(holds ? wide : builder.CreateNot(wide), sign);
}

/// A number whose sign is turned in some lanes: without mask registers a blend of it with its
/// negative costs more than to flip the sign bits.
static bool flipSigns(Function &function) {
  SmallVector<SelectInst *, 8> blends;
  for (Instruction &instruction : instructions(function)) {
    Value *negated, *kept;
    if (!match(&instruction, m_Select(m_Value(), m_FNeg(m_Value(negated)), m_Value(kept))) &&
        !match(&instruction, m_Select(m_Value(), m_Value(kept), m_FNeg(m_Value(negated)))))
      continue;
    auto &select = cast<SelectInst>(instruction);
    unsigned bits = select.getType()->getScalarSizeInBits();
    if (negated == kept && isMask(select.getCondition()) && (bits == 32 || bits == 64))
      blends.push_back(&select);
  }
  for (SelectInst *blend : blends) {
    IRBuilder<> builder(blend);
    bool holds = match(blend->getTrueValue(), m_FNeg(m_Specific(blend->getFalseValue())));
    Value *number = holds ? blend->getFalseValue() : blend->getTrueValue();
    auto *integers = VectorType::getInteger(cast<VectorType>(blend->getType()));
    Value *signs = signsWhere(builder, blend->getCondition(), holds, integers);
    Value *flipped = builder.CreateXor(builder.CreateBitCast(number, integers), signs);
    Value *result = builder.CreateBitCast(flipped, blend->getType());
    result->takeName(blend);
    blend->replaceAllUsesWith(result);
    RecursivelyDeleteTriviallyDeadInstructions(blend);
  }
  return !blends.empty();
}

// LLVM does not tell; it knows an instruction that came with mask registers if it knows the
// processor. A plugin only sees what the function's attributes say.
bool hasMaskRegisters(const Function &function, const TargetTransformInfo &target) {
  Type *lanes = FixedVectorType::get(Type::getFloatTy(function.getContext()), 16);
  StringRef features = function.getFnAttribute("target-features").getValueAsString();
  return features.contains("+avx512f") || target.isLegalMaskedExpandLoad(lanes, Align(4));
}

bool keepMasksAsIntegers(Function &function, const TargetTransformInfo &target) {
  if (!Triple(function.getParent()->getTargetTriple()).isX86() ||
      hasMaskRegisters(function, target))
    return false;
  bool flipped = flipSigns(function);
  return MaskRewriter(function).run() || flipped;
}

} // namespace anysl
