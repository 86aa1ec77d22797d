//===-- passes/Vectorize/MathTier.h - C's elementary functions from a math tier -----*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_MATHTIER_H
#define ANYSL_PASSES_VECTORIZE_MATHTIER_H

#include "llvm/ADT/StringSet.h"
#include "llvm/IR/Module.h"

#include <string>
#include <vector>

namespace anysl {

/// The math tiers of this installation, by name: lib/anysl/math/<tier>.bc beside the program or
/// plugin that this code is in.
std::vector<std::string> mathTiers();

/// The file of a tier of this installation.
std::string mathTierFile(llvm::StringRef tier);

/// Computes what a function asks of C's <math.h> as a math tier does.
class MathTier {
public:
  /// \p file: the tier's bitcode; without one, `apply` does nothing.
  MathTier(llvm::Module &module, std::string file) : module(module), file(std::move(file)) {}

  /// Replaces calls of sinf, pow and so on, and LLVM's intrinsics for them, by the tier's bodies.
  /// errno is not set any more. Returns whether anything changed.
  bool apply(llvm::Function &function);
  /// Removes what was brought into the module, which nobody calls after inlining.
  void removeUnused();

private:
  void link();
  void inlineCalls(llvm::Function &function);

  llvm::Module &module;
  std::string file;
  llvm::StringSet<> linked; ///< what came from the tier
};

} // namespace anysl

#endif
