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
      : real(&type), size(layout.getTypeAllocSize(&type)) {
    while (auto *inner = dyn_cast<StructType>(real)) // derivatives may have derivatives
      real = inner->getElementType(0);
    realSize = layout.getTypeAllocSize(real);
    count = unsigned(size / realSize);
  }
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
      } else if (place.fixed % int64_t(number.realSize) == 0 &&
                 (isNumberAccess(*instruction, address) || clearedReals(*instruction))) {
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

  /// A load or store of one real, or of its bits.
  bool isNumberAccess(const Instruction &instruction, const Value &address) const {
    if (auto *load = dyn_cast<LoadInst>(&instruction))
      return load->isSimple() && layout.getTypeStoreSize(load->getType()) == number.realSize;
    auto *store = dyn_cast<StoreInst>(&instruction);
    return store && store->isSimple() && store->getValueOperand() != &address &&
           layout.getTypeStoreSize(store->getValueOperand()->getType()) == number.realSize;
  }

  /// How many reals an instruction sets to zero, or 0 if that is not what it does. What clears an
  /// array first loses the elements that are stored later, and may shrink to an integer's store.
  uint64_t clearedReals(const Instruction &instruction) const {
    uint64_t length = 0;
    if (auto *clear = dyn_cast<MemSetInst>(&instruction)) {
      auto *bytes = dyn_cast<ConstantInt>(clear->getLength());
      auto *value = dyn_cast<ConstantInt>(clear->getValue());
      length =
          bytes && value && value->isZero() && !clear->isVolatile() ? bytes->getZExtValue() : 0;
    } else if (auto *store = dyn_cast<StoreInst>(&instruction)) {
      auto *value = dyn_cast<Constant>(store->getValueOperand());
      if (store->isSimple() && value && value->isNullValue())
        length = layout.getTypeStoreSize(value->getType());
    }
    return length % number.realSize ? 0 : length / number.realSize;
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
    Align align(number.realSize);
    if (auto *load = dyn_cast<LoadInst>(&access))
      load->replaceAllUsesWith(
          builder.CreateAlignedLoad(load->getType(), realAt(builder, place), align));
    else if (uint64_t reals = clearedReals(access))
      clear(builder, place, reals, align);
    else
      builder.CreateAlignedStore(cast<StoreInst>(access).getValueOperand(), realAt(builder, place),
                                 align);
    access.eraseFromParent();
  }

  /// The address of one real, in the array that has its kind.
  Value *realAt(IRBuilder<> &builder, const Place &place) const {
    auto size = int64_t(number.size);
    auto which = uint64_t((place.fixed % size + size) % size) / number.realSize;
    return elementOf(builder, place, *parts[which]);
  }

  void clear(IRBuilder<> &builder, Place place, uint64_t reals, Align align) {
    // The reals before and behind whole numbers one by one.
    auto real = int64_t(number.realSize);
    for (; reals && (place.fixed % int64_t(number.size) || reals < number.count); --reals) {
      builder.CreateAlignedStore(Constant::getNullValue(number.real), realAt(builder, place),
                                 align);
      place.fixed += real;
    }
    uint64_t whole = reals / number.count;
    if (whole == 0)
      return;
    for (AllocaInst *part : parts)
      builder.CreateMemSet(elementOf(builder, place, *part), builder.getInt8(0),
                           whole * number.realSize, align);
    place.fixed += int64_t(whole * number.size);
    clear(builder, place, reals - whole * number.count, align);
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
  auto &type = *cast<StructType>(module.getNamedGlobal("anysl_type_float")->getValueType());
  if (!type.getElementType(0)->isFloatingPointTy())
    return false; // numbers that never become registers
  Number number(type, layout);
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
