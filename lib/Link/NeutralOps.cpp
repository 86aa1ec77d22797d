//===-- lib/Link/NeutralOps.cpp - stands in for operators that a renderer declines --*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/NeutralOps.h"

#include "lib/STC/Builder.h"

using namespace llvm;

namespace anysl::link {

using stc::Op;

StringRef neutralMeaning(stc::Op op) {
  switch (op) {
#define STC_NEUTRAL(name, value, meaning)                                                          \
  case Op::name:                                                                                   \
    return meaning;
#include "lib/STC/Neutral.def"
  default:
    return {};
  }
}

/// Defines the operator over the abstract types, so that it fits every real.
static void define(stc::Builder &builder, Op op, double value) {
  Function *function = builder.beginOperator(op);
  Value *number = builder.alloc(stc::Type::floatTy, "neutral", stc::Storage::Uniform);
  builder.call(Op::const_float, {number, builder.number(value)});
  for (auto [param, argument] : zip_equal(stc::info(op).params, function->args())) {
    if (param.kind != stc::ParamKind::Out)
      continue;
    switch (param.type) {
    case stc::Type::floatTy:
      builder.call(Op::copy_float, {&argument, number});
      break;
    case stc::Type::colorTy:
      builder.call(Op::splat_color, {&argument, number});
      break;
    case stc::Type::matrixTy:
      builder.call(Op::splat_matrix, {&argument, number});
      break;
    case stc::Type::stringTy:
      builder.call(Op::const_string, {&argument, builder.text("")});
      break;
    default:
      builder.call(Op::splat_vector, {&argument, number});
    }
  }
  if (function->getReturnType()->isVoidTy())
    builder.ir().CreateRetVoid();
  else
    builder.ir().CreateRet(Constant::getNullValue(function->getReturnType()));
}

std::unique_ptr<Module> makeNeutralOps(LLVMContext &context) {
  stc::Builder builder(context, "neutral", "anysl-link " ANYSL_VERSION);
  builder.setLocation("neutral", 1, 1);
#define STC_NEUTRAL(name, value, meaning) define(builder, Op::name, value);
#include "lib/STC/Neutral.def"
  return builder.finish();
}

std::unique_ptr<Module> makeUnneededOps(LLVMContext &context, ArrayRef<stc::Op> ops) {
  if (ops.empty())
    return nullptr;
  stc::Builder builder(context, "unneeded", "anysl-link " ANYSL_VERSION);
  builder.setLocation("unneeded", 1, 1);
  for (stc::Op op : ops)
    define(builder, op, 0);
  return builder.finish();
}

} // namespace anysl::link
