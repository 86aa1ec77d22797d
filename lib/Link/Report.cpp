//===-- lib/Link/Report.cpp - what linking did --------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Report.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/FormatAdapters.h"
#include "llvm/Support/Path.h"
#include <map>
#include <set>
#include <tuple>

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

json::Value toJson(const EffectUse &use) {
  return json::Object{{"effect", use.effect},
                      {"op", use.op},
                      {"file", use.position.file},
                      {"line", use.position.line},
                      {"column", use.position.column},
                      {"kept", use.isKept},
                      {"why", use.why},
                      {"outputs", list(use.outputs)}};
}

json::Value toJson(const ShaderReport &shader) {
  json::Array remarks, mathCalls, uses;
  for (const EffectUse &use : shader.effectUses)
    uses.push_back(toJson(use));
  for (const MathCall &call : shader.mathCalls)
    mathCalls.push_back(toJson(call));
  for (const WideningRemark &remark : shader.remarks)
    remarks.push_back(toJson(remark));
  return json::Object{{"name", shader.name},
                      {"kind", shader.kind},
                      {"stcInstructions", shader.stcInstructions},
                      {"expandedInstructions", int64_t(shader.expandedInstructions)},
                      {"scalarInstructions", shader.scalarInstructions},
                      {"callsLeft", list(shader.callsLeft)},
                      {"ops", list(shader.ops)},
                      {"effects", list(shader.effects)},
                      {"services", list(shader.services)},
                      {"globalsRead", list(shader.globalsRead)},
                      {"globalsWritten", list(shader.globalsWritten)},
                      {"fixedParams", list(shader.fixedParams)},
                      {"droppedOutputs", list(shader.droppedOutputs)},
                      {"effectUses", std::move(uses)},
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
                      {"carriesDerivatives", carriesDerivatives},
                      {"math", math},
                      {"cpu", cpu},
                      {"output", output},
                      {"outputBytes", int64_t(outputBytes)},
                      {"linkedLights", list(linkedLights)},
                      {"linkedLightCode", list(linkedLightCode)},
                      {"lightLoops", lightLoops},
                      {"shaders", std::move(shaderList)},
                      {"stages", std::move(stages)}};
}

void Report::printEffects(raw_ostream &out) const {
  if (!linkedLights.empty())
    out << "lights linked in: " << linkedLights.size() << " (" << join(linkedLights, ", ") << "); "
        << lightLoops << (lightLoops == 1 ? " loop" : " loops") << " over them unrolled"
        << (linkedLightCode.empty() ? "" : "; with the code of ") << join(linkedLightCode, ", ")
        << '\n';
  for (const ShaderReport &shader : shaders) {
    out << "shader " << shader.name << ", " << shader.scalarInstructions << " instructions\n";
    // One line for calls that share everything but their place.
    using Line = std::tuple<std::string, bool, std::string>; // effect, kept, why
    struct Uses {
      std::map<std::string, unsigned> places;
      std::set<std::string> outputs;
    };
    std::map<Line, Uses> lines;
    for (const EffectUse &use : shader.effectUses) {
      std::string place = use.op;
      if (use.position)
        place += " " + sys::path::filename(use.position.file).str() + ":" +
                 std::to_string(use.position.line);
      Uses &uses = lines[{use.effect, use.isKept, use.why}];
      ++uses.places[place];
      // Outputs are for themselves.
      if (!StringRef(use.effect).starts_with("Outputs."))
        uses.outputs.insert(use.outputs.begin(), use.outputs.end());
    }
    size_t widest = 0;
    for (const auto &[line, uses] : lines)
      widest = std::max(widest, std::get<0>(line).size());
    for (const auto &[line, uses] : lines) {
      const auto &[effect, isKept, why] = line;
      out << "  " << left_justify(effect, unsigned(widest + 1))
          << (isKept ? "kept     " : "dropped  ");
      ListSeparator separator;
      for (const auto &[place, count] : uses.places) {
        out << separator << place;
        if (count > 1)
          out << " (" << count << " times)";
      }
      out << (uses.outputs.empty() ? "" : "; for ") << join(uses.outputs, ", ")
          << (why.empty() ? "" : "; ") << why << '\n';
    }
  }
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
