//===-- passes/Vectorize/Vectorize.h - whole-function vectorisation -----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Widens scalar functions: from a function that treats one item it makes one that treats W items at
// once, one a SIMD lane, whatever the control flow. The contract is the vector function ABI
// (docs/architecture.md, "Widening"); docs/vectorizer.md explains the algorithm.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_VECTORIZE_H
#define ANYSL_PASSES_VECTORIZE_VECTORIZE_H

#include "llvm/IR/DebugLoc.h"
#include "llvm/IR/PassManager.h"

#include <functional>
#include <string>

namespace llvm {
class Function;
class Module;
class TargetMachine;
} // namespace llvm

namespace anysl {

/// What the vectoriser has to say about a place in the source.
struct VectorizeRemark {
  enum class Kind {
    Widened,       ///< a variant got its body
    Refused,       ///< a variant could not be made; the message says why
    LaneByLane,    ///< a call or instruction runs once per active lane
    Gather,        ///< a load or store goes to an unrelated address in each lane
    DivergentLoop, ///< a loop that lanes leave at different times
  };
  Kind kind;
  std::string function; ///< the scalar function
  std::string message;  ///< one sentence, without a full stop
  llvm::DebugLoc location;
};

struct VectorizeOptions {
  /// Make only the variants with this many lanes; 0 makes all.
  unsigned width = 0;
  /// Simplify the variants when they are done. Off, the output shows what widening itself does.
  bool cleanUp = true;
  /// The bitcode of a math tier, from which the variants take the functions of C's <math.h>;
  /// without one they call C's library, once per active lane.
  std::string mathFile;
  /// Raise no floating-point exception flag that the scalar function would not raise: idle lanes
  /// then compute with numbers that raise none, in the order of the scalar code. Functions that are
  /// compiled to mind flags (`strictfp`) are always widened so.
  bool keepFlags = false;
  /// Run LLVM's verifier after every internal stage. Always done in debug builds.
  bool verifyEach = false;
  /// Is told every remark. Without one they go to the module's context as LLVM's optimisation
  /// remarks of the pass `anysl-vectorize` (-Rpass=anysl-vectorize and so on); with one, they do
  /// both.
  std::function<void(const VectorizeRemark &)> onRemark;
};

/// Defines every vector variant that the functions of \p module ask for by attribute
/// ("_ZGVdM8uul_f", or "vector-function-abi-variant"="_ZGV_LLVM_M8ul_f,...") and that has no body
/// yet. A variant whose attribute ends in "(name)" is called `name`, any other by its mangled name;
/// it has the scalar function's linkage. Attributes that are no variant names are left alone, and
/// so are those for another instruction set than x86's `b c d e` and `_LLVM_`.
///
/// \p targetMachine, which may be null, supplies costs to the clean-up. Returns whether the module
/// has changed.
bool defineVectorVariants(llvm::Module &module, const VectorizeOptions &options,
                          llvm::TargetMachine *targetMachine);

/// Asks for a variant by an attribute of the function, as clang does for `declare simd`. The name
/// may be followed by "(f_x8)", what the variant's own function is called.
void addVectorVariant(llvm::Function &function, llvm::StringRef mangledName);

/// Removes every attribute that names a vector variant, which nothing after widening needs.
void removeVectorVariants(llvm::Function &function);

/// Turns __attribute__((annotate("anysl.vector_variant:_ZGV_LLVM_M8uvl4_f(f_x8)"))) on functions of
/// a module compiled by clang into variant attributes, and keeps all other annotations. Functions
/// named as variants must be given in the module, or be declared. Both forms are taken to return.
void adoptVariantAnnotations(llvm::Module &module);

/// Tells code generation that \p function uses vectors of \p bits bits, so that it passes and keeps
/// them whole. Callers and callees must agree; variants made here already do.
void setVectorWidth(llvm::Function &function, unsigned bits);

/// The pass `anysl-vectorize<width=W>`.
class VectorizePass : public llvm::PassInfoMixin<VectorizePass> {
public:
  explicit VectorizePass(VectorizeOptions options = {},
                         llvm::TargetMachine *targetMachine = nullptr)
      : options(std::move(options)), targetMachine(targetMachine) {}
  llvm::PreservedAnalyses run(llvm::Module &module, llvm::ModuleAnalysisManager &analyses);
  static bool isRequired() { return true; }

private:
  VectorizeOptions options;
  llvm::TargetMachine *targetMachine;
};

} // namespace anysl

#endif
