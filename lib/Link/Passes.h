//===-- lib/Link/Passes.h - the LLVM pipelines that linking runs --------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_PASSES_H
#define ANYSL_LIB_LINK_PASSES_H

#include "llvm/IR/PassManager.h"

namespace llvm {
class Module;
class TargetMachine;
} // namespace llvm

namespace anysl::link {

/// Inlines every function marked alwaysinline, callees before callers, simplifying each before it
/// is copied into its callers; then simplifies the rest as far as scalar code goes. Nothing is
/// vectorised or unrolled, no floating-point operation is reordered or contracted, and no function
/// is taken for one of the C library's.
void inlineAndSimplify(llvm::Module &module, llvm::TargetMachine &target);

/// Simplifies each function once more.
void simplifyAgain(llvm::Module &module, llvm::TargetMachine &target);

/// Removes what nothing refers to, and merges what is constant twice.
void removeUnused(llvm::Module &module);

} // namespace anysl::link

#endif
