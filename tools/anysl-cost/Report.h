//===-- tools/anysl-cost/Report.h - what was measured, for people and programs ----*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_ANYSL_COST_REPORT_H
#define ANYSL_TOOLS_ANYSL_COST_REPORT_H

#include "lib/Cost/Experiment.h"
#include "llvm/Support/JSON.h"

namespace anysl::cost {

struct Report {
  std::string cpu;
  int rounds = 0;
  std::vector<ShaderCost> shaders;
};

/// The variants that no other beats in both time and error, by ascending error.
std::vector<size_t> paretoFront(const ShaderCost &cost);

/// One page with a plot and tables for each shader.
std::string toHtml(const Report &report);
/// The same numbers: a row for each variant; null and empty for what is infinite.
std::string toCsv(const Report &report);
llvm::json::Value toJson(const Report &report);

/// The front and the plain tiers at the widest width, in a few lines.
void printTable(const ShaderCost &cost, llvm::raw_ostream &out);

/// What one should know first, as sentences.
std::vector<std::string> summary(const ShaderCost &cost);

} // namespace anysl::cost

#endif
