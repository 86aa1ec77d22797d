//===-- lib/Link/Passes.cpp - the LLVM pipelines that linking runs ------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Passes.h"
#include "llvm/Analysis/TargetLibraryInfo.h"
#include "llvm/IR/Module.h"
#include "llvm/Passes/PassBuilder.h"
#include "llvm/Target/TargetMachine.h"
#include "llvm/Transforms/IPO/ConstantMerge.h"
#include "llvm/Transforms/IPO/GlobalDCE.h"
#include "llvm/Transforms/IPO/Inliner.h"
#include "llvm/Transforms/InstCombine/InstCombine.h"
#include "llvm/Transforms/Scalar/ADCE.h"
#include "llvm/Transforms/Scalar/CorrelatedValuePropagation.h"
#include "llvm/Transforms/Scalar/DeadStoreElimination.h"
#include "llvm/Transforms/Scalar/EarlyCSE.h"
#include "llvm/Transforms/Scalar/GVN.h"
#include "llvm/Transforms/Scalar/LICM.h"
#include "llvm/Transforms/Scalar/LoopDeletion.h"
#include "llvm/Transforms/Scalar/LoopPassManager.h"
#include "llvm/Transforms/Scalar/MemCpyOptimizer.h"
#include "llvm/Transforms/Scalar/SCCP.h"
#include "llvm/Transforms/Scalar/SROA.h"
#include "llvm/Transforms/Scalar/SimplifyCFG.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// The analysis managers of one run.
class Analyses {
public:
  explicit Analyses(const Module &module, TargetMachine *target) : builder(target) {
    // Code that runs in somebody's renderer calls no library behind our back, and no function of
    // the runtime is the C function whose name it happens to have.
    TargetLibraryInfoImpl library(Triple(module.getTargetTriple()));
    library.disableAllFunctions();
    functions.registerPass([=] { return TargetLibraryAnalysis(library); });
    builder.registerModuleAnalyses(modules);
    builder.registerCGSCCAnalyses(components);
    builder.registerFunctionAnalyses(functions);
    builder.registerLoopAnalyses(loops);
    builder.crossRegisterProxies(loops, functions, components, modules);
  }
  ModuleAnalysisManager &get() { return modules; }

private:
  LoopAnalysisManager loops;
  FunctionAnalysisManager functions;
  CGSCCAnalysisManager components;
  ModuleAnalysisManager modules;
  PassBuilder builder;
};

/// What makes a callee small before it is copied: its slots become values.
FunctionPassManager simplifyCallee() {
  FunctionPassManager passes;
  passes.addPass(SROAPass(SROAOptions::ModifyCFG));
  passes.addPass(EarlyCSEPass(/*UseMemorySSA=*/true));
  passes.addPass(InstCombinePass());
  passes.addPass(SimplifyCFGPass());
  return passes;
}

/// What is worth its time once everything is in one function.
FunctionPassManager simplifyWhole() {
  FunctionPassManager passes;
  // Constants of --param decide branches, and with them whole regions go.
  passes.addPass(SCCPPass());
  passes.addPass(SimplifyCFGPass());
  passes.addPass(SROAPass(SROAOptions::ModifyCFG));
  passes.addPass(EarlyCSEPass(/*UseMemorySSA=*/true));
  passes.addPass(InstCombinePass());
  passes.addPass(CorrelatedValuePropagationPass());
  // Uniform work inside a shader's loops moves out of them; loops without effect go.
  LoopPassManager loopPasses;
  loopPasses.addPass(LICMPass(LICMOptions()));
  loopPasses.addPass(LoopDeletionPass());
  passes.addPass(createFunctionToLoopPassAdaptor(std::move(loopPasses), /*UseMemorySSA=*/true));
  passes.addPass(GVNPass());
  passes.addPass(MemCpyOptPass());
  passes.addPass(DSEPass());
  passes.addPass(ADCEPass());
  passes.addPass(InstCombinePass());
  passes.addPass(SimplifyCFGPass());
  return passes;
}

} // namespace

void inlineAndSimplify(Module &module, TargetMachine &target) {
  Analyses analyses(module, &target);
  CGSCCPassManager components;
  components.addPass(InlinerPass(/*OnlyMandatory=*/true));
  components.addPass(createCGSCCToFunctionPassAdaptor(simplifyCallee()));
  ModulePassManager passes;
  passes.addPass(createModuleToPostOrderCGSCCPassAdaptor(std::move(components)));
  passes.addPass(GlobalDCEPass());
  passes.addPass(createModuleToFunctionPassAdaptor(simplifyWhole()));
  passes.addPass(GlobalDCEPass());
  passes.run(module, analyses.get());
}

void simplifyAgain(Module &module, TargetMachine &target) {
  Analyses analyses(module, &target);
  ModulePassManager passes;
  passes.addPass(createModuleToFunctionPassAdaptor(simplifyWhole()));
  passes.addPass(GlobalDCEPass());
  passes.run(module, analyses.get());
}

void removeUnused(Module &module) {
  ModuleAnalysisManager analyses;
  PassInstrumentationCallbacks callbacks;
  analyses.registerPass([&] { return PassInstrumentationAnalysis(&callbacks); });
  ModulePassManager passes;
  passes.addPass(GlobalDCEPass());
  passes.addPass(ConstantMergePass());
  passes.run(module, analyses);
}

} // namespace anysl::link
