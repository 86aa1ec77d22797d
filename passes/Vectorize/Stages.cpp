//===-- passes/Vectorize/Stages.cpp - the analyses of one variant, and printing them ----------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Stages.h"

#include "passes/Vectorize/Normalize.h"

using namespace llvm;

namespace anysl {

SmallVector<Shape, 8> argumentShapes(const VariantName &name) {
  SmallVector<Shape, 8> shapes;
  for (const VariantParam &param : name.params)
    switch (param.kind) {
    case VariantParam::Kind::Uniform:
      shapes.push_back(Shape::uniform().aligned(Log2(param.align)));
      break;
    case VariantParam::Kind::Linear:
      shapes.push_back(Shape::strided(param.step, true, true).aligned(Log2(param.align)));
      break;
    case VariantParam::Kind::Vector:
    case VariantParam::Kind::LinearByParam:
      shapes.push_back(Shape::varying());
      break;
    }
  return shapes;
}

Analyses::Analyses(Function &function, const VariantName &name, FunctionAnalysisManager &analyses)
    : loops(analyses.getResult<LoopAnalysis>(function)),
      dominators(analyses.getResult<DominatorTreeAnalysis>(function)),
      shapes(function, loops, dominators, analyses.getResult<AssumptionAnalysis>(function),
             argumentShapes(name), name.width),
      schedule(function, loops, dominators, shapes, !name.masked) {}

PreservedAnalyses PrintStagePass::run(Function &function, FunctionAnalysisManager &analyses) {
  if (function.isDeclaration() || !whyNotWidenable(function).empty())
    return PreservedAnalyses::all();
  for (const VariantName &name : variantNames(function.getAttributes())) {
    if (name.params.size() != function.arg_size())
      continue;
    out << name.functionName << "\n";
    Analyses found(function, name, analyses);
    if (stage == Stage::Shapes)
      found.shapes.print(out);
    else
      found.schedule.print(out);
  }
  return PreservedAnalyses::all();
}

} // namespace anysl
