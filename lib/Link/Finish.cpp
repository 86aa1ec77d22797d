//===-- lib/Link/Finish.cpp - the last simplification -------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Inlines the forms into their entries, so that loads of the batch's pointers and all else that does
// not depend on the point move out of the loop over points, and removes what is left over.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Passes.h"
#include "lib/Link/Session.h"
#include "llvm/IR/Module.h"

using namespace llvm;

namespace anysl::link {

bool finish(Session &session) {
  for (Shader &shader : session.shaders)
    shader.point->removeFnAttr(Attribute::NoInline);
  inlineAndSimplify(*session.module, session.target);
  removeUnused(*session.module);
  return true;
}

} // namespace anysl::link
