//===-- passes/Vectorize/CleanUp.h - simplify what widening made --------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_CLEANUP_H
#define ANYSL_PASSES_VECTORIZE_CLEANUP_H

#include "llvm/ADT/STLFunctionalExtras.h"
#include "llvm/IR/PassManager.h"

namespace anysl {

/// Simplifies a variant: folds blends, shares what lanes have in common, drops what nobody uses. \p
/// check is called with the name of each step that is done.
void cleanUp(llvm::Function &function, llvm::FunctionAnalysisManager &analyses,
             llvm::function_ref<void(llvm::StringRef step)> check);

} // namespace anysl

#endif
