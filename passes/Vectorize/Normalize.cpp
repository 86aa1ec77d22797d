//===-- passes/Vectorize/Normalize.cpp - bring control flow into the form to widen ------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Normalize.h"

#include "passes/Vectorize/LoopExits.h"
#include "passes/Vectorize/PrivateArrays.h"
#include "passes/Vectorize/VectorAbi.h"

#include "llvm/Analysis/CFG.h"
#include "llvm/Analysis/LoopInfo.h"
#include "llvm/Analysis/MustExecute.h"
#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/Analysis/ValueTracking.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/Transforms/InstCombine/InstCombine.h"
#include "llvm/Transforms/Scalar/DCE.h"
#include "llvm/Transforms/Scalar/EarlyCSE.h"
#include "llvm/Transforms/Scalar/SROA.h"
#include "llvm/Transforms/Scalar/Scalarizer.h"
#include "llvm/Transforms/Scalar/SimplifyCFG.h"
#include "llvm/Transforms/Utils/BasicBlockUtils.h"
#include "llvm/Transforms/Utils/FixIrreducible.h"
#include "llvm/Transforms/Utils/LCSSA.h"
#include "llvm/Transforms/Utils/Local.h"
#include "llvm/Transforms/Utils/LoopSimplify.h"
#include "llvm/Transforms/Utils/LowerMemIntrinsics.h"
#include "llvm/Transforms/Utils/LowerSwitch.h"
#include "llvm/Transforms/Utils/UnifyFunctionExitNodes.h"

using namespace llvm;

namespace anysl {

std::string whyNotWidenable(const Function &function) {
  if (function.isVarArg())
    return "it takes a variable number of arguments";
  if (function.hasFnAttribute(Attribute::PresplitCoroutine))
    return "it is a coroutine";
  if (function.hasFnAttribute(Attribute::Naked))
    return "it is naked assembly";
  for (const Instruction &instruction : instructions(function)) {
    if (isa<IndirectBrInst>(instruction) || isa<CallBrInst>(instruction))
      return "it jumps to computed addresses";
    if (instruction.isEHPad() || isa<InvokeInst>(instruction) || isa<ResumeInst>(instruction))
      return "it handles exceptions";
    if (instruction.getType()->isTokenTy() || instruction.getType()->isX86_AMXTy() ||
        isa<ScalableVectorType>(instruction.getType()) || isa<TargetExtType>(instruction.getType()))
      return "it has values that have no wide form";
    if (const auto *call = dyn_cast<CallInst>(&instruction)) {
      if (call->isMustTailCall())
        return "it has a call that must be a tail call";
      if (call->getIntrinsicID() == Intrinsic::localescape)
        return "it lets other functions into its frame";
    }
  }
  return {};
}

static bool usesVectors(const Function &function) {
  for (const Instruction &instruction : instructions(function)) {
    if (instruction.getType()->isVectorTy())
      return true;
    for (const Value *operand : instruction.operand_values())
      if (operand->getType()->isVectorTy())
        return true;
  }
  return false;
}

/// The largest size of elements that a copy or filling of memory can be made of: what its alignment
/// and length allow, and for a variable of the function's own, the size that the rest of it has.
static uint64_t elementSize(const MemIntrinsic &call) {
  auto *length = dyn_cast<ConstantInt>(call.getLength());
  if (!length || length->isZero())
    return 1;
  uint64_t size = MinAlign(length->getZExtValue(), 8);
  auto limit = [&](const Value *pointer, MaybeAlign align) {
    const auto *variable = dyn_cast<AllocaInst>(getUnderlyingObject(pointer));
    uint64_t own = variable ? accessSize(*variable) : 0;
    size = std::min(size, own ? own : align.valueOrOne().value());
  };
  limit(call.getDest(), call.getDestAlign());
  if (const auto *copy = dyn_cast<MemTransferInst>(&call))
    limit(copy->getSource(), copy->getSourceAlign());
  return size;
}

/// A copy of memory becomes a loop: in it, each lane's own addresses are ordinary loads and stores.
static void expandByElements(MemIntrinsic &call, uint64_t size) {
  IRBuilder<> builder(&call);
  IntegerType *element = builder.getIntNTy(unsigned(8 * size));
  uint64_t count = cast<ConstantInt>(call.getLength())->getZExtValue() / size;
  auto at = [&](Value *pointer, Value *index) {
    return builder.CreateInBoundsGEP(element, pointer, index);
  };
  Value *filling = nullptr;
  if (auto *set = dyn_cast<MemSetInst>(&call)) {
    Value *byte = builder.CreateZExt(set->getValue(), element);
    filling = builder.CreateMul(
        byte, ConstantInt::get(element, APInt::getSplat(unsigned(8 * size), APInt(8, 1))));
  }
  auto copyOne = [&](Value *index) {
    Value *value = filling;
    if (auto *copy = dyn_cast<MemCpyInst>(&call))
      value = builder.CreateAlignedLoad(element, at(copy->getSource(), index),
                                        commonAlignment(copy->getSourceAlign().valueOrOne(), size));
    builder.CreateAlignedStore(value, at(call.getDest(), index),
                               commonAlignment(call.getDestAlign().valueOrOne(), size));
  };
  constexpr uint64_t fewEnough = 8;
  if (count <= fewEnough) {
    for (uint64_t i = 0; i < count; ++i)
      copyOne(builder.getInt64(i));
    return;
  }
  auto [inside, index] = SplitBlockAndInsertSimpleForLoop(builder.getInt64(count), &call);
  builder.SetInsertPoint(inside);
  copyOne(index);
}

static bool expandMemoryIntrinsics(Function &function, const TargetTransformInfo &costs) {
  SmallVector<MemIntrinsic *, 8> calls;
  for (Instruction &instruction : instructions(function))
    if (auto *call = dyn_cast<MemIntrinsic>(&instruction))
      calls.push_back(call);
  bool changed = false;
  for (MemIntrinsic *call : calls) {
    if (call->isVolatile())
      continue; // runs as it is, lane by lane
    if (uint64_t size = elementSize(*call); size > 1 && !isa<MemMoveInst>(call))
      expandByElements(*call, size);
    else if (auto *set = dyn_cast<MemSetInst>(call))
      expandMemSetAsLoop(set);
    else if (auto *move = dyn_cast<MemMoveInst>(call)) {
      if (!expandMemMoveAsLoop(move, costs))
        continue;
    } else {
      expandMemCpyAsLoop(cast<MemCpyInst>(call), costs);
    }
    call->eraseFromParent();
    changed = true;
  }
  return changed;
}

/// A branch whose two sides are one block is no branch; a later stage may then tell edges apart by
/// their ends.
static void foldTrivialBranches(Function &function) {
  for (BasicBlock &block : function) {
    auto *branch = dyn_cast<BranchInst>(block.getTerminator());
    if (!branch || !branch->isConditional() || branch->getSuccessor(0) != branch->getSuccessor(1))
      continue;
    BasicBlock *target = branch->getSuccessor(0);
    for (PHINode &phi : make_early_inc_range(target->phis())) {
      // Two entries for one edge hold one value.
      phi.removeIncomingValue(phi.getBasicBlockIndex(&block), false);
    }
    IRBuilder<>(branch).CreateBr(target);
    branch->eraseFromParent();
  }
}

void normalize(Function &function, FunctionAnalysisManager &analyses,
               function_ref<void(StringRef step)> check) {
  function.removeFnAttr(Attribute::OptimizeNone);
  FunctionPassManager simplify;
  simplify.addPass(SROAPass(SROAOptions::ModifyCFG));
  simplify.addPass(EarlyCSEPass(true));
  simplify.addPass(InstCombinePass());
  simplify.addPass(SimplifyCFGPass());
  auto run = [&](FunctionPassManager &passes) {
    PreservedAnalyses preserved = passes.run(function, analyses);
    analyses.invalidate(function, preserved);
  };
  run(simplify);
  check("simplification");

  bool again = false;
  if (accessKnownVariables(function)) {
    analyses.invalidate(function, PreservedAnalyses::none());
    check("moving accesses to variables");
    again = true;
  }
  if (usesVectors(function)) {
    FunctionPassManager scalarize;
    ScalarizerPassOptions options;
    options.ScalarizeLoadStore = true;
    options.ScalarizeVariableInsertExtract = true;
    scalarize.addPass(ScalarizerPass(options));
    scalarize.addPass(DCEPass());
    run(scalarize);
    check("taking vectors apart");
    again = true;
  }
  if (expandMemoryIntrinsics(function, analyses.getResult<TargetIRAnalysis>(function))) {
    analyses.invalidate(function, PreservedAnalyses::none());
    check("expansion of memory intrinsics");
    again = true;
  }
  if (again) {
    FunctionPassManager tidy;
    tidy.addPass(SROAPass(SROAOptions::ModifyCFG));
    tidy.addPass(EarlyCSEPass(true));
    tidy.addPass(SimplifyCFGPass());
    run(tidy);
  }

  removeUnreachableBlocks(function);
  analyses.invalidate(function, PreservedAnalyses::none());
  FunctionPassManager shape;
  shape.addPass(LowerSwitchPass());
  run(shape);
  foldTrivialBranches(function);
  analyses.invalidate(function, PreservedAnalyses::none());
  check("lowering of switches");
  if (mergeLoopExits(function)) {
    analyses.invalidate(function, PreservedAnalyses::none());
    check("merging of loops' exits");
  }
  // FixIrreducible crashes on some branches both of whose targets are headers of one region.
  if (mayContainIrreducibleControl(function, &analyses.getResult<LoopAnalysis>(function))) {
    SplitAllCriticalEdges(function);
    analyses.invalidate(function, PreservedAnalyses::none());
  }
  FunctionPassManager loops;
  loops.addPass(UnifyFunctionExitNodesPass());
  loops.addPass(FixIrreduciblePass());
  loops.addPass(LoopSimplifyPass());
  loops.addPass(LCSSAPass());
  run(loops);
  foldTrivialBranches(function);
  analyses.invalidate(function, PreservedAnalyses::none());
  check("normalisation of loops");
}

PreservedAnalyses NormalizePass::run(Function &function, FunctionAnalysisManager &analyses) {
  if (function.isDeclaration() || variantNames(function.getAttributes()).empty() ||
      !whyNotWidenable(function).empty())
    return PreservedAnalyses::all();
  normalize(function, analyses, [](StringRef) {});
  return PreservedAnalyses::none();
}

} // namespace anysl
