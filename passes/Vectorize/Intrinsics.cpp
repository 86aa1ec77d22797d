//===-- passes/Vectorize/Intrinsics.cpp - what is known of LLVM's intrinsics ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Intrinsics.h"

#include "llvm/Analysis/VectorUtils.h"
#include "llvm/IR/IntrinsicInst.h"

using namespace llvm;

namespace anysl {

bool worksOnLanes(Intrinsic::ID id) {
  if (isTriviallyVectorizable(id))
    return true;
  // Besides LLVM's list of trivially vectorisable ones:
  switch (id) {
  case Intrinsic::sadd_with_overflow:
  case Intrinsic::uadd_with_overflow:
  case Intrinsic::ssub_with_overflow:
  case Intrinsic::usub_with_overflow:
  case Intrinsic::smul_with_overflow:
  case Intrinsic::umul_with_overflow:
  case Intrinsic::is_fpclass:
  case Intrinsic::experimental_constrained_fadd:
  case Intrinsic::experimental_constrained_fsub:
  case Intrinsic::experimental_constrained_fmul:
  case Intrinsic::experimental_constrained_fdiv:
  case Intrinsic::experimental_constrained_fma:
  case Intrinsic::experimental_constrained_fmuladd:
  case Intrinsic::experimental_constrained_fptosi:
  case Intrinsic::experimental_constrained_fptoui:
  case Intrinsic::experimental_constrained_sitofp:
  case Intrinsic::experimental_constrained_uitofp:
  case Intrinsic::experimental_constrained_fptrunc:
  case Intrinsic::experimental_constrained_fpext:
  case Intrinsic::experimental_constrained_fcmp:
  case Intrinsic::experimental_constrained_fcmps:
  case Intrinsic::experimental_constrained_sqrt:
  case Intrinsic::experimental_constrained_ceil:
  case Intrinsic::experimental_constrained_floor:
  case Intrinsic::experimental_constrained_trunc:
  case Intrinsic::experimental_constrained_rint:
  case Intrinsic::experimental_constrained_nearbyint:
  case Intrinsic::experimental_constrained_roundeven:
    return true;
  default:
    return false;
  }
}

StringRef mathFunctionOf(Intrinsic::ID id) {
  switch (id) {
#define MATH_INTRINSIC(name)                                                                       \
  case Intrinsic::name:                                                                            \
    return #name;
    MATH_INTRINSIC(sin)
    MATH_INTRINSIC(cos)
    MATH_INTRINSIC(tan)
    MATH_INTRINSIC(asin)
    MATH_INTRINSIC(acos)
    MATH_INTRINSIC(atan)
    MATH_INTRINSIC(sinh)
    MATH_INTRINSIC(cosh)
    MATH_INTRINSIC(tanh)
    MATH_INTRINSIC(exp)
    MATH_INTRINSIC(exp2)
    MATH_INTRINSIC(exp10)
    MATH_INTRINSIC(log)
    MATH_INTRINSIC(log2)
    MATH_INTRINSIC(log10)
    MATH_INTRINSIC(pow)
    MATH_INTRINSIC(powi)
    MATH_INTRINSIC(ldexp)
#undef MATH_INTRINSIC
  default:
    return {};
  }
}

bool callsMathLibrary(const Instruction &instruction) {
  if (const auto *intrinsic = dyn_cast<IntrinsicInst>(&instruction))
    return !mathFunctionOf(intrinsic->getIntrinsicID()).empty();
  return instruction.getOpcode() == Instruction::FRem;
}

CallInst *callIntrinsic(IRBuilderBase &builder, Intrinsic::ID id, Type *result,
                        ArrayRef<Value *> arguments) {
  // Which types the intrinsic's name carries follows from its declaration.
  SmallVector<Intrinsic::IITDescriptor, 8> table;
  Intrinsic::getIntrinsicInfoTableEntries(id, table);
  SmallVector<Type *, 4> types, overloaded;
  for (Value *argument : arguments)
    types.push_back(argument->getType());
  ArrayRef<Intrinsic::IITDescriptor> rest = table;
  if (Intrinsic::matchIntrinsicSignature(FunctionType::get(result, types, false), rest,
                                         overloaded) != Intrinsic::MatchIntrinsicTypes_Match)
    return nullptr;
  Module *module = builder.GetInsertBlock()->getModule();
  return builder.CreateCall(Intrinsic::getDeclaration(module, id, overloaded), arguments);
}

} // namespace anysl
