//===-- tools/anysl-link/WithinError.cpp - --max-error ----------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "tools/anysl-link/WithinError.h"
#include "lib/Cost/Choosing.h"
#include "lib/Shade/Progress.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;
using namespace anysl::cost;

namespace anysl {
namespace {

constexpr unsigned gridSide = 64;

shade::GridOptions pointsOf(const WithinError &wanted) {
  shade::GridOptions options;
  options.gridWidth = options.gridHeight = gridSide;
  options.environment.printTo = stderr;
  if (!wanted.inputs.empty())
    for (shade::RecordedShader &shader : shade::readRecording(wanted.inputs))
      options.recorded.push_back(std::make_shared<shade::RecordedShader>(std::move(shader)));
  return options;
}

/// One bench for each shader, or for each part of the recording that is of it.
std::vector<std::unique_ptr<Bench>> makeBenches(Builder &builder, const Build &build,
                                                const shade::GridOptions &points) {
  std::vector<std::unique_ptr<Bench>> benches;
  for (const link::ShaderReport &shader : build.report.shaders) {
    if (shader.kind == "method")
      continue;
    if (points.recorded.empty())
      benches.push_back(std::make_unique<Bench>(builder, shader.name, points));
    for (const auto &part : points.recorded)
      if (part->name == shader.name && part->kind == shader.kind && part->points) {
        shade::GridOptions own = points;
        own.recorded = {part};
        benches.push_back(std::make_unique<Bench>(builder, shader.name, own));
      }
  }
  return benches;
}

void print(const Chosen &chosen, const std::string &oracle, double limit) {
  raw_ostream &out = outs();
  out << "real " << chosen.real << ", math " << chosen.choice.math << '\n';
  for (const auto &[site, tier] : chosen.choice.sites)
    out << "  " << site.name() << " from " << tier << '\n';
  out << format("error %.3g against %s, at most %g\n", chosen.error, oracle.c_str(), limit)
      << format("%.2f ns a point in place of %.2f of the exact build (%s, correctly rounded): ",
                chosen.time, chosen.exactTime, chosen.exactReal.c_str())
      << format("%.1f %% saved\n", 100 * (1 - chosen.time / chosen.exactTime));
}

bool choose(DiagnosticEngine &diags, const std::vector<std::string> &files, TargetMachine &target,
            const WithinError &wanted, link::LinkOptions &options) {
  link::LinkOptions common = options;
  if (!wanted.runtimeGiven)
    common.runtime.clear();
  Builder builder(diags, target, files, common);
  std::vector<std::string> reals = {"float", "double"};
  if (wanted.realGiven)
    reals = {options.real};
  else if (wanted.runtimeGiven)
    erase_if(reals, [&](const std::string &real) { return !builder.works(real); });
  auto benches = makeBenches(builder, builder.build(reals.front(), {"cr"}), pointsOf(wanted));
  if (benches.empty()) {
    diags.error("--inputs: no points are recorded of these shaders");
    return false;
  }
  std::vector<Bench *> pointers;
  for (const auto &bench : benches)
    pointers.push_back(bench.get());
  shade::Progress progress("measuring", false);
  Timing timing;
  timing.progress = [&](double share, const std::string &) { progress.show(share); };
  double best;
  auto chosen = chooseWithin(pointers, reals, 0, wanted.error, timing, best);
  progress.finish();
  if (!chosen) {
    std::string message;
    raw_string_ostream(message) << format("--max-error: no choice stays within %g; the most exact "
                                          "one is off by %.3g",
                                          wanted.error, best);
    diags.error(message);
    return false;
  }
  print(*chosen, builder.oracle(), wanted.error);
  const Build &build = builder.build(chosen->real, chosen->choice);
  // The linker takes reals with derivatives by itself.
  options.real = chosen->real;
  options.runtime = build.runtime;
  options.mathChoices = wanted.choiceFile;
  return writeChoiceFile(diags, wanted.choiceFile, chosen->choice,
                         json::Object{{"real", chosen->real},
                                      {"runtime", build.runtime},
                                      {"maxError", wanted.error},
                                      {"error", chosen->error},
                                      {"nsPerPoint", chosen->time},
                                      {"exactNsPerPoint", chosen->exactTime}});
}

} // namespace

bool chooseWithinError(DiagnosticEngine &diags, const std::vector<std::string> &files,
                       TargetMachine &target, const WithinError &wanted,
                       link::LinkOptions &options) {
  try {
    return choose(diags, files, target, wanted, options);
  } catch (const Failed &) {
  } catch (const shade::UserError &error) {
    diags.error(error.what());
  }
  return false;
}

void adoptRealOf(StringRef choiceFile, bool realGiven, bool runtimeGiven,
                 link::LinkOptions &options) {
  auto buffer = MemoryBuffer::getFile(choiceFile, /*IsText=*/true);
  if (!buffer)
    return;
  auto value = json::parse((*buffer)->getBuffer());
  if (!value) {
    consumeError(value.takeError());
    return;
  }
  const json::Object *file = value->getAsObject();
  auto adopt = [&](StringRef key, bool isGiven, std::string &target) {
    if (auto name = file && !isGiven ? file->getString(key) : std::nullopt)
      target = name->str();
  };
  adopt("real", realGiven, options.real);
  adopt("runtime", runtimeGiven, options.runtime);
}

} // namespace anysl
