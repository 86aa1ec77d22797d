//===-- lib/Link/Finish.cpp - the last simplification -------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Inlines the forms into their entries, so that loads of the batch's pointers and all else that
// does not depend on the point move out of the loop over points, and removes what is left over.
// Services' wrappers stay functions: a call of theirs costs nothing beside what the renderer does.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Passes.h"
#include "lib/Link/Session.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/Module.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// Inlining leaves markers of what does not alias; nothing after this reads them.
void dropMarkers(Module &module) {
  for (Function &function : module)
    if (function.getIntrinsicID() == Intrinsic::experimental_noalias_scope_decl)
      for (User *user : make_early_inc_range(function.users()))
        cast<Instruction>(user)->eraseFromParent();
}

} // namespace

bool finish(Session &session) {
  for (Shader &shader : session.shaders)
    shader.point->removeFnAttr(Attribute::NoInline);
  returnOutputs(*session.module);
  inlineAndSimplify(*session.module, session.target);
  dropMarkers(*session.module);
  removeUnused(*session.module);
  keepLines(*session.module);
  return true;
}

} // namespace anysl::link
