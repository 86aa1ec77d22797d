//===-- passes/Vectorize/Flags.cpp - floating-point exception flags ---------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Flags.h"

#include "passes/Vectorize/Intrinsics.h"

#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"

using namespace llvm;

namespace anysl {

namespace {
struct Form {
  Intrinsic::ID id = Intrinsic::not_intrinsic;
  bool rounds = false; ///< takes a rounding mode
};
} // namespace

/// The constrained intrinsic that does what an instruction does, if that may raise flags.
static Form constrainedForm(const Instruction &instruction) {
  if (const auto *call = dyn_cast<IntrinsicInst>(&instruction)) {
    switch (call->getIntrinsicID()) {
#define INSTRUCTION(NAME, ARGUMENTS, ROUNDS, CONSTRAINED)
#define FUNCTION(NAME, ARGUMENTS, ROUNDS, CONSTRAINED)                                             \
  case Intrinsic::NAME:                                                                            \
    return {Intrinsic::CONSTRAINED, ROUNDS};
#include "llvm/IR/ConstrainedOps.def"
    default:
      return {};
    }
  }
  if (const auto *comparison = dyn_cast<FCmpInst>(&instruction)) {
    FCmpInst::Predicate predicate = comparison->getPredicate();
    if (predicate == FCmpInst::FCMP_TRUE || predicate == FCmpInst::FCMP_FALSE)
      return {};
    return {Intrinsic::experimental_constrained_fcmp, false};
  }
  switch (instruction.getOpcode()) {
#define FUNCTION(NAME, ARGUMENTS, ROUNDS, CONSTRAINED)
#define CMP_INSTRUCTION(NAME, ARGUMENTS, ROUNDS, CONSTRAINED, DAG)
#define INSTRUCTION(NAME, ARGUMENTS, ROUNDS, CONSTRAINED)                                          \
  case Instruction::NAME:                                                                          \
    return {Intrinsic::CONSTRAINED, ROUNDS};
#include "llvm/IR/ConstrainedOps.def"
  default:
    return {};
  }
}

void mindFlags(Function &function) {
  if (function.hasFnAttribute(Attribute::StrictFP))
    return;
  function.addFnAttr(Attribute::StrictFP);
  LLVMContext &context = function.getContext();
  auto text = [&](StringRef word) {
    return MetadataAsValue::get(context, MDString::get(context, word));
  };
  for (Instruction &instruction : make_early_inc_range(instructions(function))) {
    auto *call = dyn_cast<CallBase>(&instruction);
    if (call)
      call->addFnAttr(Attribute::StrictFP);
    Form form = constrainedForm(instruction);
    if (form.id == Intrinsic::not_intrinsic)
      continue;
    SmallVector<Value *, 6> arguments;
    if (call)
      arguments.append(call->arg_begin(), call->arg_end());
    else
      arguments.append(instruction.value_op_begin(), instruction.value_op_end());
    if (auto *comparison = dyn_cast<FCmpInst>(&instruction))
      arguments.push_back(text(CmpInst::getPredicateName(comparison->getPredicate())));
    if (form.rounds)
      arguments.push_back(text("round.tonearest"));
    arguments.push_back(text("fpexcept.strict"));
    IRBuilder<> builder(&instruction);
    CallInst *made = callIntrinsic(builder, form.id, instruction.getType(), arguments);
    made->addFnAttr(Attribute::StrictFP);
    if (isa<FPMathOperator>(made) && isa<FPMathOperator>(instruction))
      made->copyFastMathFlags(&instruction);
    made->takeName(&instruction);
    instruction.replaceAllUsesWith(made);
    instruction.eraseFromParent();
  }
}

} // namespace anysl
