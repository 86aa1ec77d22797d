//===-- passes/Vectorize/Remarks.cpp - telling what became of a function ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Remarks.h"

#include "llvm/IR/DiagnosticInfo.h"
#include "llvm/IR/Function.h"

using namespace llvm;

namespace anysl {

void Remarks::emit(VectorizeRemark::Kind kind, const Function &function, DebugLoc location,
                   const Twine &message) const {
  using Kind = VectorizeRemark::Kind;
  constexpr const char *pass = "anysl-vectorize";
  std::string text = message.str();
  if (function.empty())
    return;
  const BasicBlock *block = &function.getEntryBlock();
  DiagnosticLocation place(location);
  LLVMContext &context = function.getContext();
  switch (kind) {
  case Kind::Widened:
    context.diagnose(OptimizationRemark(pass, "Widened", place, block) << text);
    break;
  case Kind::Refused:
    context.diagnose(OptimizationRemarkMissed(pass, "Refused", place, block) << text);
    break;
  case Kind::LaneByLane:
    context.diagnose(OptimizationRemarkMissed(pass, "LaneByLane", place, block) << text);
    break;
  case Kind::Gather:
    context.diagnose(OptimizationRemarkAnalysis(pass, "Gather", place, block) << text);
    break;
  case Kind::DivergentLoop:
    context.diagnose(OptimizationRemarkAnalysis(pass, "DivergentLoop", place, block) << text);
    break;
  }
  if (options.onRemark)
    options.onRemark({kind, function.getName().str(), text, location});
}

} // namespace anysl
