//===-- lib/Link/Linker.h - from STC to one closed module ---------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Puts shaders, shading library, real, runtime and math tier together into one module of
// native-ready code whose only exported symbol is the descriptor `anysl_library`
// (include/anysl/abi.h). docs/architecture.md, "Linking", has the whole; Stages.def the stages.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_LINKER_H
#define ANYSL_LIB_LINK_LINKER_H

#include "lib/Demand/Demand.h"
#include "lib/Link/Report.h"
#include "llvm/IR/Module.h"
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace llvm {
class TargetMachine;
}

namespace anysl::link {

struct LinkOptions {
  /// The folder that has real/, runtime/, math/ and shadelib.stc.bc: lib/anysl of the installation.
  std::string resourceDir;
  std::string runtime = "packet";
  std::string real = "float";
  /// A tier, or tiers by function, or both: "u10", "sin=u35,pow=fast", "u35,sin=fast".
  std::string math = "u10";
  /// A file of choices to use in place of `math` (MathChoice.h); empty: none.
  std::string mathChoices;
  /// How many bits a real of chosen precision (mp) has; 0: what it has by itself.
  unsigned precision = 0;
  /// How many points at once: 1, 4, 8, 16. Empty: one, and what suits the processor best.
  std::vector<unsigned> widths;
  /// Parameters to become constants, as the command line has them: "shader.name=v,v,v", "name=v".
  std::vector<std::string> params;
  /// Operators without what keeps hard cases right (runtimes/plain).
  bool plainOperators = false;
  /// What the scene calls for that the shaders are linked for; null: any scene.
  const demand::Demand *scene = nullptr;
  /// Files of other shaders of the scene, of which the light shaders may be linked in.
  std::vector<std::string> beside;
  /// Bits 1 << effect of Effects.def: effects that are left out although shaders have them, so that
  /// their cost can be measured. Results are 0.
  uint32_t withoutEffects = 0;
  /// Names of outputs that are left out for the same reason, with all that only they need: globals,
  /// output parameters.
  std::vector<std::string> withoutOutputs;
  /// Note where a number stops being finite (<anysl/notes.h>).
  bool checkNaN = false;
  /// Leave every loop after so many rounds, and note that; 0: loops run as long as they do.
  unsigned maxLoop = 0;
  /// Let traced rays carry their derivatives, for which the real has to.
  bool rayDerivatives = false;
  /// Let displacement shaders store dPdu and dPdv with P, for which the real has to carry
  /// derivatives. Those that move it by what a renderer answers leave it, since that carries none.
  bool tangents = false;
  /// Note what every operator does, for one point at a time (<anysl/notes.h>).
  bool traceOps = false;
  /// An operator of Neutral.def that nobody defines is an error, not its neutral value.
  bool declineIsError = false;
  /// Stop before code is optimised: the result is a report that knows no widths yet.
  bool reportOnly = false;
  /// The name of a stage of Stages.def after which to print the code to `dump` and stop; empty:
  /// none.
  std::string dumpAfter;
  llvm::raw_ostream *dump = nullptr;
};

struct LinkResult {
  std::unique_ptr<llvm::Module> module; ///< null where only a report was asked for
  Report report;
};

/// Links STC files for a target. Nothing, with errors reported, if a file, a name or an operator is
/// wrong, and nothing without errors after a dump. `target` gives triple, processor and features,
/// and must outlive the result.
std::optional<LinkResult> linkShaders(DiagnosticEngine &diags, llvm::LLVMContext &context,
                                      llvm::ArrayRef<std::string> files, const LinkOptions &options,
                                      llvm::TargetMachine &target);

/// The names of the stages, in order.
llvm::ArrayRef<llvm::StringRef> stageNames();

/// What can be found in a resource folder: for messages and --help. Sorted.
std::vector<std::string> availableRuntimes(llvm::StringRef resourceDir);
std::vector<std::string> availableReals(llvm::StringRef resourceDir);
std::vector<std::string> availableMathTiers(llvm::StringRef resourceDir);

/// The instruction sets that code for `target` may use, in LLVM's names, separated by commas.
std::string cpuFeatures(const llvm::TargetMachine &target);
/// How many floats a vector register of `target` holds: 4, 8 or 16.
unsigned nativeWidth(const llvm::TargetMachine &target);

} // namespace anysl::link

#endif
