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

/// The effects of all operators that functions lead to, through the layers, as bits; `neededOnly`:
/// of those that the scene does not do without. Nothing, with an error, if a layer is damaged.
std::optional<uint32_t> effectsFrom(Session &session, SmallVector<Function *> worklist,
                                    bool neededOnly) {
  uint32_t effects = 0;
  SmallPtrSet<Function *, 32> seen;
  while (!worklist.empty()) {
    Function *function = worklist.pop_back_val();
    if (!function || !seen.insert(function).second)
      continue;
    if (Error error = function->materialize()) {
      session.diags.error(toString(std::move(error)));
      return std::nullopt;
    }
    for (Instruction &instruction : instructions(function)) {
      auto *call = dyn_cast<CallBase>(&instruction);
      Function *callee = call ? call->getCalledFunction() : nullptr;
      if (!callee)
        continue;
      if (const stc::OpInfo *op = stc::opOfSymbol(callee->getName())) {
        if (neededOnly && unneededIn(session, op->op))
          continue;
        effects |= 1u << unsigned(op->effect);
      }
      worklist.push_back(definitionOf(session, *callee));
    }
  }
  return effects;
}

} // namespace

uint32_t effectsThrough(Session &session, Function &op, bool neededOnly) {
  return effectsFrom(session, {definitionOf(session, op)}, neededOnly).value_or(0);
}

bool noteSource(Session &session, Shader &shader) {
  for (const stc::GlobalInfo &global : shader.info.globals)
    shader.sourceWritten |= uint64_t(global.written) << global.id;
  auto effects = effectsFrom(session, {shader.info.body, shader.info.init}, /*neededOnly=*/false);
  shader.sourceEffects = effects.value_or(0);
  return effects.has_value();
}

} // namespace anysl::link
