//===-- lib/Link/Session.h - what the stages of one link share ----------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_SESSION_H
#define ANYSL_LIB_LINK_SESSION_H

#include "lib/Link/Linker.h"
#include "lib/Link/MathChoice.h"
#include "lib/STC/Reader.h"
#include "llvm/ADT/BitVector.h"
#include "llvm/ADT/SetVector.h"
#include <deque>

namespace llvm {
class MemoryBuffer;
}

namespace anysl::link {

/// A module of definitions. Of two layers that define a name, the later one counts.
struct Layer {
  /// For messages: "runtime 'packet'".
  std::string name;
  std::unique_ptr<llvm::MemoryBuffer> buffer;
  /// Bodies are read when they are needed.
  std::unique_ptr<llvm::Module> module;
};

struct Entry {
  unsigned width = 0;
  llvm::Function *function = nullptr;
};

struct Shader {
  /// Names and parameters. `body` and `init` are there until the stage `bind`.
  stc::ShaderInfo info;
  /// What the names of its functions begin with: its name, with its kind where another shader has
  /// that name too.
  std::string symbol;
  /// Which parameters are constants.
  llvm::BitVector fixed;
  /// Of which parameters derivatives are read, where they have values point by point.
  llvm::BitVector differentiated;
  /// void (ptr args, i32 point), from `bind` on.
  llvm::Function *point = nullptr;
  /// void (ptr args): computes the defaults.
  llvm::Function *init = nullptr;
  std::vector<Entry> entries;
  /// Bits as in AnyslShaderInfo.
  uint32_t effects = 0;
  uint32_t services = 0;
  /// As in AnyslShaderInfo.
  uint64_t code = 0;
  /// Of the source, before a scene left anything out; as in AnyslSourceInfo.
  uint64_t sourceWritten = 0;
  uint32_t sourceEffects = 0;
  /// With a scene: whether it leaves Oi as it is, or makes it Os.
  bool keepsOpacity = false;
  ShaderReport report;
};

/// A cell of a light shader's parameters that is a constant in its code; as in AnyslLinkedParam.
struct LightCell {
  unsigned cell;
  std::string name;
  std::optional<std::string> text;
  double number = 0;
};

/// The code of a light shader that is linked in.
struct LightCode {
  /// void (ptr ctx, ptr P, ptr N, ptr L, ptr Cl, ptr Ol); null: it stays the renderer's.
  llvm::Function *function = nullptr;
  uint64_t code = 0; ///< as in AnyslShaderInfo
  std::vector<LightCell> fixed;
  bool isCalled = false; ///< by some shader
};

/// One link. Stages take it and change it; a stage that gives false has reported an error.
struct Session {
  Session(DiagnosticEngine &diags, llvm::LLVMContext &context, const LinkOptions &options,
          llvm::TargetMachine &target, llvm::StringRef real)
      : diags(diags), context(context), options(options), target(target), real(real) {}

  DiagnosticEngine &diags;
  llvm::LLVMContext &context;
  const LinkOptions &options;
  llvm::TargetMachine &target;

  /// The real that is linked: options.real, or that with derivatives if the shaders ask for them.
  std::string real;
  /// The real with which to begin anew, because the shaders read derivatives of derivatives.
  std::string nextReal;
  /// Whether the real has bounds, which are noted.
  bool notesBounds = false;
  /// Which math tier computes what.
  MathChoice math;

  /// Keeps a text as long as the session.
  llvm::StringRef keep(std::string text) { return kept.emplace_back(std::move(text)); }
  std::deque<std::string> kept;

  /// Shaders' files; their modules are used up by `link`.
  std::vector<stc::StcModule> files;
  /// Those of light shaders that are linked in; used up as well.
  std::vector<stc::StcModule> lightFiles;
  /// Shading library, real, runtime, math tier; used up by `link`.
  std::vector<Layer> layers;
  /// The widths to build, in ascending order.
  std::vector<unsigned> widths;
  std::vector<Shader> shaders;
  /// By the number of the light; where there is none it stays the renderer's.
  std::vector<LightCode> lightCode;
  /// Globals whose loads became constants, as a scene has them.
  std::map<unsigned, std::array<double, 3>> fixedGlobals;
  /// Whether what ambient lights add up to is linked in, and asked for.
  bool linksAmbient = false;
  std::unique_ptr<llvm::Module> module;
  Report report;
};

/// The widths that a shader is built for. A method is called for one point at a time.
inline llvm::ArrayRef<unsigned> widthsOf(const Session &session, const Shader &shader) {
  static constexpr unsigned one[] = {1};
  return shader.info.kind == stc::ShaderKind::Method ? llvm::ArrayRef<unsigned>(one)
                                                     : llvm::ArrayRef<unsigned>(session.widths);
}

/// Reads the shaders' files and opens the layers.
bool readInputs(Session &session, llvm::ArrayRef<std::string> files);

#define LINK_STAGE(name, function, doc) bool function(Session &session);
#include "lib/Link/Stages.def"

/// Opens runtime, real and math tier of a resource folder.
bool openLayers(Session &session);

/// Replaces the session's layers by those whose numbers carry derivatives. Gives false, and does
/// nothing, if the real has no such partner or the runtime does not work with it.
bool openLayersWithDerivatives(Session &session);

/// The constants in which runtime and real say what the library's descriptor has to know.
inline constexpr llvm::StringLiteral runtimeFacts[] = {
    "anysl_runtime_layout", "anysl_runtime_reads_half", "anysl_type_float", "anysl_real_format",
    "anysl_real_has_derivatives"};

/// What a layer says of itself in a constant of that name; nothing if there is none.
std::optional<uint64_t> constantOf(const llvm::Module &module, llvm::StringRef name);

/// Renames the functions of a math tier of which another tier's are to be found by their names, and
/// hides everything else of it.
void separateTier(Session &session, llvm::StringRef tier, llvm::Module &module);
/// The names of functions of tiers that single places in shaders ask for.
std::vector<std::string> tierSymbols(const Session &session);

/// What the stage `notes` needs of the runtime and the real; nothing where nothing is to be noted.
std::vector<std::string> noteSymbols(const Session &session);
/// Whether bounds are known of a real's numbers.
bool hasBounds(const llvm::Module &real);

/// The real of the session's runtime whose numbers have one derivative more than the session's;
/// empty if there is none.
llvm::StringRef realOfHigherOrder(const Session &session);

/// Looks for derivatives of higher order than the real's that somebody reads. If the linker chooses
/// the real, gives false and sets the session's nextReal; else they are 0, and a warning says so.
bool resolveUnknownDerivatives(Session &session);

/// Whether a module's real carries derivatives.
bool carriesDerivatives(const llvm::Module &module);

/// Lets 0 x be 0 and 0 + x be x in the arithmetic of derivatives, which <anysl/dual.h> has marked,
/// until keepArithmetic() takes that back. Everything in between may use it; code that is widened
/// afterwards gives the same bits at every width.
void relaxDerivatives(llvm::Module &module);
void keepArithmetic(llvm::Module &module);

/// With a global's name behind it, the variable by which the standard runtimes find the global's
/// first component, if they want a derivative of it.
inline constexpr llvm::StringLiteral derivativeInputPrefix = "anysl_derivative_input_";

/// What the standard runtimes call with a parameter's number where they look up a derivative of it.
inline constexpr llvm::StringLiteral derivativeParam = "anysl_derivative_param";

/// What they call with a query and the addresses that get the slopes of a lookup in a picture: the
/// query where one of those is read, else 0.
inline constexpr llvm::StringLiteral derivativeTexture = "anysl_derivative_texture";

/// What the operators read for a derivative of higher order than the real's.
inline constexpr llvm::StringLiteral unknownDerivative = "anysl_unknown_derivative";

/// Enters the globals from which derivatives are still read among the shaders' inputs, and tells
/// the runtime's code where they lie; marks the parameters of which derivatives are, and lets no
/// lookup in a picture ask for slopes that nobody reads.
void resolveDerivativeInputs(Session &session);

/// Gives the values and the derivatives of each array an array of their own. Says whether there was
/// any.
bool splitArrays(llvm::Module &module);

/// Reports recursion among what a function calls; there is no stack for it where shaders run, and
/// inlining would not end. Gives false if there is any.
bool refuseRecursion(Session &session, llvm::Function &root);

/// How many instructions a function would have with all inlined that it calls, which must not lead
/// back to it.
uint64_t expandedInstructions(const llvm::Function &root);

/// The functions with a body that a function leads to by direct calls, itself included, in the
/// order in which they are found.
llvm::SmallSetVector<llvm::Function *, 8> reachableFrom(llvm::ArrayRef<llvm::Function *> roots);

/// Marks the loads of a function (ptr args, …) that read what no shading changes.
void markInvariants(llvm::Function &shade);

/// Turns pointers through which an internal function only gives results into returned values.
void returnOutputs(llvm::Module &module);

/// Enters the functions that are left into the debug information, if there is any.
void keepLines(llvm::Module &module);

/// Direct calls in a function of what has a body or a name: everything but intrinsics. Indirect
/// calls count as "a service".
std::vector<std::string> callsIn(const llvm::Function &function);

} // namespace anysl::link

#endif
