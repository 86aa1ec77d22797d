//===-- lib/Link/Report.cpp - what linking did --------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Report.h"
#include "llvm/Support/Format.h"

using namespace llvm;

namespace anysl::link {
namespace {

template <typename T>
json::Array list(const std::vector<T> &values) {
  json::Array result;
  for (const T &value : values)
    result.push_back(value);
  return result;
}

json::Value toJson(const WideningRemark &remark) {
  json::Object object{{"width", remark.width},
                      {"function", remark.function},
                      {"kind", remark.kind},
                      {"message", remark.message}};
  if (remark.position) {
    object["file"] = remark.position.file;
    object["line"] = remark.position.line;
    object["column"] = remark.position.column;
  }
  return object;
}

json::Value toJson(const MathCall &call) {
  json::Object tiers;
  for (const auto &[function, tier] : call.functions)
    tiers[function] = tier;
  return json::Object{{"file", call.position.file},
                      {"line", call.position.line},
                      {"column", call.position.column},
                      {"op", call.op},
                      {"tiers", std::move(tiers)}};
}

json::Value toJson(const ShaderReport &shader) {
  json::Array remarks, mathCalls;
  for (const MathCall &call : shader.mathCalls)
    mathCalls.push_back(toJson(call));
  for (const WideningRemark &remark : shader.remarks)
    remarks.push_back(toJson(remark));
  return json::Object{{"name", shader.name},
                      {"kind", shader.kind},
                      {"stcInstructions", shader.stcInstructions},
                      {"scalarInstructions", shader.scalarInstructions},
                      {"callsLeft", list(shader.callsLeft)},
                      {"ops", list(shader.ops)},
                      {"effects", list(shader.effects)},
                      {"services", list(shader.services)},
                      {"globalsRead", list(shader.globalsRead)},
                      {"globalsWritten", list(shader.globalsWritten)},
                      {"fixedParams", list(shader.fixedParams)},
                      {"widths", list(shader.widths)},
                      {"fallbacks", std::move(remarks)},
                      {"mathCalls", std::move(mathCalls)}};
}

} // namespace

json::Value Report::toJson() const {
  json::Array shaderList, stages;
  for (const ShaderReport &shader : shaders)
    shaderList.push_back(link::toJson(shader));
  for (const StageTime &time : times)
    stages.push_back(json::Object{{"stage", time.stage}, {"milliseconds", time.milliseconds}});
  return json::Object{{"runtime", runtime},
                      {"real", real},
                      {"math", math},
                      {"cpu", cpu},
                      {"output", output},
                      {"outputBytes", int64_t(outputBytes)},
                      {"shaders", std::move(shaderList)},
                      {"stages", std::move(stages)}};
}

void Report::printTimes(raw_ostream &out) const {
  double total = 0;
  for (const StageTime &time : times) {
    out << format("%10.2f ms  ", time.milliseconds) << time.stage << '\n';
    total += time.milliseconds;
  }
  out << format("%10.2f ms  ", total) << "total\n";
}

} // namespace anysl::link
