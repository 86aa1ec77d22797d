//===-- lib/Link/ReturnOutputs.cpp - lets services return what they compute ---------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A service's wrapper, which stays a call, gives its results through pointers, because that is what
// widens; so a scalar shader would keep stack slots for nothing but these. Once nothing is to be
// widened any more, a wrapper
//
//   void trace(…, float *r, float *g, float *b)       becomes       {float, float, float} trace(…)
//
// where the pointers serve for results alone: every call hands over slots of its own, and the
// wrapper writes each once at its end.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/Transforms/Utils/Cloning.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// The type of the values that a function writes through an argument, if it does nothing else with
/// it.
Type *outputType(const Argument &argument) {
  Type *type = nullptr;
  if (!argument.getType()->isPointerTy())
    return nullptr;
  for (const User *user : argument.users()) {
    auto *store = dyn_cast<StoreInst>(user);
    if (!store || !store->isSimple() || store->getValueOperand() == &argument)
      return nullptr;
    if (type && type != store->getValueOperand()->getType())
      return nullptr;
    type = store->getValueOperand()->getType();
  }
  return type && type->isSingleValueType() ? type : nullptr;
}

/// Whether a block that ends the function writes through the argument, whatever happens before.
bool isWrittenInBlock(const Argument &argument, const BasicBlock &block) {
  return any_of(argument.users(),
                [&](const User *user) { return cast<Instruction>(user)->getParent() == &block; });
}

bool callsAreSimple(const Function &function) {
  return all_of(function.users(), [&](const User *user) {
    auto *call = dyn_cast<CallInst>(user);
    return call && call->getCalledFunction() == &function && !call->isMustTailCall();
  });
}

/// A wrapper whose outputs are to be returned.
class OutputReturner {
public:
  explicit OutputReturner(Function &function) : function(function) {
    if (function.isDeclaration() || !function.hasLocalLinkage() || function.isVarArg() ||
        !function.getReturnType()->isVoidTy() || !callsAreSimple(function))
      return;
    BasicBlock *end = nullptr;
    for (BasicBlock &block : function)
      if (isa<ReturnInst>(block.getTerminator())) {
        if (end)
          return;
        end = &block;
      }
    if (!end)
      return;
    for (Argument &argument : function.args())
      if (Type *type = outputType(argument))
        if (isWrittenInBlock(argument, *end)) {
          outputs.push_back(argument.getArgNo());
          types.push_back(type);
        }
  }

  void run() {
    if (outputs.empty())
      return;
    Function *returning = makeReturning();
    for (User *user : make_early_inc_range(function.users()))
      replaceCall(*cast<CallInst>(user), *returning);
    returning->takeName(&function);
    function.eraseFromParent();
  }

private:
  bool isOutput(const Argument &argument) const {
    return is_contained(outputs, argument.getArgNo());
  }

  /// A copy whose outputs are slots of its own, returned at its end.
  Function *makeReturning() {
    SmallVector<Type *> params;
    for (Argument &argument : function.args())
      if (!isOutput(argument))
        params.push_back(argument.getType());
    auto *result = StructType::get(function.getContext(), types);
    auto *copy = Function::Create(FunctionType::get(result, params, false),
                                  GlobalValue::InternalLinkage, "", function.getParent());
    ValueToValueMapTy map;
    BasicBlock *entry = BasicBlock::Create(function.getContext(), "entry", copy);
    IRBuilder<> builder(entry);
    SmallVector<AllocaInst *> slots;
    unsigned next = 0;
    for (Argument &argument : function.args()) {
      if (isOutput(argument)) {
        slots.push_back(builder.CreateAlloca(types[slots.size()], nullptr, argument.getName()));
        map[&argument] = slots.back();
      } else {
        copy->getArg(next)->setName(argument.getName());
        map[&argument] = copy->getArg(next++);
      }
    }
    SmallVector<ReturnInst *> returns;
    CloneFunctionInto(copy, &function, map, CloneFunctionChangeType::LocalChangesOnly, returns);
    copy->setAttributes(AttributeList::get(
        function.getContext(), AttributeList::FunctionIndex,
        AttrBuilder(function.getContext(), function.getAttributes().getFnAttrs())));
    copy->removeFnAttr(Attribute::Memory);
    builder.CreateBr(cast<BasicBlock>(map[&function.getEntryBlock()]));
    for (ReturnInst *end : returns) {
      builder.SetInsertPoint(end);
      Value *value = PoisonValue::get(result);
      for (unsigned i = 0; i < slots.size(); ++i)
        value = builder.CreateInsertValue(value, builder.CreateLoad(types[i], slots[i]), i);
      builder.CreateRet(value);
      end->eraseFromParent();
    }
    return copy;
  }

  /// The call's slots take the results after it; they are dissolved when that is all they do.
  void replaceCall(CallInst &call, Function &returning) {
    SmallVector<Value *> operands;
    for (Argument &argument : function.args())
      if (!isOutput(argument))
        operands.push_back(call.getArgOperand(argument.getArgNo()));
    IRBuilder<> builder(&call);
    CallInst *result = builder.CreateCall(&returning, operands);
    for (unsigned i = 0; i < outputs.size(); ++i)
      builder.CreateStore(builder.CreateExtractValue(result, i), call.getArgOperand(outputs[i]));
    call.eraseFromParent();
  }

  Function &function;
  SmallVector<unsigned> outputs; ///< numbers of the arguments that are results
  SmallVector<Type *> types;     ///< of the results
};

} // namespace

void returnOutputs(Module &module) {
  for (Function &function : make_early_inc_range(module))
    OutputReturner(function).run();
}

} // namespace anysl::link
