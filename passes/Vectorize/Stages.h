//===-- passes/Vectorize/Stages.h - the analyses of one variant, and printing them --*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_STAGES_H
#define ANYSL_PASSES_VECTORIZE_STAGES_H

#include "passes/Vectorize/Schedule.h"
#include "passes/Vectorize/VectorAbi.h"

#include "llvm/IR/PassManager.h"

namespace anysl {

/// The shapes that a variant's name gives the parameters. A linear parameter does not wrap within
/// the lanes, whether it is read as signed or not.
llvm::SmallVector<Shape, 8> argumentShapes(const VariantName &name);

/// All that is known of a normalised function before it is widened.
struct Analyses {
  Analyses(llvm::Function &function, const VariantName &name,
           llvm::FunctionAnalysisManager &analyses);

  llvm::LoopInfo &loops;
  llvm::DominatorTree &dominators;
  ShapeAnalysis shapes;
  Schedule schedule;
};

/// The passes `print<anysl-shapes>` and `print<anysl-schedule>`: what a stage finds for each
/// variant that a function, normalised before, asks for.
class PrintStagePass : public llvm::PassInfoMixin<PrintStagePass> {
public:
  enum class Stage { Shapes, Schedule };
  PrintStagePass(Stage stage, llvm::raw_ostream &out) : stage(stage), out(out) {}
  llvm::PreservedAnalyses run(llvm::Function &function, llvm::FunctionAnalysisManager &analyses);
  static bool isRequired() { return true; }

private:
  Stage stage;
  llvm::raw_ostream &out;
};

} // namespace anysl

#endif
