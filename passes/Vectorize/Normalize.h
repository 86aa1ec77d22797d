//===-- passes/Vectorize/Normalize.h - bring control flow into the form to widen ----*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_NORMALIZE_H
#define ANYSL_PASSES_VECTORIZE_NORMALIZE_H

#include "llvm/ADT/STLFunctionalExtras.h"
#include "llvm/IR/PassManager.h"

#include <string>

namespace anysl {

/// Why a function cannot be widened at all; empty if it can.
std::string whyNotWidenable(const llvm::Function &function);

/// Rewrites a scalar function so that the later stages meet few forms only: values in registers
/// where they can be, two-way branches, one return, reducible loops each with a preheader, one
/// latch and exit blocks of its own, closed SSA form; no operations on vectors, and no copying of
/// memory as a whole. \p check is called with the name of each step that is done.
void normalize(llvm::Function &function, llvm::FunctionAnalysisManager &analyses,
               llvm::function_ref<void(llvm::StringRef step)> check);

/// The pass `anysl-normalize`: normalises each function that has vector variants.
class NormalizePass : public llvm::PassInfoMixin<NormalizePass> {
public:
  llvm::PreservedAnalyses run(llvm::Function &function, llvm::FunctionAnalysisManager &analyses);
};

} // namespace anysl

#endif
