//===-- lib/Cost/Trace.cpp - what a shader computes, operator by operator ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Cost/Trace.h"
#include <algorithm>

using namespace llvm;

namespace anysl::cost {

Tracer::Tracer(const shade::GridOptions &options, shade::Recorder *recorder)
    : shaded(std::make_unique<shade::Grid>(options)), recorder(recorder) {
  auto hear = [](void *tracer, const AnyslNote *note) {
    static_cast<Tracer *>(tracer)->add(*note);
  };
  if (!anysl_library_note(shaded->shaderLibrary(), hear, this))
    throw shade::UserError("'" + options.library + "' does not say what it computes");
}

void Tracer::add(const AnyslNote &note) {
  const AnyslNoteSite &site = *note.site;
  if (site.kind < ANYSL_NOTE_VALUE || site.kind > ANYSL_NOTE_STORE)
    return;
  // Nothing has been stored before the first operator of the first point is through.
  if (recorder && !isRecorded)
    recorder->add(*shaded->instance(), *note.args, this, "");
  isRecorded = true;
  if (note.point != point)
    stepOfPlace.clear();
  point = note.point;
  Trace &trace = traces[point];
  if (trace.steps.size() == mostSteps) {
    trace.isComplete = false;
    return;
  }
  auto number = uint32_t(trace.steps.size());
  TraceStep &step = trace.steps.emplace_back();
  step.site = &site;
  std::copy_n(note.results, site.result_count, step.results.begin());
  bool isWritten = site.kind == ANYSL_NOTE_VALUE;
  for (uint32_t i = isWritten; i < site.operand_count; ++i)
    if (auto found = stepOfPlace.find(uint64_t(note.operands[i])); found != stepOfPlace.end())
      step.readsFrom.push_back(found->second);
  if (isWritten)
    stepOfPlace[uint64_t(note.operands[0])] = number;
}

std::vector<Trace> Tracer::run(size_t first, uint32_t count) {
  traces.assign(count, {});
  isRecorded = false;
  stepOfPlace.clear();
  shade::BatchHandle batch = shaded->makeBatch(first, count);
  shade::check(anysl_shade(shaded->instance(), batch.get(), 0, count, 1));
  return std::move(traces);
}

} // namespace anysl::cost
