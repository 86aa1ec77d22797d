//===-- tools/anysl-shade/Output.h - results as text, JSON, an image ---------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_ANYSL_SHADE_OUTPUT_H
#define ANYSL_TOOLS_ANYSL_SHADE_OUTPUT_H

#include "lib/Shade/Grid.h"
#include "tools/anysl-shade/Options.h"

namespace anysl::shade {

/// One line a point: "i j NAME x y z NAME x", with enough digits to read back exactly.
void printText(const Options &options, const std::vector<Result> &results, bool isDouble);

/// {"width":W,"height":H,"NAME":[…],…}. Numbers that JSON has no word for are NaN, Infinity,
/// -Infinity, as JavaScript and Python write them.
void printJson(const Options &options, const std::vector<Result> &results, bool isDouble);

/// Writes the result called Ci. Throws UserError and leaves no file where that is not possible.
void writeImage(const Options &options, const std::vector<Result> &results);

/// Times every width and prints the medians.
void runBenchmark(const Options &options, const Grid &grid);

} // namespace anysl::shade

#endif
