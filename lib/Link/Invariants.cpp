//===-- lib/Link/Invariants.cpp - what a batch promises about its memory ------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// While a batch is shaded nobody changes AnyslShadeArgs nor the tables that it points to:
// parameters' cells, arrays' addresses, services, lights (include/anysl/abi.h). Only the arrays
// that `globals` and `param_data` list are data. So every load from the batch itself, and every
// load through one of its fields, is invariant, and moves out of the loop over points even if a
// service is called in between. Two steps away from the batch are the arrays, about which nothing
// is said.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/Analysis/ValueTracking.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/Metadata.h"

using namespace llvm;

namespace anysl::link {

void markInvariants(Function &shade) {
  auto isBatch = [&](const Value *pointer) {
    return getUnderlyingObject(pointer) == shade.getArg(0);
  };
  MDNode *empty = MDNode::get(shade.getContext(), {});
  for (Instruction &instruction : instructions(shade)) {
    auto *load = dyn_cast<LoadInst>(&instruction);
    if (!load || load->isVolatile())
      continue;
    auto *field = dyn_cast<LoadInst>(getUnderlyingObject(load->getPointerOperand()));
    if (isBatch(load->getPointerOperand()) || (field && isBatch(field->getPointerOperand())))
      load->setMetadata(LLVMContext::MD_invariant_load, empty);
  }
}

} // namespace anysl::link
