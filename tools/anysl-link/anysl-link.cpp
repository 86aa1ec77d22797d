//===-- tools/anysl-link/anysl-link.cpp - from STC files to a shader library --------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Emit/Emit.h"
#include "lib/Emit/Target.h"
#include "lib/Link/Linker.h"
#include "lib/STC/Ops.h"
#include "lib/Support/Output.h"
#include "lib/Support/Tool.h"
#include "tools/anysl-link/Scene.h"
#include "tools/anysl-link/WithinError.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/LLVMContext.h"
#include "llvm/Support/CommandLine.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"

using namespace llvm;
using namespace anysl;

namespace {

cl::OptionCategory category("anysl-link");

cl::list<std::string> inputs(cl::Positional, cl::OneOrMore, cl::desc("FILE.stc.bc..."),
                             cl::cat(category));
cl::opt<std::string> output("o",
                            cl::desc("Write to FILE; its suffix says what (default: the first "
                                     "input's name with the suffix of --emit)"),
                            cl::value_desc("FILE"), cl::cat(category));
cl::opt<std::string> emitKind("emit",
                              cl::desc("What to write: so, obj, asm, bc or ll (default: by "
                                       "the suffix of -o, else so)"),
                              cl::value_desc("KIND"), cl::cat(category));
cl::opt<std::string> runtime("runtime", cl::desc("The renderer's runtime (default: packet)"),
                             cl::init("packet"), cl::value_desc("NAME"), cl::cat(category));
cl::opt<std::string> real("real", cl::desc("What a float is (default: float)"), cl::init("float"),
                          cl::value_desc("NAME"), cl::cat(category));
cl::opt<std::string> math("math",
                          cl::desc("How exact mathematics is: a tier, tiers by function, or both, "
                                   "as in u10,sin=fast (default: u10, within 1 ULP)"),
                          cl::init("u10"), cl::value_desc("TIER"), cl::cat(category));
cl::opt<std::string> mathChoices("math-choices",
                                 cl::desc("Read from FILE (JSON) what --math says, and tiers for "
                                          "single places in shaders"),
                                 cl::value_desc("FILE"), cl::cat(category));
cl::opt<unsigned> precision("precision", cl::desc("How many bits the real mp has (default: 200)"),
                            cl::value_desc("BITS"), cl::cat(category));
cl::opt<std::string> width("width",
                           cl::desc("Points at once: of 1,4,8,16, or native: one, and what "
                                    "suits the processor (default)"),
                           cl::init("native"), cl::value_desc("N,N..."), cl::cat(category));
cl::opt<std::string> cpu("mcpu", cl::desc("The processor, as LLVM names it (default: native)"),
                         cl::init("native"), cl::value_desc("CPU"), cl::cat(category));
cl::opt<std::string> triple("target", cl::desc("The system, as LLVM names it (default: this one)"),
                            cl::value_desc("TRIPLE"), cl::cat(category));
cl::list<std::string> params("param",
                             cl::desc("Make a parameter constant; without SHADER, in every "
                                      "shader that has it"),
                             cl::value_desc("[SHADER.]NAME=value[,value...]"), cl::cat(category));
cl::opt<std::string> sceneFile("scene",
                               cl::desc("Link for a scene, a RIB file or a JSON manifest, and "
                                        "leave out what it does not call for"),
                               cl::value_desc("FILE"), cl::cat(category));
cl::list<std::string> beside("beside",
                             cl::desc("With --scene: another shader of the scene, which may ask "
                                      "these for their parameters, and which, if it is one of its "
                                      "lights, may be linked into them"),
                             cl::value_desc("FILE.stc.bc"), cl::cat(category));
cl::opt<bool> effects("effects", cl::desc("With --scene: print each effect, kept or dropped"),
                      cl::cat(category));
cl::list<std::string>
    withoutEffects("without-effect",
                   cl::desc("Leave an effect of lib/STC/Effects.def out, so that its "
                            "results are 0, or Outputs.NAME, an output with all that only it "
                            "needs, to see what it costs"),
                   cl::value_desc("NAME"), cl::cat(category));
cl::opt<std::string> decline("decline",
                             cl::desc("What to do where a shader asks for what the runtime does "
                                      "not offer but may decline: neutral (give a neutral value, "
                                      "with a warning; default) or error"),
                             cl::init("neutral"), cl::value_desc("neutral|error"),
                             cl::cat(category));
cl::opt<bool> plainOperators("plain-operators",
                             cl::desc("Textbook formulas, without what keeps hard cases right"),
                             cl::cat(category));
cl::opt<unsigned> maxLoop("max-loop",
                          cl::desc("Leave every loop of a shader after N rounds, and let the host "
                                   "know (default: no limit)"),
                          cl::value_desc("N"), cl::cat(category));
cl::opt<bool> rayDerivatives("ray-derivatives",
                             cl::desc("Let traced rays carry how they change from point to point, "
                                      "as they do in shaders that ask for derivatives"),
                             cl::cat(category));
cl::opt<bool> tangents("tangents",
                       cl::desc("Let displacement shaders say how P changes from point to point "
                                "where they have moved it (dPdu and dPdv)"),
                       cl::cat(category));
cl::opt<bool> checkNaN("check-nan", cl::desc("Let the host know where a number stops being finite"),
                       cl::cat(category));
cl::opt<double> maxError("max-error",
                         cl::desc("Measure which tiers, place by place, and which of float and "
                                  "double are the fastest whose results are nowhere further than E "
                                  "from the exact ones on the inputs, and link those"),
                         cl::value_desc("E"), cl::cat(category));
cl::opt<std::string>
    inputPoints("inputs",
                cl::desc("The inputs of --max-error: points that anysl-render "
                         "--record wrote (default: a grid of 64 x 64, u and v from "
                         "0 to 1)"),
                cl::value_desc("FILE"), cl::cat(category));
cl::opt<std::string> choiceFile("write-choices",
                                cl::desc("Where --max-error writes its choice, for --math-choices "
                                         "(default: the output with .choices.json)"),
                                cl::value_desc("FILE"), cl::cat(category));
cl::opt<std::string> reportFile("report", cl::desc("Write what was done to FILE as JSON"),
                                cl::value_desc("FILE"), cl::cat(category));
cl::opt<bool> reportOnly("report-only",
                         cl::desc("Write --report's file and no code: what is known before code "
                                  "is optimised"),
                         cl::cat(category));
cl::opt<bool> noWarnings("w", cl::desc("No warnings"), cl::cat(category));
cl::opt<bool> timeStages("time-stages", cl::desc("Print how long each stage took"),
                         cl::cat(category));
cl::opt<std::string> dumpAfter("dump-after",
                               cl::desc("Print the code after a stage and stop: "
#define LINK_STAGE(name, function, doc) #name " "
#include "lib/Link/Stages.def"
                                        ),
                               cl::value_desc("STAGE"), cl::cat(category));

/// The kind of output that the command line asks for. Nothing, with an error, if it contradicts
/// itself.
std::optional<OutputKind> chooseKind(DiagnosticEngine &diags) {
  if (!emitKind.empty()) {
    auto kind = outputKindNamed(emitKind);
    if (!kind)
      diags.error("--emit=" + emitKind + ": there are so, obj, asm, bc and ll");
    return kind;
  }
  if (output.empty())
    return OutputKind::SharedLibrary;
  auto kind = outputKindOfFile(output);
  if (!kind)
    diags.error("-o " + output +
                ": the suffix is none of .so .o .s .bc .ll; say what is meant with "
                "--emit");
  return kind;
}

/// `wood.stc.bc` gives `wood.so`, in the current folder.
std::string defaultOutput(StringRef input, OutputKind kind) {
  StringRef stem = input == "-" ? "shader" : sys::path::filename(input);
  for (StringRef suffix : {".bc", ".ll", ".stc"})
    stem.consume_back(suffix);
  return (stem + suffixOf(kind)).str();
}

/// Reads --without-effect. Gives false, with an error, where a name is none.
bool parseEffects(DiagnosticEngine &diags, uint32_t &effects, std::vector<std::string> &outputs) {
  // Values, inputs and outputs are what a shader is, but single outputs are not.
  const std::pair<StringRef, stc::Effect> known[] = {
#define STC_EFFECT(id, name, doc) {#name, stc::Effect::name},
#include "lib/STC/Effects.def"
  };
  for (const std::string &name : withoutEffects) {
    if (StringRef output = name; output.consume_front("Outputs.") && !output.empty()) {
      outputs.push_back(output.str());
      continue;
    }
    const auto *found = find_if(known, [&](auto &each) { return each.first == name; });
    if (found == std::end(known) || found->second <= stc::Effect::Outputs) {
      diags.error("--without-effect=" + name + ": there is no such effect to be left out");
      return false;
    }
    effects |= 1u << unsigned(found->second);
  }
  return true;
}

/// Reads --width. Gives false, with an error, if it is not a list of widths.
bool parseWidths(DiagnosticEngine &diags, std::vector<unsigned> &widths) {
  if (width == "native")
    return true;
  SmallVector<StringRef> words;
  StringRef(width).split(words, ',');
  for (StringRef word : words) {
    unsigned value = 0;
    if (word.trim().getAsInteger(10, value) || !is_contained({1u, 4u, 8u, 16u}, value)) {
      diags.error("--width=" + width + ": expected a list of 1, 4, 8 and 16, or native");
      return false;
    }
    widths.push_back(value);
  }
  return true;
}

bool writeReport(DiagnosticEngine &diags, const link::Report &report) {
  return reportFile.empty() || writeFile(diags, reportFile, [&](raw_pwrite_stream &out) {
           out << formatv("{0:2}\n", report.toJson());
           return Error::success();
         });
}

bool run(DiagnosticEngine &diags, const Tool &tool) {
  auto kind = chooseKind(diags);
  if (!kind)
    return false;
  link::LinkOptions options;
  options.resourceDir = tool.resourceDir();
  options.runtime = runtime;
  options.real = real;
  options.math = math;
  options.mathChoices = mathChoices;
  if (!mathChoices.empty() && math.getNumOccurrences()) {
    diags.error("--math-choices says what --math does; give one of them");
    return false;
  }
  if (!mathChoices.empty())
    adoptRealOf(mathChoices, real.getNumOccurrences(), runtime.getNumOccurrences(), options);
  options.precision = precision;
  options.checkNaN = checkNaN;
  options.maxLoop = maxLoop;
  options.plainOperators = plainOperators;
  options.rayDerivatives = rayDerivatives;
  options.tangents = tangents;
  options.params.assign(params.begin(), params.end());
  if (!parseWidths(diags, options.widths) ||
      !parseEffects(diags, options.withoutEffects, options.withoutOutputs))
    return false;
  if (sceneFile.empty() && (effects || !beside.empty())) {
    diags.error("--effects and --beside go with --scene");
    return false;
  }
  std::optional<demand::Demand> scene;
  if (!sceneFile.empty()) {
    scene =
        readScene(diags, sceneFile, {inputs.begin(), inputs.end()}, {beside.begin(), beside.end()});
    if (!scene)
      return false;
    options.scene = &*scene;
    options.beside.assign(beside.begin(), beside.end());
  }
  if (decline != "neutral" && decline != "error") {
    diags.error("--decline=" + decline + ": there are neutral and error");
    return false;
  }
  options.declineIsError = decline == "error";
  if (reportOnly && (reportFile.empty() || !output.empty())) {
    diags.error("--report-only goes with --report, and without -o");
    return false;
  }
  options.reportOnly = reportOnly;
  if (!dumpAfter.empty()) {
    if (!is_contained(link::stageNames(), StringRef(dumpAfter))) {
      diags.error("--dump-after=" + dumpAfter + ": there is no such stage" +
                  didYouMean(dumpAfter, link::stageNames()));
      return false;
    }
    options.dumpAfter = dumpAfter;
    options.dump = &outs();
  }
  auto target = makeTarget(diags, cpu, triple);
  if (!target)
    return false;

  LLVMContext context;
  std::vector<std::string> files(inputs.begin(), inputs.end());
  std::string path = output.empty() ? defaultOutput(files[0], *kind) : std::string(output);
  if (maxError.getNumOccurrences()) {
    if (math.getNumOccurrences() || !mathChoices.empty()) {
      diags.error("--max-error chooses what --math and --math-choices say; give one of them");
      return false;
    }
    WithinError wanted{maxError, inputPoints, choiceFile, real.getNumOccurrences() > 0,
                       runtime.getNumOccurrences() > 0};
    if (wanted.choiceFile.empty())
      wanted.choiceFile = path + ".choices.json";
    if (!chooseWithinError(diags, files, *target, wanted, options))
      return false;
  } else if (!inputPoints.empty() || !choiceFile.empty()) {
    diags.error("--inputs and --write-choices go with --max-error");
    return false;
  }
  auto result = link::linkShaders(diags, context, files, options, *target);
  if (!result)
    return !diags.hasErrors();

  if (!reportOnly) {
    link::StageTimer timer(result->report, "emit");
    if (!emitModule(diags, *result->module, *target, *kind, path))
      return false;
    result->report.output = path;
    if (path != "-")
      (void)sys::fs::file_size(path, result->report.outputBytes);
  }
  if (timeStages)
    result->report.printTimes(errs());
  if (effects)
    result->report.printEffects(outs());
  return writeReport(diags, result->report);
}

} // namespace

int main(int argc, char **argv) {
  Tool tool(argc, argv, "anysl-link",
            "Links shaders (STC files) with a renderer's runtime into native code.\n", category);
  DiagnosticEngine diags("anysl-link");
  diags.setNoWarnings(noWarnings);
  return run(diags, tool) ? success : userError;
}
