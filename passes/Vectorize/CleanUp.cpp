//===-- passes/Vectorize/CleanUp.cpp - simplify what widening made ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/CleanUp.h"

#include "passes/Vectorize/AllActive.h"
#include "passes/Vectorize/Counters.h"
#include "passes/Vectorize/IntegerMasks.h"
#include "passes/Vectorize/StridedAccess.h"
#include "passes/Vectorize/Unmask.h"

#include "llvm/Analysis/TargetTransformInfo.h"
#include "llvm/IR/Instructions.h"
#include "llvm/Transforms/InstCombine/InstCombine.h"
#include "llvm/Transforms/Scalar/ADCE.h"
#include "llvm/Transforms/Scalar/EarlyCSE.h"
#include "llvm/Transforms/Scalar/GVN.h"
#include "llvm/Transforms/Scalar/LICM.h"
#include "llvm/Transforms/Scalar/LoopPassManager.h"
#include "llvm/Transforms/Scalar/SROA.h"
#include "llvm/Transforms/Scalar/SimplifyCFG.h"

using namespace llvm;

namespace anysl {

/// A value that leaves a loop has no value before a lane has left. Whatever a register holds by
/// then would take part in arithmetic of idle lanes, where a denormal number costs 150 cycles.
static void startAtZero(Function &function) {
  for (BasicBlock &block : function)
    for (PHINode &phi : block.phis())
      if (phi.getType()->isFPOrFPVectorTy())
        for (Use &value : phi.incoming_values())
          if (isa<UndefValue>(value))
            value.set(Constant::getNullValue(phi.getType()));
}

void cleanUp(Function &function, FunctionAnalysisManager &analyses,
             function_ref<void(StringRef step)> check) {
  FunctionPassManager passes;
  // Lane-private variables that are only ever used whole become registers.
  passes.addPass(SROAPass(SROAOptions::PreserveCFG));
  passes.addPass(EarlyCSEPass(true));
  passes.addPass(InstCombinePass());
  passes.addPass(SimplifyCFGPass());
  // Broadcasts and masks that were made where they are used move out of loops.
  passes.addPass(createFunctionToLoopPassAdaptor(LICMPass(LICMOptions()), true));
  passes.addPass(GVNPass());
  passes.addPass(InstCombinePass());
  passes.addPass(ADCEPass());
  passes.addPass(SimplifyCFGPass());
  PreservedAnalyses preserved = passes.run(function, analyses);
  analyses.invalidate(function, preserved);

  check("simplification");

  startAtZero(function);
  const TargetTransformInfo &target = analyses.getResult<TargetIRAnalysis>(function);
  bool changed = countInLanes(function, target);
  check("counting in lanes");
  changed |= widenStridedAccess(function, target);
  check("widening of strided access");
  if (changed) {
    // Both share masks with each other and with what is there.
    analyses.invalidate(function, PreservedAnalyses::none());
    EarlyCSEPass().run(function, analyses);
  }
  if (addAllActiveForms(function, target)) {
    check("adding forms for all lanes");
    analyses.invalidate(function, PreservedAnalyses::none());
    FunctionPassManager fold;
    fold.addPass(InstCombinePass());
    fold.run(function, analyses);
    widenStridedAccess(function, target);
    changed = true;
  }
  changed |= unmaskAccesses(function, target);
  check("unmasking");
  changed |= keepMasksAsIntegers(function, target);
  check("rewriting of masks");
  if (changed)
    analyses.invalidate(function, PreservedAnalyses::none());
}

} // namespace anysl
