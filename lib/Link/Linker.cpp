//===-- lib/Link/Linker.cpp - from STC to one closed module -------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Linker.h"
#include "lib/Link/Session.h"
#include "lib/Support/Tool.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/Verifier.h"
#include "llvm/Target/TargetMachine.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// A stage that leaves malformed code behind has a bug; it is caught here rather than in a later
/// stage, which would crash. In release builds only the last stage is checked, for speed.
void verifyStage(const Session &session, StringRef stage, bool last) {
#ifdef NDEBUG
  if (!last)
    return;
#endif
  std::string message;
  raw_string_ostream stream(message);
  if (verifyModule(*session.module, &stream))
    reportInternalError("stage '" + stage + "' left malformed code: " + stream.str());
}

/// Prints the code as a stage leaves it: the shaders' files by themselves as long as they are that.
void dump(const Session &session) {
  if (session.module)
    session.module->print(*session.options.dump, nullptr);
  else
    for (const stc::StcModule &file : session.files)
      file.module->print(*session.options.dump, nullptr);
}

/// Runs one stage. Gives false if linking ends with it, by error or by wish.
template <typename Function>
bool run(Session &session, StringRef name, Function stage) {
  {
    StageTimer timer(session.report, name);
    if (!stage(session))
      return false;
  }
  bool last = name == session.options.dumpAfter;
  if (session.module)
    verifyStage(session, name, last || name == stageNames().back());
  if (last)
    dump(session);
  return !last;
}

} // namespace

ArrayRef<StringRef> stageNames() {
  static const StringRef names[] = {
#define LINK_STAGE(name, function, doc) #name,
#include "lib/Link/Stages.def"
  };
  return names;
}

namespace {

/// Runs all stages. Gives false if linking ends early.
bool runStages(Session &session, ArrayRef<std::string> files) {
  session.report.runtime = session.options.runtime;
  session.report.real = session.real;
  session.report.cpu = session.target.getTargetCPU().str();
  session.widths = session.options.widths;
  if (session.widths.empty())
    session.widths = {1, nativeWidth(session.target)};
  llvm::sort(session.widths);
  session.widths.erase(unique(session.widths), session.widths.end());

  // Everything that is read is verified here; no later stage meets malformed STC.
  if (!run(session, "read", [&](Session &s) { return readInputs(s, files); }))
    return false;

  return
      // Constants go in while a parameter is still an operator with a cell's number.
      run(session, "specialize", specializeParams) &&
      // While what a shader stores is an operator; it decides which real is linked. It goes by all
      // that the shader can do, so that the scene has no say in it.
      run(session, "tangents", giveTangents) &&
      // While what a scene does without is a call with a name and a place.
      run(session, "prune", prune) &&
      // Reads the bodies that the shaders reach and no others, which keeps linking fast however
      // much the libraries grow.
      run(session, "link", linkModules) &&
      // While a call of an operator still has its place in the shader.
      run(session, "tiers", chooseTiers) &&
      // Before notes are about the code that there is in the end.
      run(session, "loops", limitLoops) &&
      // While operators still have names and their operands addresses.
      run(session, "notes", addNotes) &&
      // While comparing texts is an operator, and before much is inlined that is then never
      // reached.
      run(session, "texts", copyForTexts) &&
      // While loops over lights still ask for their number by name; their rounds are simplified
      // where they are inlined.
      run(session, "lights", unrollLights) &&
      // Before inlining: the runtime's shade_point is copied once a shader.
      run(session, "bind", bindShaders) &&
      (session.options.reportOnly ||
       // After linking, because only the runtime knows the types.
       (run(session, "lower", lowerStorage) &&
        // Beyond this point nothing of the threaded code is left. Scalar code is simplified as far
        // as it goes before widening, because each instruction that survives is widened for every
        // width.
        run(session, "optimize", optimize) &&
        // Needs simplified scalar code; makes one function a width, with a mask and without.
        run(session, "widen", widen) &&
        // Loops over points come last, so that what is uniform can be hoisted out of them.
        run(session, "entry", makeEntries) &&
        // Knows what became of the parameters, and makes everything but itself internal.
        run(session, "describe", describe) &&
        // With everything internal and inlined, dead and duplicate code goes.
        run(session, "finish", finish)));
}

} // namespace

std::optional<LinkResult> linkShaders(DiagnosticEngine &diags, LLVMContext &context,
                                      ArrayRef<std::string> files, const LinkOptions &options,
                                      TargetMachine &target) {
  for (std::string real = options.real;;) {
    Session session(diags, context, options, target, real);
    if (runStages(session, files)) {
      for (Shader &shader : session.shaders)
        session.report.shaders.push_back(std::move(shader.report));
      if (options.reportOnly)
        session.module.reset();
      return LinkResult{std::move(session.module), std::move(session.report)};
    }
    if (session.nextReal.empty())
      return std::nullopt;
    real = session.nextReal;
  }
}

} // namespace anysl::link
