//===-- lib/Link/LowerStorage.cpp - gives variables their types ---------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// anysl_alloc(@anysl_type_vector) becomes an alloca of the type of the runtime's variable
// anysl_type_vector: here the abstract types become the runtime's own.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Instructions.h"

using namespace llvm;

namespace anysl::link {
namespace {

CallInst *asCall(User *user, const Function &callee) {
  auto *call = dyn_cast<CallInst>(user);
  return call && call->getCalledFunction() == &callee ? call : nullptr;
}

/// Replaces every call of a structural operator by what `lower` makes of it.
void replaceCalls(Module &module, stc::Op op,
                  function_ref<Value *(IRBuilder<> &, CallInst &)> lower) {
  Function *callee = module.getFunction(info(op).symbol());
  if (!callee)
    return;
  for (User *user : make_early_inc_range(callee->users())) {
    CallInst *call = asCall(user, *callee);
    if (!call)
      continue;
    IRBuilder<> builder(call);
    Value *lowered = lower(builder, *call);
    lowered->takeName(call);
    call->replaceAllUsesWith(lowered);
    call->eraseFromParent();
  }
  if (callee->use_empty())
    callee->eraseFromParent();
}

/// What a variable holds before anything is assigned to it is zero, in every runtime and at every
/// width, rather than what LLVM would make of an undefined value.
Value *allocate(IRBuilder<> &builder, Value *typeSymbol, unsigned length) {
  auto *symbol = cast<GlobalVariable>(typeSymbol);
  Type *type = symbol->getValueType();
  if (length)
    type = ArrayType::get(type, length);
  AllocaInst *slot = builder.CreateAlloca(type);
  slot->setAlignment(std::max(symbol->getAlign().valueOrOne(), slot->getAlign()));
  const DataLayout &layout = symbol->getParent()->getDataLayout();
  builder.CreateMemSet(slot, builder.getInt8(0), layout.getTypeAllocSize(type), slot->getAlign());
  return slot;
}

Value *elementOf(IRBuilder<> &builder, CallInst &call) {
  Value *array = call.getArgOperand(0), *index = call.getArgOperand(3);
  auto *symbol = cast<GlobalVariable>(call.getArgOperand(1));
  auto length = uint32_t(cast<ConstantInt>(call.getArgOperand(2))->getZExtValue());
  index = builder.CreateBinaryIntrinsic(Intrinsic::smax, index, builder.getInt32(0));
  index = builder.CreateBinaryIntrinsic(Intrinsic::smin, index, builder.getInt32(length - 1));
  index = builder.CreateZExt(index, builder.getInt64Ty());
  return builder.CreateInBoundsGEP(symbol->getValueType(), array, index);
}

} // namespace

bool lowerStorage(Session &session) {
  Module &module = *session.module;
  replaceCalls(module, stc::Op::alloc, [](IRBuilder<> &builder, CallInst &call) {
    return allocate(builder, call.getArgOperand(0), 0);
  });
  replaceCalls(module, stc::Op::alloc_array, [](IRBuilder<> &builder, CallInst &call) {
    auto *length = cast<ConstantInt>(call.getArgOperand(1));
    return allocate(builder, call.getArgOperand(0), unsigned(length->getZExtValue()));
  });
  replaceCalls(module, stc::Op::element, elementOf);
  return true;
}

} // namespace anysl::link
