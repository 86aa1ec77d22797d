//===-- frontends/rsl/Lower.h - a checked tree to subroutine-threaded code ----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_LOWER_H
#define ANYSL_FRONTENDS_RSL_LOWER_H

#include "frontends/rsl/Ast.h"
#include "lib/Support/Diagnostics.h"
#include <memory>

namespace llvm {
class LLVMContext;
class Module;
} // namespace llvm

namespace anysl::rsl {

struct FrontendOptions;

/// Writes the shaders of a tree that Sema has found correct as STC, in the form that
/// docs/architecture.md describes. For a library the functions that implement built-ins become
/// definitions of operators. Null after an error (of the kind that only shows here, such as a
/// library function that needs a context its operator has not).
std::unique_ptr<llvm::Module> lower(const Ast &ast, DiagnosticEngine &diags,
                                    llvm::LLVMContext &context, llvm::StringRef sourceFile,
                                    const FrontendOptions &options);

} // namespace anysl::rsl

#endif
