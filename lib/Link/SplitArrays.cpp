//===-- lib/Link/SplitArrays.cpp - arrays of numbers with derivatives ---------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A variable is dissolved into values of its own, and derivatives that nobody reads are gone with
// them. An array whose index is computed stays in memory, where values and derivatives lie one
// after the other, so that all of them count as read. Here such an array becomes one array for
// each:
//
//   [4 x {float, float, float}]       becomes       3 x [4 x float]
//
// All accesses have to be loads and stores of single numbers at addresses that tell which of the
// three they mean.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/ADT/MapVector.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Operator.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// The number with derivatives: so many reals of that type.
struct Number {
  Type *real;
  unsigned count;
  uint64_t realSize, size;

  Number(StructType &type, const DataLayout &layout)
      : real(type.getElementType(0)), count(type.getNumElements()),
        realSize(layout.getTypeAllocSize(real)), size(layout.getTypeAllocSize(&type)) {}
};

/// An address in the array: what is added to its start, in bytes.
struct Place {
  SmallMapVector<Value *, int64_t, 4> scaled; ///< times a factor
  int64_t fixed = 0;
};

class ArraySplitter {
public:
  ArraySplitter(AllocaInst &array, const Number &number)
      : array(array), number(number), layout(array.getModule()->getDataLayout()) {}

  bool run() {
    uint64_t size = array.getAllocationSize(layout).value_or(TypeSize::getFixed(0));
    if (size == 0 || size % number.size || !collect(array, Place()))
      return false;
    IRBuilder<> builder(&array);
    Type *part = ArrayType::get(number.real, size / number.size);
    for (unsigned i = 0; i < number.count; ++i)
      parts.push_back(builder.CreateAlloca(part, nullptr, array.getName()));
    for (auto &[access, place] : accesses)
      replace(*access, place);
    for (Instruction *instruction : dead)
      instruction->eraseFromParent();
    array.eraseFromParent();
    return true;
  }

private:
  /// Collects what is done with an address; false if something cannot be split.
  bool collect(Instruction &address, const Place &place) {
    for (User *user : address.users()) {
      auto *instruction = cast<Instruction>(user);
      if (auto *step = dyn_cast<GetElementPtrInst>(user)) {
        Place further = place;
        if (!add(*step, further) || !collect(*step, further))
          return false;
        dead.push_back(step);
      } else if ((isNumberAccess(*instruction, address) &&
                  place.fixed % int64_t(number.realSize) == 0) ||
                 isWholeClear(*instruction, place)) {
        accesses.push_back({instruction, place});
      } else if (instruction->isLifetimeStartOrEnd()) {
        dead.push_back(instruction);
      } else {
        return false;
      }
    }
    return true;
  }

  /// Adds the offset of an address computation, if it moves by whole numbers wherever it is
  /// variable.
  bool add(GetElementPtrInst &step, Place &place) const {
    MapVector<Value *, APInt> variable;
    APInt fixed(64, 0);
    if (!cast<GEPOperator>(step).collectOffset(layout, 64, variable, fixed))
      return false;
    place.fixed += fixed.getSExtValue();
    for (auto &[index, scale] : variable) {
      if (scale.getSExtValue() % int64_t(number.size))
        return false;
      place.scaled[index] += scale.getSExtValue();
    }
    return true;
  }

  bool isNumberAccess(const Instruction &instruction, const Value &address) const {
    if (auto *load = dyn_cast<LoadInst>(&instruction))
      return load->isSimple() && load->getType() == number.real;
    auto *store = dyn_cast<StoreInst>(&instruction);
    return store && store->isSimple() && store->getValueOperand() != &address &&
           store->getValueOperand()->getType() == number.real;
  }

  /// Storing zeros into some whole numbers.
  bool isWholeClear(const Instruction &instruction, const Place &place) const {
    auto *clear = dyn_cast<MemSetInst>(&instruction);
    auto *length = clear ? dyn_cast<ConstantInt>(clear->getLength()) : nullptr;
    auto *value = clear ? dyn_cast<ConstantInt>(clear->getValue()) : nullptr;
    return length && value && value->isZero() && !clear->isVolatile() &&
           length->getZExtValue() % number.size == 0 && place.fixed % int64_t(number.size) == 0;
  }

  /// The address of the same element in one of the new arrays.
  Value *elementOf(IRBuilder<> &builder, const Place &place, AllocaInst &part) const {
    auto size = int64_t(number.size);
    int64_t element = place.fixed / size - (place.fixed % size < 0);
    Value *index = builder.getInt64(uint64_t(element));
    for (auto &[variable, scale] : place.scaled) {
      Value *wide = builder.CreateSExtOrTrunc(variable, builder.getInt64Ty());
      index = builder.CreateAdd(index, builder.CreateMul(wide, builder.getInt64(scale / size)));
    }
    return builder.CreateInBoundsGEP(number.real, &part, index);
  }

  void replace(Instruction &access, const Place &place) {
    IRBuilder<> builder(&access);
    auto size = int64_t(number.size);
    auto which = uint64_t((place.fixed % size + size) % size) / number.realSize;
    Align align(number.realSize);
    if (auto *load = dyn_cast<LoadInst>(&access)) {
      Value *from = elementOf(builder, place, *parts[which]);
      Value *value = builder.CreateAlignedLoad(number.real, from, align);
      load->replaceAllUsesWith(value);
    } else if (auto *store = dyn_cast<StoreInst>(&access)) {
      Value *to = elementOf(builder, place, *parts[which]);
      builder.CreateAlignedStore(store->getValueOperand(), to, align);
    } else {
      uint64_t length = cast<ConstantInt>(cast<MemSetInst>(access).getLength())->getZExtValue();
      for (AllocaInst *part : parts)
        builder.CreateMemSet(elementOf(builder, place, *part), builder.getInt8(0),
                             length / number.count, align);
    }
    access.eraseFromParent();
  }

  AllocaInst &array;
  const Number &number;
  const DataLayout &layout;
  SmallVector<AllocaInst *> parts;
  std::vector<std::pair<Instruction *, Place>> accesses;
  /// Address computations, each behind those that build upon it.
  SmallVector<Instruction *> dead;
};

} // namespace

bool splitArrays(Module &module) {
  const DataLayout &layout = module.getDataLayout();
  Number number(*cast<StructType>(module.getNamedGlobal("anysl_type_float")->getValueType()),
                layout);
  SmallVector<AllocaInst *> arrays;
  for (Function &function : module)
    for (Instruction &instruction : instructions(function))
      if (auto *array = dyn_cast<AllocaInst>(&instruction))
        arrays.push_back(array);
  bool changed = false;
  for (AllocaInst *array : arrays)
    changed |= ArraySplitter(*array, number).run();
  return changed;
}

} // namespace anysl::link
