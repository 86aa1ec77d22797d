//===-- lib/Link/Report.h - what linking did ----------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_REPORT_H
#define ANYSL_LIB_LINK_REPORT_H

#include "lib/Support/Diagnostics.h"
#include "llvm/Support/JSON.h"
#include <chrono>
#include <string>
#include <vector>

namespace anysl::link {

struct StageTime {
  std::string stage;
  double milliseconds = 0;
};

/// Something that widening could not do for all lanes at once.
struct WideningRemark {
  unsigned width = 0;
  std::string function; ///< the shader, or a function that the runtime keeps apart
  std::string kind;     ///< "lane by lane", "gather", "divergent loop"
  std::string message;
  FilePosition position;
};

/// A place in a shader that computes elementary functions.
struct MathCall {
  FilePosition position;
  std::string op; ///< the operator that is called there
  /// Each function that it computes, and the tier of that.
  std::vector<std::pair<std::string, std::string>> functions;
};

/// A call of an operator that belongs to an effect, in a shader linked for a scene.
struct EffectUse {
  std::string effect, op;
  FilePosition position;
  bool isKept = false;
  std::string why; ///< it went, or values that lead there: "Kr = 0.5 (scene.rib:9)"; may be empty
  std::vector<std::string> outputs; ///< if it is kept: those that it is for
};

struct ShaderReport {
  std::string name;
  std::string kind;
  unsigned stcInstructions = 0;
  /// Instructions of all that is called for a point, once a call, before any is optimised.
  uint64_t expandedInstructions = 0;
  /// Instructions of the scalar function, optimised.
  unsigned scalarInstructions = 0;
  /// Calls in the scalar function that are no intrinsics: services and what the runtime keeps
  /// apart.
  std::vector<std::string> callsLeft;
  /// The operators that the shader reaches, library functions included.
  std::vector<std::string> ops, effects, services, globalsRead, globalsWritten, fixedParams;
  std::vector<EffectUse> effectUses;       ///< with a scene only
  std::vector<std::string> droppedOutputs; ///< output parameters nobody looks at
  std::vector<unsigned> widths;
  std::vector<WideningRemark> remarks;
  std::vector<MathCall> mathCalls;
};

struct Report {
  std::string runtime, real, math, cpu;
  bool carriesDerivatives = false;          ///< whether the real's numbers do
  std::vector<std::string> linkedLights;    ///< kinds of the lights that are linked in
  std::vector<std::string> linkedLightCode; ///< those of light shaders whose code is there, too
  unsigned lightLoops = 0;                  ///< loops over lights that were unrolled for them
  std::vector<ShaderReport> shaders;
  std::vector<StageTime> times;
  std::string output;
  uint64_t outputBytes = 0;

  llvm::json::Value toJson() const;
  /// A table of the effects that the shaders can have: kept or dropped, where, and why.
  void printEffects(llvm::raw_ostream &out) const;
  /// A table of the stages' times.
  void printTimes(llvm::raw_ostream &out) const;
};

/// Adds the time from its making to its end to a report.
class StageTimer {
public:
  StageTimer(Report &report, llvm::StringRef stage)
      : report(report), stage(stage.str()), start(Clock::now()) {}
  ~StageTimer() {
    std::chrono::duration<double, std::milli> elapsed = Clock::now() - start;
    report.times.push_back({stage, elapsed.count()});
  }

private:
  using Clock = std::chrono::steady_clock;
  Report &report;
  std::string stage;
  Clock::time_point start;
};

} // namespace anysl::link

#endif
