//===-- lib/Link/Optimize.cpp - dissolves the threaded code -------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Makes all functions alike, inlines every one that the runtime does not keep apart, and
// simplifies.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Passes.h"
#include "lib/Link/Session.h"
#include "passes/Vectorize/VectorAbi.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/AttributeMask.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/VFABIDemangler.h"
#include "llvm/Target/TargetMachine.h"
#include <anysl/abi.h>

using namespace llvm;

namespace anysl::link {
namespace {

bool hasVariants(const Function &function) {
  return !variantNames(function.getAttributes()).empty();
}

/// Modules come from a front end that knows no target and from a compiler whose target is not ours;
/// LLVM refuses to inline one into the other unless their attributes agree. What stays are
/// variants' names and what is known about memory.
void stamp(Function &function, const Session &session) {
  AttributeMask dropped;
  for (Attribute attribute : function.getAttributes().getFnAttrs())
    if (attribute.isStringAttribute()) {
      StringRef name = attribute.getKindAsString();
      if (name != VFABI::MappingsAttrName && !name.starts_with("_ZGV"))
        dropped.addAttribute(name);
    }
  for (auto kind :
       {Attribute::OptimizeNone, Attribute::OptimizeForSize, Attribute::MinSize, Attribute::UWTable,
        Attribute::StackProtect, Attribute::StackProtectStrong, Attribute::StackProtectReq,
        Attribute::InlineHint, Attribute::AlwaysInline, Attribute::NoBuiltin,
        // A shader's loop that never ends hangs; it is not undefined behaviour.
        Attribute::MustProgress, Attribute::WillReturn})
    dropped.addAttribute(kind);
  // What a runtime keeps apart and calls `const` asks the renderer for something that is the same
  // for the whole batch. It may be asked for before the loop over the points, needed or not:
  // nothing else says that the loop over the lights in between comes to an end.
  bool isSameForBatch = function.hasFnAttribute(Attribute::NoInline) &&
                        function.hasFnAttribute(Attribute::WillReturn) &&
                        function.doesNotAccessMemory();
  function.removeFnAttrs(dropped);
  function.addFnAttr(Attribute::NoUnwind);
  if (isSameForBatch)
    function.addFnAttr(Attribute::Speculatable);
  if (function.isDeclaration())
    return;
  function.addFnAttr("target-cpu", session.target.getTargetCPU());
  if (StringRef features = session.target.getTargetFeatureString(); !features.empty())
    function.addFnAttr("target-features", features);
  function.setPersonalityFn(nullptr);
  function.setComdat(nullptr);
}

/// A runtime keeps a service's wrapper apart by `noinline`, and one with wide forms stays a call
/// until the wide form has taken its place. Everything else is dissolved.
bool staysCall(const Session &session, const Function &function) {
  if (function.hasFnAttribute(Attribute::NoInline) || hasVariants(function) ||
      any_of(session.shaders, [&](const Shader &shader) {
        return &function == shader.point || &function == shader.init;
      }))
    return true;
  // The wide forms themselves, which are called from widened code only.
  const GlobalVariable *used = function.getParent()->getNamedGlobal("llvm.compiler.used");
  return used && any_of(used->getInitializer()->operands(), [&](const Use &use) {
           return use.get()->stripPointerCasts() == &function;
         });
}

/// The batch outlives the call, is there as a whole, and is not among the arrays that are written.
void describeArguments(Function &function) {
  function.addParamAttr(0, Attribute::NoAlias);
  function.addParamAttr(0, Attribute::NonNull);
  function.addParamAttr(0, Attribute::NoUndef);
  function.addDereferenceableParamAttr(0, sizeof(AnyslShadeArgs));
}

} // namespace

bool optimize(Session &session) {
  Module &module = *session.module;
  for (Function &function : module) {
    if (function.isIntrinsic())
      continue;
    stamp(function, session);
    if (!function.isDeclaration())
      function.addFnAttr(staysCall(session, function) ? Attribute::NoInline
                                                      : Attribute::AlwaysInline);
    for (Instruction &instruction : instructions(function))
      if (auto *call = dyn_cast<CallBase>(&instruction))
        call->removeFnAttr(Attribute::NoBuiltin);
  }
  for (Shader &shader : session.shaders) {
    describeArguments(*shader.point);
    describeArguments(*shader.init);
    shader.point->addParamAttr(0, Attribute::ReadOnly);
  }
  relaxDerivatives(module);
  inlineAndSimplify(module, session.target);
  if (carriesDerivatives(module)) {
    if (splitArrays(module))
      simplifyAgain(module, session.target);
    if (!resolveUnknownDerivatives(session))
      return false;
    resolveDerivativeInputs(session);
    simplifyAgain(module, session.target);
  }
  keepArithmetic(module);
  for (Shader &shader : session.shaders) {
    markInvariants(*shader.point);
    shader.report.scalarInstructions = shader.point->getInstructionCount();
    shader.report.callsLeft = callsIn(*shader.point);
  }
  return true;
}

} // namespace anysl::link
