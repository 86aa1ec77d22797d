//===-- lib/Link/Derivatives.cpp - arithmetic of derivatives ------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Most derivatives are 0, and what they are multiplied by and added to should cost nothing. For
// IEEE numbers 0 x may be NaN and 0 + x is not x for x = -0; a derivative is not that particular.
// <anysl/dual.h> marks such arithmetic by letting it reassociate, which nothing else in a runtime
// does.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Operator.h"

using namespace llvm;

namespace anysl::link {

bool carriesDerivatives(const Module &module) {
  const GlobalVariable *number = module.getNamedGlobal("anysl_type_float");
  auto *type = number ? dyn_cast<StructType>(number->getValueType()) : nullptr;
  return type && type->getNumElements() > 1;
}

void relaxDerivatives(Module &module) {
  for (Function &function : module)
    for (Instruction &instruction : instructions(function)) {
      if (!isa<FPMathOperator>(instruction) || !instruction.hasAllowReassoc())
        continue;
      FastMathFlags flags;
      flags.setNoSignedZeros();
      // A product alone: a sum that is not a number still shows where a derivative is read.
      flags.setNoNaNs(instruction.getOpcode() == Instruction::FMul);
      instruction.copyFastMathFlags(flags);
    }
}

void keepArithmetic(Module &module) {
  for (Function &function : module)
    for (Instruction &instruction : instructions(function))
      if (isa<FPMathOperator>(instruction))
        instruction.copyFastMathFlags(FastMathFlags());
}

} // namespace anysl::link
