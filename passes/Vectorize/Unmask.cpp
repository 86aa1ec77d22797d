//===-- passes/Vectorize/Unmask.cpp - masks where processors know none ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Unmask.h"

#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"

using namespace llvm;

namespace anysl {

/// Whether the processor gathers or scatters such a vector by itself.
static bool isNative(const IntrinsicInst &call, bool isLoad, const TargetTransformInfo &target) {
  auto *type = cast<VectorType>(isLoad ? call.getType() : call.getArgOperand(0)->getType());
  Align align(cast<ConstantInt>(call.getArgOperand(isLoad ? 1 : 2))->getZExtValue());
  return isLoad ? target.isLegalMaskedGather(type, align) &&
                      !target.forceScalarizeMaskedGather(type, align)
                : target.isLegalMaskedScatter(type, align) &&
                      !target.forceScalarizeMaskedScatter(type, align);
}

Value *maskDoneLaneByLane(const Instruction &instruction, const TargetTransformInfo &target) {
  const auto *call = dyn_cast<IntrinsicInst>(&instruction);
  Intrinsic::ID id = call ? call->getIntrinsicID() : Intrinsic::not_intrinsic;
  if (id != Intrinsic::masked_load && id != Intrinsic::masked_store)
    return nullptr;
  bool isLoad = id == Intrinsic::masked_load;
  Type *type = isLoad ? call->getType() : call->getArgOperand(0)->getType();
  Align align(cast<ConstantInt>(call->getArgOperand(isLoad ? 1 : 2))->getZExtValue());
  Value *mask = call->getArgOperand(isLoad ? 2 : 3);
  bool isWhole =
      isLoad ? target.isLegalMaskedLoad(type, align) : target.isLegalMaskedStore(type, align);
  return isWhole || isa<Constant>(mask) ? nullptr : mask;
}

/// Makes a gather or a scatter of each access to consecutive memory that is one to the processor.
static void gatherConsecutive(Function &function, const TargetTransformInfo &target) {
  for (Instruction &instruction : make_early_inc_range(instructions(function))) {
    Value *mask = maskDoneLaneByLane(instruction, target);
    if (!mask)
      continue;
    auto &call = cast<IntrinsicInst>(instruction);
    bool isLoad = call.getIntrinsicID() == Intrinsic::masked_load;
    auto *type = cast<FixedVectorType>(isLoad ? call.getType() : call.getArgOperand(0)->getType());
    IRBuilder<> builder(&call);
    SmallVector<Constant *, 32> places;
    for (unsigned lane = 0; lane < type->getNumElements(); ++lane)
      places.push_back(builder.getInt64(lane));
    Value *lanes = builder.CreateGEP(type->getElementType(), call.getArgOperand(isLoad ? 0 : 1),
                                     ConstantVector::get(places));
    Align align(cast<ConstantInt>(call.getArgOperand(isLoad ? 1 : 2))->getZExtValue());
    CallInst *made =
        isLoad ? builder.CreateMaskedGather(type, lanes, align, mask, call.getArgOperand(3))
               : builder.CreateMaskedScatter(call.getArgOperand(0), lanes, align, mask);
    made->copyMetadata(call);
    call.replaceAllUsesWith(made);
    call.eraseFromParent();
  }
}

bool unmaskAccesses(Function &function, const TargetTransformInfo &target) {
  gatherConsecutive(function, target);
  SmallVector<IntrinsicInst *, 8> calls;
  for (Instruction &instruction : instructions(function))
    if (auto *call = dyn_cast<IntrinsicInst>(&instruction)) {
      bool isLoad = call->getIntrinsicID() == Intrinsic::masked_gather;
      if ((isLoad || call->getIntrinsicID() == Intrinsic::masked_scatter) &&
          !isa<Constant>(call->getArgOperand(isLoad ? 2 : 3)) && !isNative(*call, isLoad, target))
        calls.push_back(call);
    }
  if (calls.empty())
    return false;

  IRBuilder<> builder(&*function.getEntryBlock().getFirstInsertionPt());
  // What idle lanes store must not come back to them: a place to read from, and one to write to.
  AllocaInst *zero = builder.CreateAlloca(builder.getInt64Ty(), nullptr, "idle");
  AllocaInst *sink = builder.CreateAlloca(builder.getInt64Ty(), nullptr, "idle.written");
  builder.CreateStore(builder.getInt64(0), zero);
  for (IntrinsicInst *call : calls) {
    bool isLoad = call->getIntrinsicID() == Intrinsic::masked_gather;
    builder.SetInsertPoint(call);
    Value *mask = call->getArgOperand(isLoad ? 2 : 3);
    Value *lanes = call->getArgOperand(isLoad ? 0 : 1);
    ElementCount count = cast<VectorType>(lanes->getType())->getElementCount();
    Value *idle = builder.CreateVectorSplat(count, isLoad ? zero : sink);
    call->setArgOperand(isLoad ? 0 : 1, builder.CreateSelect(mask, lanes, idle));
    call->setArgOperand(isLoad ? 2 : 3, Constant::getAllOnesValue(mask->getType()));
    // What is known of the memory that the active lanes access does not hold for the idle ones'.
    call->dropUnknownNonDebugMetadata();
    if (!isLoad)
      continue;
    Value *otherwise = call->getArgOperand(3);
    call->setArgOperand(3, PoisonValue::get(call->getType()));
    if (isa<UndefValue>(otherwise) || isa<ConstantAggregateZero>(otherwise))
      continue; // the place that idle lanes read holds 0
    builder.SetInsertPoint(call->getNextNode());
    auto *chosen = cast<Instruction>(builder.CreateSelect(mask, call, otherwise));
    call->replaceUsesWithIf(chosen, [&](Use &use) { return use.getUser() != chosen; });
  }
  return true;
}

} // namespace anysl
