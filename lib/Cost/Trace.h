//===-- lib/Cost/Trace.h - what a shader computes, operator by operator -----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A trace is what a shader did at one point: each operator's result, where it came from, and which
// way each condition went. Two traces of the same point, computed with different reals, have the
// same steps until a condition comes out differently.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_TRACE_H
#define ANYSL_LIB_COST_TRACE_H

#include "lib/Shade/Grid.h"
#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/SmallVector.h"

namespace anysl::cost {

/// One operator at work. What it has of a site lives as long as the tracer.
struct TraceStep {
  const AnyslNoteSite *site;
  std::array<double, ANYSL_NOTE_RESULTS> results;
  /// The steps before that gave what it reads, by their numbers.
  llvm::SmallVector<uint32_t, 3> readsFrom;

  bool isDecision() const { return site->kind == ANYSL_NOTE_DECISION; }
  bool isStore() const { return site->kind == ANYSL_NOTE_STORE; }
  llvm::ArrayRef<double> numbers() const { return {results.data(), site->result_count}; }
};

struct Trace {
  std::vector<TraceStep> steps;
  bool isComplete = true; ///< false: there were more steps than are kept
};

/// Runs a shader of a library that Builder::buildTraced() has built.
class Tracer {
public:
  /// More steps of one point are not kept.
  static constexpr size_t mostSteps = 200'000;

  /// \p recorder, if there is one, gets the inputs of the points that run, as they are before the
  /// shader runs. Throws shade::UserError.
  explicit Tracer(const shade::GridOptions &options, shade::Recorder *recorder = nullptr);

  /// What it does at points [first, first + count).
  std::vector<Trace> run(size_t first, uint32_t count);

  const shade::Grid &grid() const { return *shaded; }

private:
  void add(const AnyslNote &note);

  std::unique_ptr<shade::Grid> shaded;
  shade::Recorder *recorder; ///< null: the inputs are known
  std::vector<Trace> traces; ///< of the points that are running
  uint32_t point = 0;        ///< whose places are known
  bool isRecorded = false;   ///< the inputs of these points
  std::map<uint64_t, uint32_t> stepOfPlace;
};

} // namespace anysl::cost

#endif
