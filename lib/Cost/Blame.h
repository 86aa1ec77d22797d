//===-- lib/Cost/Blame.h - which operator spoilt a result -------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_BLAME_H
#define ANYSL_LIB_COST_BLAME_H

#include "lib/Cost/Stability.h"

namespace anysl::cost {

/// A shader's result at one point, rounded against exact.
struct ComparedResult {
  std::string name;
  double error = 0, magnitude = 0; ///< of the component that is furthest off, and of the largest
  double lost = 0;                 ///< digits
  uint32_t rounded = 0, exact = 0; ///< the steps that stored it
};

/// An operator, by its number in the steps of both traces.
struct Culprit {
  Cause cause;
  uint32_t step, exact;
  double added; ///< digits lost there
};

/// Two traces of one point.
class TraceComparison {
public:
  TraceComparison(const Trace &rounded, const Trace &exact, double digits);

  const std::vector<ComparedResult> &results() const { return compared; }
  /// The first condition, or index, that came out differently.
  std::optional<Culprit> branch() const;
  /// What spoilt a result; nothing if it is none of the shader's operators.
  std::optional<Culprit> blame(const ComparedResult &result) const;

private:
  /// A step of the rounded trace, beside its like in the exact one.
  struct Compared {
    std::optional<uint32_t> exact;  ///< nothing: only one of the two went there
    std::optional<uint32_t> branch; ///< the last decision before it that came out differently
    double lost = 0, error = 0;     ///< digits, and in its own units
  };

  void align(double digits);
  std::optional<std::pair<uint32_t, uint32_t>> meetAgain(uint32_t i, uint32_t j) const;
  bool isFinite(uint32_t step) const;
  double unlikeness(uint32_t operand, uint32_t step) const;
  std::optional<uint32_t> carrier(uint32_t step) const;
  std::optional<Culprit> branchBefore(uint32_t step) const;
  std::optional<Culprit> followDigits(uint32_t step) const;
  std::optional<Culprit> followNotFinite(uint32_t step) const;

  const Trace &rounded, &exact;
  std::vector<Compared> steps;
  std::optional<uint32_t> firstBranch;
  std::vector<ComparedResult> compared;
};

} // namespace anysl::cost

#endif
