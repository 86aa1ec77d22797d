//===-- tools/anysl-shade/Options.h - the command line ------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_ANYSL_SHADE_OPTIONS_H
#define ANYSL_TOOLS_ANYSL_SHADE_OPTIONS_H

#include "lib/Shade/Options.h"

namespace anysl::shade {

struct Options : GridOptions {
  std::string image; ///< empty: none
  bool json = false;
  bool bench = false;
};

/// Reads the arguments; nothing is returned where only help or the version was asked for and
/// printed. Throws UserError.
std::optional<Options> parseOptions(int argc, char **argv);

} // namespace anysl::shade

#endif
