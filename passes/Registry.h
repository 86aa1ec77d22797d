//===-- passes/Registry.h - make the passes known to a pass builder -----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_REGISTRY_H
#define ANYSL_PASSES_REGISTRY_H

namespace llvm {
class PassBuilder;
} // namespace llvm

namespace anysl {

/// Makes the passes of Passes.def available under their names in textual pipelines.
void registerPasses(llvm::PassBuilder &builder);

} // namespace anysl

#endif
