//===-- passes/Vectorize/Unmask.cpp - gathers where processors have none ----------------------===//
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

bool unmaskGathers(Function &function, const TargetTransformInfo &target) {
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
  AllocaInst *place = builder.CreateAlloca(builder.getInt64Ty(), nullptr, "idle");
  builder.CreateStore(builder.getInt64(0), place);
  for (IntrinsicInst *call : calls) {
    bool isLoad = call->getIntrinsicID() == Intrinsic::masked_gather;
    builder.SetInsertPoint(call);
    Value *mask = call->getArgOperand(isLoad ? 2 : 3);
    Value *lanes = call->getArgOperand(isLoad ? 0 : 1);
    ElementCount count = cast<VectorType>(lanes->getType())->getElementCount();
    Value *idle = builder.CreateVectorSplat(count, place);
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
