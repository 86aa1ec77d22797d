//===-- lib/Link/BindShaders.cpp - makes shaders functions of a batch ---------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A runtime says what happens around a shader in one function, anysl_runtime_shade_point, which
// calls the undefined anysl_shader_body. Here every shader gets its own copy, `<shader>.point`,
// that calls the shader; likewise `<shader>.init`. Functions between the two (a runtime may have
// helpers that call the body) are copied along.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Prune.h"
#include "llvm/ADT/MapVector.h"
#include "llvm/ADT/SetVector.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/Transforms/IPO/GlobalDCE.h"
#include "llvm/Transforms/IPO/Internalize.h"
#include "llvm/Transforms/Utils/Cloning.h"
#include <anysl/notes.h>

using namespace llvm;

namespace anysl::link {
namespace {

/// The functions from which `hook` is called, directly or not, `hook` itself left out.
SmallSetVector<Function *, 4> callersOf(Function &hook) {
  SmallSetVector<Function *, 4> callers;
  SmallVector<Function *> worklist{&hook};
  while (!worklist.empty())
    for (User *user : worklist.pop_back_val()->users())
      if (auto *call = dyn_cast<CallBase>(user))
        if (callers.insert(call->getFunction()))
          worklist.push_back(call->getFunction());
  return callers;
}

/// Copies `root`, and all of its callees that lead to `hook`, with calls of `hook` going to
/// `shader`. Null if `root` does not lead there.
Function *bindShader(Function &root, Function &hook, Function &shader, const std::string &name) {
  SmallSetVector<Function *, 4> callers = callersOf(hook);
  if (!callers.contains(&root))
    return nullptr;
  MapVector<Function *, Function *> copies;
  for (Function *caller : callers) {
    ValueToValueMapTy map;
    copies[caller] = CloneFunction(caller, map);
  }
  for (auto [original, copy] : copies) {
    copy->setLinkage(GlobalValue::InternalLinkage);
    copy->setComdat(nullptr);
    for (Instruction &instruction : instructions(copy))
      if (auto *call = dyn_cast<CallBase>(&instruction)) {
        Function *callee = call->getCalledFunction();
        if (callee == &hook)
          call->setCalledFunction(&shader);
        else if (Function *copied = callee ? copies.lookup(callee) : nullptr)
          call->setCalledFunction(copied);
      }
  }
  copies[&root]->setName(name);
  return copies[&root];
}

Function *hookNamed(Session &session, StringRef root, StringRef hook) {
  Function *function = session.module->getFunction(hook);
  if (!function)
    session.diags.error("runtime '" + session.options.runtime + "' is wrong: '" + root +
                        "' never calls '" + hook + "'");
  return function;
}

/// The effects and services of the operators that the shader reaches, and their names.
void noteOperators(const Session &session, Shader &shader) {
  // The stage `lower` has yet to come: structural operators are declarations.
  StringSet<> called;
  for (Function *function : reachableFrom({shader.info.body, shader.info.init}))
    for (Instruction &instruction : instructions(function))
      if (auto *call = dyn_cast<CallBase>(&instruction))
        if (Function *callee = call->getCalledFunction())
          called.insert(callee->getName());
  for (const stc::OpInfo &op : stc::allOps()) {
    if (!called.contains(op.symbol()) || unneededIn(session, op.op))
      continue;
    shader.report.ops.push_back(op.name.str());
    shader.effects |= 1u << unsigned(op.effect);
    if (op.service != stc::Service::NoService)
      shader.services |= 1u << unsigned(op.service);
  }
#define STC_EFFECT(id, name, doc)                                                                  \
  if (shader.effects >> id & 1)                                                                    \
    shader.report.effects.push_back(#name);
#include "lib/STC/Effects.def"
#define STC_SERVICE(id, name, doc)                                                                 \
  if (shader.services >> id & 1)                                                                   \
    shader.report.services.push_back(#name);
#include "lib/STC/Services.def"
  for (const stc::GlobalInfo &global : shader.info.globals) {
    std::string name = stc::globalNumbered(global.id)->name.str();
    if (global.read)
      shader.report.globalsRead.push_back(name);
    if (global.written)
      shader.report.globalsWritten.push_back(name);
  }
}

} // namespace

bool bindShaders(Session &session) {
  constexpr StringLiteral pointName = "anysl_runtime_shade_point", initName = "anysl_runtime_init",
                          bodyHook = "anysl_shader_body", initHook = "anysl_shader_init";
  Module &module = *session.module;
  Function *body = hookNamed(session, pointName, bodyHook);
  Function *init = hookNamed(session, initName, initHook);
  if (!body || !init)
    return false;
  for (Shader &shader : session.shaders) {
    noteOperators(session, shader);
    shader.point = bindShader(*module.getFunction(pointName), *body, *shader.info.body,
                              shader.symbol + ".point");
    shader.init = bindShader(*module.getFunction(initName), *init, *shader.info.init,
                             shader.symbol + ".init");
    if (!shader.point || !shader.init) {
      session.diags.error("runtime '" + session.options.runtime + "' is wrong: '" + pointName +
                          "' and '" + initName + "' do not lead to the shader");
      return false;
    }
  }

  // From here on only the shaders' own functions count, and the runtime's constants.
  SmallPtrSet<const GlobalValue *, 8> kept;
  for (Shader &shader : session.shaders) {
    kept.insert(shader.point);
    kept.insert(shader.init);
    shader.point->setLinkage(GlobalValue::ExternalLinkage);
    shader.init->setLinkage(GlobalValue::ExternalLinkage);
  }
  for (StringRef name : runtimeFacts)
    kept.insert(module.getNamedValue(name));
  kept.insert(module.getNamedValue(ANYSL_NOTES_SYMBOL));
  internalizeModule(module, [&](const GlobalValue &value) { return kept.contains(&value); });
  ModuleAnalysisManager analyses;
  GlobalDCEPass().run(module, analyses);
  session.report.carriesDerivatives = carriesDerivatives(module);
  return all_of(session.shaders, [&](Shader &shader) {
    if (!refuseRecursion(session, *shader.point) || !refuseRecursion(session, *shader.init))
      return false;
    shader.report.expandedInstructions = expandedInstructions(*shader.point);
    return true;
  });
}

} // namespace anysl::link
