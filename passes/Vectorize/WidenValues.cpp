//===-- passes/Vectorize/WidenValues.cpp - widen instructions that compute --------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Lanes that are not active may hold anything, poison included. That is harmless in everything that
// computes lane by lane, so such instructions run for all lanes and need no mask; division of
// integers is the exception, as it traps.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Intrinsics.h"
#include "passes/Vectorize/Widener.h"

#include "llvm/Analysis/ValueTracking.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/PatternMatch.h"

using namespace llvm;

namespace anysl {

void Widener::widen(Instruction &instruction) {
  if (auto *call = dyn_cast<CallInst>(&instruction))
    return widenCall(*call);
  if (auto *load = dyn_cast<LoadInst>(&instruction))
    return widenLoad(*load);
  if (auto *store = dyn_cast<StoreInst>(&instruction))
    return widenStore(*store);
  if (auto *alloca = dyn_cast<AllocaInst>(&instruction))
    return widenAlloca(*alloca);
  if (isa<FenceInst>(instruction) || shapeOf(&instruction).isStrided())
    return copyScalar(instruction);
  if (auto *gep = dyn_cast<GetElementPtrInst>(&instruction))
    return widenGep(*gep);
  if (auto *op = dyn_cast<BinaryOperator>(&instruction))
    return widenBinary(*op);
  if (auto *cast = dyn_cast<CastInst>(&instruction))
    return widenCast(*cast);
  if (auto *select = dyn_cast<SelectInst>(&instruction))
    return widenSelect(*select);

  SmallVector<Value *, 4> operands;
  switch (instruction.getOpcode()) {
  case Instruction::FNeg:
  case Instruction::ICmp:
  case Instruction::FCmp:
  case Instruction::Freeze:
    for (Value *operand : instruction.operand_values())
      operands.push_back(vector(operand));
    break;
  case Instruction::ExtractValue: {
    auto &extract = cast<ExtractValueInst>(instruction);
    return define(instruction, builder.CreateExtractValue(vector(extract.getAggregateOperand()),
                                                          extract.getIndices()));
  }
  case Instruction::InsertValue: {
    auto &insert = cast<InsertValueInst>(instruction);
    return define(instruction, builder.CreateInsertValue(vector(insert.getAggregateOperand()),
                                                         vector(insert.getInsertedValueOperand()),
                                                         insert.getIndices()));
  }
  case Instruction::ExtractElement: {
    // A vector per lane is widened to an array of vectors, one an element.
    auto &extract = cast<ExtractElementInst>(instruction);
    if (auto *index = dyn_cast<ConstantInt>(extract.getIndexOperand()))
      if (index->getValue().ult(
              cast<FixedVectorType>(extract.getVectorOperandType())->getNumElements()))
        return define(instruction, builder.CreateExtractValue(vector(extract.getVectorOperand()),
                                                              unsigned(index->getZExtValue())));
    return replicate(instruction);
  }
  case Instruction::InsertElement: {
    if (auto *index = dyn_cast<ConstantInt>(instruction.getOperand(2)))
      if (index->getValue().ult(cast<FixedVectorType>(instruction.getType())->getNumElements()))
        return define(instruction, builder.CreateInsertValue(vector(instruction.getOperand(0)),
                                                             vector(instruction.getOperand(1)),
                                                             unsigned(index->getZExtValue())));
    return replicate(instruction);
  }
  case Instruction::ShuffleVector: {
    auto &shuffle = cast<ShuffleVectorInst>(instruction);
    auto *source = dyn_cast<FixedVectorType>(shuffle.getOperand(0)->getType());
    int count = source->getNumElements();
    Value *parts[2] = {vector(shuffle.getOperand(0)), vector(shuffle.getOperand(1))};
    Value *result = PoisonValue::get(wide(shuffle.getType()));
    for (auto [i, from] : enumerate(shuffle.getShuffleMask()))
      if (from >= 0)
        result = builder.CreateInsertValue(
            result, builder.CreateExtractValue(parts[from / count], unsigned(from % count)),
            unsigned(i));
    return define(instruction, result);
  }
  default:
    // Atomic operations and whatever else there is.
    return replicate(instruction);
  }

  Value *result =
      mapLeaves(instruction.getType(), operands, [&](ArrayRef<Value *> leaves) -> Value * {
        Value *leaf = nullptr;
        switch (instruction.getOpcode()) {
        case Instruction::FNeg:
          leaf = builder.CreateFNeg(leaves[0]);
          break;
        case Instruction::ICmp:
          return builder.CreateICmp(cast<CmpInst>(instruction).getPredicate(), leaves[0],
                                    leaves[1]);
        case Instruction::FCmp:
          leaf =
              builder.CreateFCmp(cast<CmpInst>(instruction).getPredicate(), leaves[0], leaves[1]);
          break;
        default:
          return builder.CreateFreeze(leaves[0]);
        }
        copyFlags(leaf, instruction);
        return leaf;
      });
  define(instruction, result);
}

/// A value that is the same for all lanes, or that the lanes' values follow from.
/// Lane 0's value, extended. If lane 0 is idle it may wrap where no active lane does, and the
/// others would follow from a wrong value; so it is computed in the wider type from what cannot
/// wrap.
Value *Widener::extendedBase(CastInst::CastOps extension, Value *value, Type *type) {
  Shape shape = shapeOf(value);
  bool isExact = extension == CastInst::SExt ? shape.noSignedWrap() : shape.noUnsignedWrap();
  auto *op = dyn_cast<BinaryOperator>(value);
  if (!op || !isExact || shape.isUniform())
    return builder.CreateCast(extension, base(value), type);
  Value *left = extendedBase(extension, op->getOperand(0), type);
  bool isShift = op->getOpcode() == Instruction::Shl;
  Value *right = extendedBase(isShift ? CastInst::ZExt : extension, op->getOperand(1), type);
  return builder.CreateBinOp(op->getOpcode(), left, right);
}

void Widener::copyScalar(Instruction &instruction) {
  if (isa<SExtInst, ZExtInst>(instruction) && !isFull() && !shapeOf(&instruction).isUniform())
    return define(instruction, extendedBase(cast<CastInst>(instruction).getOpcode(),
                                            instruction.getOperand(0), instruction.getType()));
  Instruction *copy = instruction.clone();
  for (Use &operand : copy->operands())
    operand.set(base(operand));
  copy->dropUnknownNonDebugMetadata({LLVMContext::MD_tbaa, LLVMContext::MD_alias_scope,
                                     LLVMContext::MD_noalias, LLVMContext::MD_access_group,
                                     LLVMContext::MD_invariant_load, LLVMContext::MD_fpmath});
  builder.Insert(copy);
  if (!instruction.getType()->isVoidTy()) {
    // Lane 0 need not be active, but others follow from its value.
    if (!shapeOf(&instruction).isUniform() && !isFull())
      copy->dropPoisonGeneratingFlags();
    define(instruction, copy);
  }
}

void Widener::copyFlags(Value *to, const Instruction &from) {
  if (auto *instruction = dyn_cast<Instruction>(to))
    instruction->copyIRFlags(&from);
}

/// Applies an operation to each scalar inside values of a widened structure type.
Value *Widener::mapLeaves(Type *type, ArrayRef<Value *> operands,
                          function_ref<Value *(ArrayRef<Value *>)> leaf) {
  Type *shape = operands[0]->getType();
  if (!shape->isAggregateType())
    return leaf(operands);
  unsigned count =
      shape->isArrayTy() ? shape->getArrayNumElements() : shape->getStructNumElements();
  Value *result = nullptr;
  for (unsigned i = 0; i < count; ++i) {
    SmallVector<Value *, 4> parts;
    for (Value *operand : operands)
      parts.push_back(operand->getType()->isAggregateType() ? builder.CreateExtractValue(operand, i)
                                                            : operand);
    Value *part = mapLeaves(nullptr, parts, leaf);
    if (!result) {
      // Leaves may change type (a comparison of vectors), but all in the same way.
      Type *whole = type && type->isAggregateType() && !type->isVectorTy() ? wide(type)
                    : type && type->isVectorTy()                           ? wide(type)
                                                                           : shape;
      result = PoisonValue::get(whole);
    }
    result = builder.CreateInsertValue(result, part, i);
  }
  return result ? result : PoisonValue::get(shape);
}

//===-- Arithmetic ----------------------------------------------------------===//

static bool divides(const Instruction &op) {
  switch (op.getOpcode()) {
  case Instruction::UDiv:
  case Instruction::SDiv:
  case Instruction::URem:
  case Instruction::SRem:
    return true;
  default:
    return false;
  }
}

/// A divisor that cannot trap in lanes that are not active.
Value *Widener::safeDivisor(BinaryOperator &op, Value *divisor) {
  if (isFull())
    return divisor;
  const APInt *constant;
  if (PatternMatch::match(op.getOperand(1), PatternMatch::m_APInt(constant)) &&
      !constant->isZero() && !constant->isAllOnes())
    return divisor;
  Value *mask = currentMask();
  return mapLeaves(op.getType(), {divisor}, [&](ArrayRef<Value *> leaves) {
    return builder.CreateSelect(mask, leaves[0], ConstantInt::get(leaves[0]->getType(), 1));
  });
}

void Widener::widenBinary(BinaryOperator &op) {
  if (callsMathLibrary(op)) {
    remark(VectorizeRemark::Kind::LaneByLane, op,
           "takes a remainder once per active lane, as processors have no instruction for it");
    return replicate(op);
  }
  if (op.getOpcode() == Instruction::Shl && !isa<Constant>(op.getOperand(1)) &&
      shiftsThroughFloats())
    return replicate(op);
  Value *left = vector(op.getOperand(0)), *right = vector(op.getOperand(1));
  if (divides(op))
    right = safeDivisor(op, right);
  define(op, mapLeaves(op.getType(), {left, right}, [&](ArrayRef<Value *> leaves) {
           Value *result = builder.CreateBinOp(op.getOpcode(), leaves[0], leaves[1]);
           copyFlags(result, op);
           return result;
         }));
}

void Widener::widenCast(CastInst &cast) {
  Value *source = vector(cast.getOperand(0));
  Type *from = cast.getSrcTy(), *to = cast.getDestTy();
  if (from->isVectorTy() == to->isVectorTy() &&
      (!from->isVectorTy() || llvm::cast<FixedVectorType>(from)->getNumElements() ==
                                  llvm::cast<FixedVectorType>(to)->getNumElements())) {
    Type *leafType = FixedVectorType::get(to->getScalarType(), width);
    return define(cast, mapLeaves(to, {source}, [&](ArrayRef<Value *> leaves) {
                    Value *result = builder.CreateCast(cast.getOpcode(), leaves[0], leafType);
                    copyFlags(result, cast);
                    return result;
                  }));
  }
  replicate(cast); // a bit cast that changes how many elements there are
}

void Widener::widenSelect(SelectInst &select) {
  Value *condition = select.getCondition();
  if (condition->getType()->isVectorTy())
    return replicate(select);
  Value *ifTrue = vector(select.getTrueValue()), *ifFalse = vector(select.getFalseValue());
  if (shapeOf(condition).isUniform())
    return define(select, builder.CreateSelect(base(condition), ifTrue, ifFalse));
  Value *lanes = vector(condition);
  define(select, mapLeaves(select.getType(), {ifTrue, ifFalse}, [&](ArrayRef<Value *> leaves) {
           Value *result = builder.CreateSelect(lanes, leaves[0], leaves[1]);
           copyFlags(result, select);
           return result;
         }));
}

//===-- One lane after the other --------------------------------------------===//

Value *Widener::extractLane(Value *widened, Type *type, Value *lane) {
  if (type->isVectorTy()) {
    Value *result = PoisonValue::get(type);
    for (unsigned i = 0; i < cast<FixedVectorType>(type)->getNumElements(); ++i)
      result = builder.CreateInsertElement(
          result, builder.CreateExtractElement(builder.CreateExtractValue(widened, i), lane), i);
    return result;
  }
  if (!type->isAggregateType())
    return builder.CreateExtractElement(widened, lane);
  Value *result = PoisonValue::get(type);
  unsigned count = type->isArrayTy() ? type->getArrayNumElements() : type->getStructNumElements();
  for (unsigned i = 0; i < count; ++i) {
    Type *element = type->isArrayTy() ? type->getArrayElementType() : type->getStructElementType(i);
    result = builder.CreateInsertValue(
        result, extractLane(builder.CreateExtractValue(widened, i), element, lane), i);
  }
  return result;
}

Value *Widener::insertLane(Value *widened, Value *value, Value *lane) {
  Type *type = value->getType();
  if (type->isVectorTy()) {
    for (unsigned i = 0; i < cast<FixedVectorType>(type)->getNumElements(); ++i) {
      Value *part = builder.CreateExtractValue(widened, i);
      part = builder.CreateInsertElement(part, builder.CreateExtractElement(value, i), lane);
      widened = builder.CreateInsertValue(widened, part, i);
    }
    return widened;
  }
  if (!type->isAggregateType())
    return builder.CreateInsertElement(widened, value, lane);
  unsigned count = type->isArrayTy() ? type->getArrayNumElements() : type->getStructNumElements();
  for (unsigned i = 0; i < count; ++i)
    widened = builder.CreateInsertValue(widened,
                                        insertLane(builder.CreateExtractValue(widened, i),
                                                   builder.CreateExtractValue(value, i), lane),
                                        i);
  return widened;
}

Value *Widener::lastActiveLane() {
  if (isFull())
    return builder.getInt32(width - 1);
  Value *bits = builder.CreateBitCast(currentMask(), builder.getIntNTy(width));
  bits = builder.CreateZExt(bits, builder.getIntNTy(std::max(32u, width)));
  Value *zeros = builder.CreateBinaryIntrinsic(Intrinsic::ctlz, bits, builder.getTrue());
  return builder.CreateSub(ConstantInt::get(bits->getType(), std::max(32u, width) - 1), zeros);
}

void Widener::replicate(Instruction &instruction) {
  // The operands' lanes, and what stays the same.
  struct Varying {
    unsigned operand;
    Value *lanes;
    AllocaInst *memory;
  };
  SmallVector<Varying, 4> varying;
  bool harmless = isHarmless(instruction) && !callsMathLibrary(instruction);
  Instruction *pattern = instruction.clone();
  for (Use &operand : pattern->operands()) {
    Value *value = operand.get();
    if (isa<MetadataAsValue>(value) || isa<InlineAsm>(value) || isa<BasicBlock>(value))
      continue;
    if (isa<Constant>(value) || shapeOf(value).isUniform())
      operand.set(base(value));
    else
      varying.push_back({operand.getOperandNo(), vector(value), nullptr});
  }
  pattern->dropUnknownNonDebugMetadata();

  // A loop picks lanes from memory: x86 has no other way to address a lane by number, and LLVM
  // would write the whole vector there in each iteration (and fails to call a pointer that it
  // picked so).
  auto inMemory = [&](Type *type) {
    IRBuilder<> start(variablesEnd);
    return start.CreateAlloca(FixedVectorType::get(type, width), nullptr, "lanes");
  };
  bool returns = !instruction.getType()->isVoidTy();
  Value *result = returns ? PoisonValue::get(wide(instruction.getType())) : nullptr;
  AllocaInst *results = nullptr;
  if (!harmless) {
    for (Varying &item : varying)
      if (isLaneSized(item.lanes->getType()->getScalarType())) {
        item.memory = inMemory(item.lanes->getType()->getScalarType());
        builder.CreateStore(item.lanes, item.memory);
      }
    if (returns && isLaneSized(instruction.getType()))
      results = inMemory(instruction.getType());
  }
  auto runLane = [&](Value *lane, Value *into) -> Value * {
    Instruction *copy = pattern->clone();
    for (auto [operand, lanes, memory] : varying) {
      Type *type = instruction.getOperand(operand)->getType();
      copy->setOperand(operand,
                       memory ? builder.CreateLoad(type, builder.CreateGEP(type, memory, lane))
                              : extractLane(lanes, type, lane));
    }
    builder.Insert(copy);
    if (!returns)
      return nullptr;
    if (!results)
      return insertLane(into, copy, lane);
    builder.CreateStore(copy, builder.CreateGEP(copy->getType(), results, lane));
    return into;
  };

  if (harmless) {
    for (unsigned lane = 0; lane < width; ++lane)
      result = runLane(builder.getInt32(lane), result);
  } else {
    // while (bits) { lane = lowest(bits); ...; bits &= bits - 1; }
    Type *type = builder.getIntNTy(std::max(32u, width));
    Value *bits = builder.CreateBitCast(currentMask(), builder.getIntNTy(width));
    bits = builder.CreateZExt(bits, type);
    BasicBlock *before = builder.GetInsertBlock();
    BasicBlock *loop = BasicBlock::Create(context, "lane", &widened, before->getNextNode());
    BasicBlock *after = BasicBlock::Create(context, "lanes.done", &widened, loop->getNextNode());
    if (isOccupied())
      builder.CreateBr(loop);
    else
      builder.CreateCondBr(builder.CreateICmpNE(bits, ConstantInt::get(type, 0)), loop, after);
    builder.SetInsertPoint(loop);
    PHINode *left = builder.CreatePHI(type, 2, "left");
    left->addIncoming(bits, before);
    PHINode *sofar = returns && !results ? builder.CreatePHI(result->getType(), 2) : nullptr;
    if (sofar)
      sofar->addIncoming(result, before);
    Value *lane = builder.CreateBinaryIntrinsic(Intrinsic::cttz, left, builder.getTrue());
    Value *updated = runLane(builder.CreateZExtOrTrunc(lane, builder.getInt64Ty()), sofar);
    Value *rest = builder.CreateAnd(left, builder.CreateSub(left, ConstantInt::get(type, 1)));
    left->addIncoming(rest, loop);
    if (sofar)
      sofar->addIncoming(updated, loop);
    builder.CreateCondBr(builder.CreateICmpNE(rest, ConstantInt::get(type, 0)), loop, after);
    builder.SetInsertPoint(after);
    if (results) {
      updated = builder.CreateLoad(result->getType(), results);
    } else if (returns && !isOccupied()) {
      PHINode *joined = builder.CreatePHI(result->getType(), 2);
      joined->addIncoming(result, before);
      joined->addIncoming(updated, loop);
      updated = joined;
    }
    result = updated;
  }
  pattern->deleteValue();
  if (returns)
    define(instruction, result);
}

} // namespace anysl
