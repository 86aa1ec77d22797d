//===-- passes/Vectorize/WidenMemory.cpp - widen what touches memory --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/PrivateArrays.h"
#include "passes/Vectorize/Widener.h"

#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Operator.h"

using namespace llvm;

namespace anysl {

Widener::Address Widener::addressOf(Value *pointer) {
  Address address;
  address.shape = shapeOf(pointer);
  if (address.shape.isStrided())
    address.base = base(pointer);
  else
    address.lanes = vector(pointer);
  return address;
}

Widener::Address Widener::offset(const Address &address, uint64_t bytes) {
  if (bytes == 0)
    return address;
  Address moved = address;
  Value *&pointer = address.base ? moved.base : moved.lanes;
  moved.shape =
      address.shape.aligned(std::min<unsigned>(address.shape.zeros(), countr_zero(bytes)));
  pointer = builder.CreateGEP(builder.getInt8Ty(), pointer, builder.getInt64(bytes));
  return moved;
}

Value *Widener::lanePointers(const Address &address) {
  if (address.lanes)
    return address.lanes;
  return address.shape.isUniform() ? broadcast(address.base)
                                   : addStride(address.base, address.shape.stride());
}

/// Whether consecutive values lie in memory as the lanes of a vector do.
bool Widener::isLaneSized(Type *type) const {
  if (!type->isIntegerTy() && !type->isFloatingPointTy() && !type->isPointerTy())
    return false;
  uint64_t bits = layout.getTypeSizeInBits(type);
  return bits >= 8 && bits <= 64 && isPowerOf2_64(bits);
}

/// The alignment of consecutive lanes of \p size bytes, of which each has \p align.
Align Widener::alignOfLanes(const Shape &shape, Align align, int64_t size) const {
  align = std::min(align, Align(size));
  // Where no lane may be active, what is known of lane 0 may not hold.
  if (!isFull() && !isOccupied())
    return align;
  Align first(uint64_t(1) << shape.zeros());
  if (shape.stride() < 0)
    first = commonAlignment(first, size * (width - 1));
  return std::max(align, first);
}

Value *Widener::load(Type *type, const Address &address, Align align, Instruction &origin) {
  // Structures and arrays: each scalar inside by itself.
  if (type->isAggregateType()) {
    Value *result = PoisonValue::get(wide(type));
    bool isArray = type->isArrayTy();
    unsigned count = isArray ? type->getArrayNumElements() : type->getStructNumElements();
    for (unsigned i = 0; i < count; ++i) {
      Type *element = isArray ? type->getArrayElementType() : type->getStructElementType(i);
      uint64_t at = isArray ? i * layout.getTypeAllocSize(element).getFixedValue()
                            : layout.getStructLayout(cast<StructType>(type))->getElementOffset(i);
      Value *part = load(element, offset(address, at), commonAlignment(align, at), origin);
      result = builder.CreateInsertValue(result, part, i);
    }
    return result;
  }
  if (type->isVectorTy()) {
    Type *element = cast<FixedVectorType>(type)->getElementType();
    uint64_t size = layout.getTypeStoreSize(element);
    Value *result = PoisonValue::get(wide(type));
    for (unsigned i = 0; i < cast<FixedVectorType>(type)->getNumElements(); ++i)
      result = builder.CreateInsertValue(
          result,
          load(element, offset(address, i * size), commonAlignment(align, i * size), origin), i);
    return result;
  }
  // A narrow integer lies in a byte.
  if (type->isIntegerTy() && type->getIntegerBitWidth() < 8)
    return builder.CreateTrunc(load(builder.getInt8Ty(), address, align, origin), wide(type));

  // Idle lanes read 0, as the processors' masked loads have it: what happened to be in a register
  // might be infinite, and raise a flag that no active lane raises.
  Type *lanes = wide(type);
  Value *nothing = Constant::getNullValue(lanes);
  int64_t size = layout.getTypeStoreSize(type).getFixedValue();
  Value *mask = currentMask();
  if (address.shape.isStrided() && std::abs(address.shape.stride()) == size) {
    bool backwards = address.shape.stride() < 0;
    align = alignOfLanes(address.shape, align, size);
    Value *first = address.base;
    SmallVector<int, 32> reversed;
    for (unsigned lane = 0; lane < width; ++lane)
      reversed.push_back(width - 1 - lane);
    if (backwards) {
      first = builder.CreateGEP(builder.getInt8Ty(), first, builder.getInt64(-size * (width - 1)));
      if (!isFull())
        mask = builder.CreateShuffleVector(mask, reversed);
    }
    Instruction *loaded = isFull() ? (Instruction *)builder.CreateAlignedLoad(lanes, first, align)
                                   : builder.CreateMaskedLoad(lanes, first, align, mask, nothing);
    loaded->copyMetadata(
        origin, {LLVMContext::MD_tbaa, LLVMContext::MD_alias_scope, LLVMContext::MD_noalias});
    return backwards ? builder.CreateShuffleVector(loaded, reversed) : loaded;
  }
  remark(VectorizeRemark::Kind::Gather, origin, "loads from an unrelated address in each lane");
  CallInst *gathered =
      builder.CreateMaskedGather(lanes, lanePointers(address), align, mask, nothing);
  gathered->copyMetadata(
      origin, {LLVMContext::MD_tbaa, LLVMContext::MD_alias_scope, LLVMContext::MD_noalias});
  return gathered;
}

void Widener::store(Value *value, Type *type, const Address &address, Align align,
                    Instruction &origin) {
  if (type->isAggregateType() || type->isVectorTy()) {
    bool isStruct = type->isStructTy();
    Type *same = type->isArrayTy()    ? type->getArrayElementType()
                 : type->isVectorTy() ? cast<FixedVectorType>(type)->getElementType()
                                      : nullptr;
    unsigned count = isStruct            ? type->getStructNumElements()
                     : type->isArrayTy() ? type->getArrayNumElements()
                                         : cast<FixedVectorType>(type)->getNumElements();
    for (unsigned i = 0; i < count; ++i) {
      Type *element = isStruct ? type->getStructElementType(i) : same;
      uint64_t at = isStruct ? layout.getStructLayout(cast<StructType>(type))->getElementOffset(i)
                             : i * layout.getTypeAllocSize(element).getFixedValue();
      store(builder.CreateExtractValue(value, i), element, offset(address, at),
            commonAlignment(align, at), origin);
    }
    return;
  }
  if (type->isIntegerTy() && type->getIntegerBitWidth() < 8)
    return store(builder.CreateZExt(value, wide(builder.getInt8Ty())), builder.getInt8Ty(), address,
                 align, origin);

  int64_t size = layout.getTypeStoreSize(type).getFixedValue();
  Value *mask = currentMask();
  if (address.shape.isStrided() && std::abs(address.shape.stride()) == size) {
    Value *first = address.base;
    align = alignOfLanes(address.shape, align, size);
    if (address.shape.stride() < 0) {
      SmallVector<int, 32> reversed;
      for (unsigned lane = 0; lane < width; ++lane)
        reversed.push_back(width - 1 - lane);
      first = builder.CreateGEP(builder.getInt8Ty(), first, builder.getInt64(-size * (width - 1)));
      value = builder.CreateShuffleVector(value, reversed);
      if (!isFull())
        mask = builder.CreateShuffleVector(mask, reversed);
    }
    Instruction *stored = isFull() ? (Instruction *)builder.CreateAlignedStore(value, first, align)
                                   : builder.CreateMaskedStore(value, first, align, mask);
    stored->copyMetadata(
        origin, {LLVMContext::MD_tbaa, LLVMContext::MD_alias_scope, LLVMContext::MD_noalias});
    return;
  }
  remark(VectorizeRemark::Kind::Gather, origin, "stores to an unrelated address in each lane");
  // Lanes that share an address are written in order, as one after the other would.
  CallInst *scattered = builder.CreateMaskedScatter(value, lanePointers(address), align, mask);
  scattered->copyMetadata(
      origin, {LLVMContext::MD_tbaa, LLVMContext::MD_alias_scope, LLVMContext::MD_noalias});
}

/// Whether load() and store() can take the type apart into values that have a place of their own.
static bool isSimpleInMemory(Type *type, function_ref<bool(Type *)> isLaneSized) {
  if (auto *structure = dyn_cast<StructType>(type))
    return all_of(structure->elements(),
                  [&](Type *element) { return isSimpleInMemory(element, isLaneSized); });
  if (auto *array = dyn_cast<ArrayType>(type))
    return isSimpleInMemory(array->getElementType(), isLaneSized);
  if (auto *vector = dyn_cast<FixedVectorType>(type))
    return isLaneSized(vector->getElementType());
  return isLaneSized(type) || (type->isIntegerTy() && type->getIntegerBitWidth() < 8);
}

void Widener::widenLoad(LoadInst &instruction) {
  if (shapeOf(&instruction).isUniform())
    return copyScalar(instruction);
  auto laneSized = [this](Type *type) { return isLaneSized(type); };
  if (!instruction.isSimple() || !isSimpleInMemory(instruction.getType(), laneSized))
    return replicate(instruction);
  define(instruction, load(instruction.getType(), addressOf(instruction.getPointerOperand()),
                           instruction.getAlign(), instruction));
}

void Widener::widenStore(StoreInst &instruction) {
  Value *value = instruction.getValueOperand();
  Value *pointer = instruction.getPointerOperand();
  Type *type = value->getType();
  auto laneSized = [this](Type *type) { return isLaneSized(type); };
  if (!instruction.isSimple())
    return replicate(instruction);
  if (shapeOf(pointer).isUniform()) {
    if (shapeOf(value).isUniform())
      return copyScalar(instruction);
    // All lanes write the same place; one after the other, the last would stay.
    Value *last = extractLane(vector(value), type, lastActiveLane());
    auto *stored = builder.CreateAlignedStore(last, base(pointer), instruction.getAlign());
    stored->copyMetadata(
        instruction, {LLVMContext::MD_tbaa, LLVMContext::MD_alias_scope, LLVMContext::MD_noalias});
    return;
  }
  if (!isSimpleInMemory(type, laneSized))
    return replicate(instruction);
  store(vector(value), type, addressOf(pointer), instruction.getAlign(), instruction);
}

void Widener::widenAlloca(AllocaInst &instruction) {
  // Each lane has its own copy, one after the other, unless elements lie side by side.
  Type *type = instruction.getAllocatedType();
  Shape count = shapeOf(instruction.getArraySize());
  if (shapeOf(&instruction).isStrided()) {
    IRBuilder<> start(variablesEnd);
    bool isStatic = instruction.isStaticAlloca();
    IRBuilder<> &where = isStatic ? start : builder;
    AllocaInst *copies =
        interleavedElementSize(instruction)
            ? where.CreateAlloca(type, instruction.getAddressSpace())
            : where.CreateAlloca(
                  ArrayType::get(builder.getInt8Ty(), shapeOf(&instruction).stride()),
                  instruction.getAddressSpace(), where.getInt32(width));
    copies->setAlignment(instruction.getAlign());
    return define(instruction, copies);
  }
  // A number of elements that is known only when it runs: room for the largest of all active lanes.
  Value *size;
  if (count.isUniform()) {
    size = base(instruction.getArraySize());
  } else {
    Value *lanes = vector(instruction.getArraySize());
    Value *none = Constant::getNullValue(lanes->getType());
    size = builder.CreateIntMaxReduce(builder.CreateSelect(currentMask(), lanes, none), false);
  }
  if (!isOccupied())
    size =
        builder.CreateSelect(anyLane(currentMask()), size, Constant::getNullValue(size->getType()));
  size = builder.CreateZExtOrTrunc(size, builder.getInt64Ty());
  AllocaInst *copies = builder.CreateAlloca(type, instruction.getAddressSpace(),
                                            builder.CreateMul(size, builder.getInt64(width)));
  copies->setAlignment(instruction.getAlign());
  SmallVector<Constant *, 32> lanes;
  for (unsigned lane = 0; lane < width; ++lane)
    lanes.push_back(builder.getInt64(lane));
  Value *index =
      builder.CreateMul(builder.CreateVectorSplat(width, size), ConstantVector::get(lanes));
  define(instruction, builder.CreateGEP(type, copies, index));
}

void Widener::widenGep(GetElementPtrInst &instruction) {
  // What is the same for all lanes stays scalar: base plus vector of offsets is a gather's best
  // form.
  auto part = [&](Value *operand) {
    return shapeOf(operand).isUniform() ? base(operand) : vector(operand);
  };
  Value *pointer = part(instruction.getPointerOperand());
  SmallVector<Value *, 4> indices;
  for (Value *index : instruction.indices())
    indices.push_back(part(index));
  define(instruction, builder.CreateGEP(instruction.getSourceElementType(), pointer, indices, "",
                                        instruction.isInBounds()));
}

} // namespace anysl
