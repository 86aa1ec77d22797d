//===-- tools/anysl-cost/Stability.h - what was found unstable, for people and programs -*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_ANYSL_COST_STABILITY_H
#define ANYSL_TOOLS_ANYSL_COST_STABILITY_H

#include "lib/Cost/Stability.h"

namespace anysl::cost {

/// In the form of a compiler's warnings, with the shader's lines.
void printStability(const StabilityReport &report, llvm::raw_ostream &out);
/// One page, with a heat map and a table for each shader.
std::string stabilityToHtml(llvm::ArrayRef<StabilityReport> reports);
llvm::json::Value stabilityToJson(llvm::ArrayRef<StabilityReport> reports);

} // namespace anysl::cost

#endif
