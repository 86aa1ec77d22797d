//===-- lib/Link/SourceInfo.cpp - what shaders have before anything is left out -----*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A host treats a light that looks for shadows itself, or a displacement that finds normals, in a
// way of its own, and must do so as well where the scene never gets there. So a library says of
// each shader what the linker would have said of it without a scene.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Prune.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SmallPtrSet.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/Support/Error.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// Where an operator is defined: in the last layer that does; null if in none.
Function *definitionOf(Session &session, Function &callee) {
  if (!callee.isDeclaration() || !stc::opOfSymbol(callee.getName()))
    return &callee;
  for (Layer &layer : reverse(session.layers))
    if (Function *found = layer.module->getFunction(callee.getName());
        found && !found->isDeclaration())
      return found;
  return nullptr;
}

} // namespace

bool noteSource(Session &session, Shader &shader) {
  for (const stc::GlobalInfo &global : shader.info.globals)
    shader.sourceWritten |= uint64_t(global.written) << global.id;
  SmallPtrSet<Function *, 32> seen;
  SmallVector<Function *> worklist{shader.info.body, shader.info.init};
  while (!worklist.empty()) {
    Function *function = worklist.pop_back_val();
    if (!function || !seen.insert(function).second)
      continue;
    if (Error error = function->materialize()) {
      session.diags.error(toString(std::move(error)));
      return false;
    }
    for (Instruction &instruction : instructions(function)) {
      auto *call = dyn_cast<CallBase>(&instruction);
      Function *callee = call ? call->getCalledFunction() : nullptr;
      if (!callee)
        continue;
      if (const stc::OpInfo *op = stc::opOfSymbol(callee->getName()))
        shader.sourceEffects |= 1u << unsigned(op->effect);
      worklist.push_back(definitionOf(session, *callee));
    }
  }
  return true;
}

} // namespace anysl::link
