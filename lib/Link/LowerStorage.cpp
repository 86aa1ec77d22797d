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
#include "llvm/ADT/MapVector.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Analysis/CycleAnalysis.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Instructions.h"

using namespace llvm;

namespace anysl::link {
namespace {

CallInst *asCall(User *user, const Function &callee) {
  auto *call = dyn_cast<CallInst>(user);
  return call && call->getCalledFunction() == &callee ? call : nullptr;
}

void replace(CallInst &call, Value *lowered) {
  lowered->takeName(&call);
  call.replaceAllUsesWith(lowered);
  call.eraseFromParent();
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
    replace(*call, lower(builder, *call));
  }
  if (callee->use_empty())
    callee->eraseFromParent();
}

/// Where the slots of a function begin to be used.
///
/// A value set at the function's start lives until the last use, and making values of slots (SROA)
/// visits, for each slot, every block that its first value reaches: far too much for a shader with
/// thousands of slots and blocks. Most slots, those of intermediate results, are written and read
/// in one block, though.
class FirstUses {
public:
  explicit FirstUses(Function &function) : dominators(function) { cycles.compute(function); }

  /// The instruction before which `slot` may be given its first value: it comes before every use,
  /// and nothing that is in the slot when it is reached again is read. The slot itself if there is
  /// no better one.
  Instruction *of(CallInst &slot) {
    BasicBlock *block = nullptr;
    for (User *user : slot.users()) {
      BasicBlock *used = cast<Instruction>(user)->getParent();
      block = block ? dominators.findNearestCommonDominator(block, used) : used;
    }
    if (!block || block == slot.getParent())
      return &slot;
    Instruction *first = firstUse(*block, slot);
    if (first && overwrites(*first, slot))
      return first;
    // In a loop, a use may want the value that an earlier round has left.
    while (cycles.getCycle(block))
      block = dominators.getNode(block)->getIDom()->getBlock();
    if (block == slot.getParent())
      return &slot;
    first = firstUse(*block, slot);
    return first ? first : block->getTerminator();
  }

private:
  static Instruction *firstUse(BasicBlock &block, CallInst &slot) {
    Instruction *first = nullptr;
    for (User *user : slot.users()) {
      auto *use = cast<Instruction>(user);
      if (use->getParent() == &block && (!first || use->comesBefore(first)))
        first = use;
    }
    return first;
  }

  /// Whether the instruction is a call of an operator or function that gives the slot a value and
  /// does not look at what was in it.
  static bool overwrites(Instruction &use, CallInst &slot) {
    auto *call = dyn_cast<CallInst>(&use);
    Function *callee = call ? call->getCalledFunction() : nullptr;
    auto params = callee ? stc::signatureOf(*callee) : std::nullopt;
    return params && params->size() == call->arg_size() &&
           all_of(zip(*params, call->args()), [&](auto pair) {
             auto &[param, argument] = pair;
             return argument.get() != &slot || param.kind == stc::ParamKind::Out;
           });
  }

  DominatorTree dominators;
  CycleInfo cycles;
};

/// How many numbers and addresses a value of the type is made of; nothing if also of other things,
/// as where a number is a text of bits.
std::optional<uint64_t> scalarsIn(Type *type) {
  if (auto *array = dyn_cast<ArrayType>(type)) {
    auto each = scalarsIn(array->getElementType());
    return each ? std::optional(array->getNumElements() * *each) : std::nullopt;
  }
  auto *structure = dyn_cast<StructType>(type);
  if (!structure)
    return type->isFloatingPointTy() || type->isPointerTy() ? std::optional(1) : std::nullopt;
  uint64_t count = 0;
  for (Type *element : structure->elements()) {
    auto its = scalarsIn(element);
    if (!its)
      return std::nullopt;
    count += *its;
  }
  return count;
}

/// Sets a variable to zero. SROA reads what a slot held before where a `memset` covers it, and with
/// that makes it live all the way from the function's start; of a store it knows better. What never
/// becomes values in registers, or too many, is left a `memset`.
void setZero(IRBuilder<> &builder, AllocaInst &slot) {
  Type *type = slot.getAllocatedType();
  if (scalarsIn(type).value_or(~uint64_t(0)) <= 256) {
    builder.CreateAlignedStore(Constant::getNullValue(type), &slot, slot.getAlign());
    return;
  }
  uint64_t size = slot.getDataLayout().getTypeAllocSize(type);
  builder.CreateMemSet(&slot, builder.getInt8(0), size, slot.getAlign());
}

/// What a variable holds before anything is assigned to it is zero, in every runtime and at every
/// width, rather than what LLVM would make of an undefined value.
AllocaInst *allocate(CallInst &call, unsigned length, Instruction *firstUse) {
  IRBuilder<> builder(&call);
  auto *symbol = cast<GlobalVariable>(call.getArgOperand(0));
  Type *type = symbol->getValueType();
  if (length)
    type = ArrayType::get(type, length);
  AllocaInst *slot = builder.CreateAlloca(type);
  slot->setAlignment(std::max(symbol->getAlign().valueOrOne(), slot->getAlign()));
  builder.SetInsertPoint(firstUse);
  builder.SetCurrentDebugLocation(call.getDebugLoc());
  setZero(builder, *slot);
  return slot;
}

/// Replaces the calls of an operator that makes slots; `lengthOf` says how many there are, 0 for
/// one that is no array.
void replaceSlots(Module &module, stc::Op op, function_ref<unsigned(CallInst &)> lengthOf) {
  Function *callee = module.getFunction(info(op).symbol());
  if (!callee)
    return;
  // All are looked for before anything is inserted, which would let LLVM count instructions anew.
  MapVector<Function *, SmallVector<std::pair<CallInst *, Instruction *>>> slots;
  for (User *user : callee->users())
    if (CallInst *call = asCall(user, *callee))
      slots[call->getFunction()].emplace_back(call, nullptr);
  for (auto &[function, calls] : slots) {
    FirstUses firstUses(*function);
    for (auto &[call, firstUse] : calls)
      firstUse = firstUses.of(*call);
    for (auto &[call, firstUse] : calls)
      replace(*call, allocate(*call, lengthOf(*call), firstUse));
  }
  if (callee->use_empty())
    callee->eraseFromParent();
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
  replaceSlots(module, stc::Op::alloc, [](CallInst &) { return 0u; });
  replaceSlots(module, stc::Op::alloc_array, [](CallInst &call) {
    return unsigned(cast<ConstantInt>(call.getArgOperand(1))->getZExtValue());
  });
  replaceCalls(module, stc::Op::element, elementOf);
  return true;
}

} // namespace anysl::link
