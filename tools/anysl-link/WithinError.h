//===-- tools/anysl-link/WithinError.h - --max-error ------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_ANYSL_LINK_WITHINERROR_H
#define ANYSL_TOOLS_ANYSL_LINK_WITHINERROR_H

#include "lib/Link/Linker.h"

namespace anysl {

struct WithinError {
  double error;
  std::string inputs;     ///< recorded points; empty: a grid
  std::string choiceFile; ///< to be written
  bool realGiven, runtimeGiven;
};

/// Measures, says on the standard output what was chosen, writes the file, and sets in \p options
/// what is to be linked. False, with an error, if nothing is exact enough or something is wrong.
bool chooseWithinError(DiagnosticEngine &diags, const std::vector<std::string> &files,
                       llvm::TargetMachine &target, const WithinError &wanted,
                       link::LinkOptions &options);

/// Takes from a file of choices which real and runtime it is about, if it says so and the command
/// line does not. What is wrong with the file, the linker reports.
void adoptRealOf(llvm::StringRef choiceFile, bool realGiven, bool runtimeGiven,
                 link::LinkOptions &options);

} // namespace anysl

#endif
