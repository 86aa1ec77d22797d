//===-- test/unit/Vectorize/RandomValues.cpp - random functions' values and memory ----------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/Vectorize/Kernels.h"
#include "test/unit/Vectorize/RandomFunction.h"

using namespace llvm;

namespace anysl::test {

//===-- Values --------------------------------------------------------------===//

Value *Generator::constant(Type *type) {
  if (type->isFloatingPointTy())
    return ConstantFP::get(type, (int(below(33)) - 16) / 4.0);
  unsigned bits = type->getIntegerBitWidth();
  if (chance(10))
    return ConstantInt::get(context, chance(50) ? APInt::getSignedMinValue(bits)
                                                : APInt::getSignedMaxValue(bits));
  return ConstantInt::get(type, int64_t(below(41)) - 20, true);
}

Generator::Variable *Generator::variableOf(Type *type, bool uniform) {
  SmallVector<Variable *, 8> fitting;
  for (Variable &variable : variables)
    if (variable.type == type && (!uniform || variable.uniform))
      fitting.push_back(&variable);
  return fitting.empty() ? nullptr : fitting[below(fitting.size())];
}

Value *Generator::value(Type *type, bool uniform) {
  if (chance(15))
    return constant(type);
  if (!uniform && type->isIntegerTy(32) && chance(8))
    return lane;
  if (Variable *variable = variableOf(type, uniform))
    return builder.CreateLoad(type, variable->memory);
  return constant(type);
}

Value *Generator::condition(bool uniform) {
  Type *type = types[below(types.size())];
  Value *a = value(type, uniform), *b = value(type, uniform);
  if (type->isIntegerTy(1))
    return builder.CreateXor(a, b);
  if (type->isFloatingPointTy()) {
    CmpInst::Predicate predicates[] = {CmpInst::FCMP_OLT, CmpInst::FCMP_OGE, CmpInst::FCMP_UNE,
                                       CmpInst::FCMP_UGT, CmpInst::FCMP_ORD};
    return builder.CreateFCmp(predicates[below(5)], a, b);
  }
  CmpInst::Predicate predicates[] = {CmpInst::ICMP_EQ,  CmpInst::ICMP_NE,  CmpInst::ICMP_SLT,
                                     CmpInst::ICMP_SGE, CmpInst::ICMP_ULT, CmpInst::ICMP_UGT};
  return builder.CreateICmp(predicates[below(6)], a, b);
}

Value *Generator::integerOperation(Type *type, bool uniform) {
  Value *a = value(type, uniform), *b = value(type, uniform);
  unsigned bits = type->getIntegerBitWidth();
  Value *amount = builder.CreateAnd(b, ConstantInt::get(type, bits - 1));
  switch (below(15)) {
  case 0:
    return builder.CreateSub(a, b);
  case 1:
    return builder.CreateMul(a, b);
  case 2:
    return builder.CreateAnd(a, b);
  case 3:
    return builder.CreateOr(a, b);
  case 4:
    return builder.CreateXor(a, b);
  case 5:
    return bits == 1 ? a : builder.CreateShl(a, amount);
  case 6:
    return bits == 1 ? a : builder.CreateLShr(a, amount);
  case 7:
    return bits == 1 ? a : builder.CreateAShr(a, amount);
  case 8:
    return builder.CreateSelect(condition(uniform), a, b);
  case 9:
    return builder.CreateBinaryIntrinsic(Intrinsic::smax, a, b);
  case 10:
    return builder.CreateUnaryIntrinsic(Intrinsic::ctpop, a);
  case 11:
    return builder.CreateBinaryIntrinsic(Intrinsic::uadd_sat, a, b);
  case 12: {
    Value *pair = builder.CreateBinaryIntrinsic(Intrinsic::sadd_with_overflow, a, b);
    return builder.CreateSelect(builder.CreateExtractValue(pair, 1), a,
                                builder.CreateExtractValue(pair, 0));
  }
  case 13:
    return bits < 8 ? a : builder.CreateIntrinsic(Intrinsic::fshl, {type}, {a, b, amount});
  default:
    return builder.CreateAdd(a, b);
  }
}

Value *Generator::floatOperation(Type *type, bool uniform) {
  Value *a = value(type, uniform), *b = value(type, uniform);
  switch (below(11)) {
  case 0:
    return builder.CreateFSub(a, b);
  case 1:
    return builder.CreateFMul(a, b);
  case 2:
    return builder.CreateFDiv(a, b);
  case 3:
    return builder.CreateFNeg(a);
  case 4:
    return builder.CreateUnaryIntrinsic(Intrinsic::fabs, a);
  case 5:
    return builder.CreateUnaryIntrinsic(Intrinsic::sqrt, a);
  case 6:
    return builder.CreateUnaryIntrinsic(chance(50) ? Intrinsic::floor : Intrinsic::trunc, a);
  case 7:
    return builder.CreateIntrinsic(Intrinsic::fma, {type}, {a, b, value(type, uniform)});
  case 8:
    return builder.CreateSelect(condition(uniform), a, b);
  case 9:
    // A NaN's sign is nobody's business.
    return builder.CreateBinaryIntrinsic(Intrinsic::copysign, a,
                                         builder.CreateSelect(builder.CreateFCmpORD(b, b), b, a));
  default:
    return builder.CreateFAdd(a, b);
  }
}

Value *Generator::convert(Type *type, bool uniform) {
  Type *from = types[below(types.size())];
  Value *source = value(from, uniform);
  if (type->isFloatingPointTy()) {
    if (from->isFloatingPointTy())
      return builder.CreateFPCast(source, type);
    return chance(50) ? builder.CreateSIToFP(source, type) : builder.CreateUIToFP(source, type);
  }
  if (!from->isFloatingPointTy())
    return chance(50) ? builder.CreateSExtOrTrunc(source, type)
                      : builder.CreateZExtOrTrunc(source, type);
  if (chance(30) && from->getScalarSizeInBits() == type->getScalarSizeInBits()) {
    // The bits of a NaN are nobody's business.
    Value *number = builder.CreateSelect(builder.CreateFCmpORD(source, source), source,
                                         ConstantFP::get(from, 7));
    return builder.CreateBitCast(number, type);
  }
  if (mindsFlags && type->isIntegerTy(1))
    return builder.CreateFCmpUNE(source, ConstantFP::get(from, 0));
  if (mindsFlags) {
    Value *size = builder.CreateUnaryIntrinsic(Intrinsic::fabs, source);
    Value *fits = builder.CreateFCmpOLT(size, ConstantFP::get(from, 60));
    return builder.CreateFPToSI(builder.CreateSelect(fits, source, ConstantFP::get(from, 0)), type);
  }
  return builder.CreateIntrinsic(chance(50) ? Intrinsic::fptosi_sat : Intrinsic::fptoui_sat,
                                 {type, from}, {source});
}

//===-- Memory --------------------------------------------------------------===//

Generator::Field Generator::inputField(Type *type) {
  if (type->isFloatTy())
    return {offsetof(Args, f), sizeof(float) * LANES, INPUTS};
  if (type->isDoubleTy())
    return {offsetof(Args, d), sizeof(double) * LANES, INPUTS};
  if (type->isIntegerTy(64))
    return {offsetof(Args, l), sizeof(long long) * LANES, INPUTS};
  if (type->isIntegerTy(16))
    return {offsetof(Args, s), sizeof(short) * LANES, INPUTS};
  if (type->isIntegerTy(8))
    return {offsetof(Args, b), LANES, INPUTS};
  return {offsetof(Args, i), sizeof(int) * LANES, INPUTS};
}

Generator::Field Generator::outputField(Type *type) {
  if (type->isFloatTy())
    return {offsetof(Args, fo), sizeof(float) * LANES, OUTPUTS};
  if (type->isDoubleTy())
    return {offsetof(Args, dout), sizeof(double) * LANES, OUTPUTS};
  if (type->isIntegerTy(64))
    return {offsetof(Args, lo), sizeof(long long) * LANES, OUTPUTS};
  if (type->isIntegerTy(16))
    return {offsetof(Args, so), 0, 1};
  if (type->isIntegerTy(8))
    return {offsetof(Args, bo), 0, 1};
  return {offsetof(Args, io), sizeof(int) * LANES, OUTPUTS};
}

/// A value of one of the types that memory holds.
Value *Generator::readMemory(Type *type) {
  if (type->isIntegerTy(1) || type->isIntegerTy(7))
    return builder.CreateTrunc(readMemory(builder.getInt8Ty()), type);
  if (type->isIntegerTy(24))
    return builder.CreateTrunc(readMemory(builder.getInt32Ty()), type);
  auto byte = [&](uint64_t offset) {
    return builder.CreateGEP(builder.getInt8Ty(), args, builder.getInt64(offset));
  };
  bool fromTable = (type->isFloatTy() || type->isIntegerTy(32)) && chance(40);
  if (fromTable) {
    Value *index =
        builder.CreateAnd(value(builder.getInt32Ty(), chance(25)), builder.getInt32(TABLE - 1));
    if (chance(50))
      index = builder.CreateZExt(index, builder.getInt64Ty());
    uint64_t table = type->isFloatTy() ? offsetof(Args, table) : offsetof(Args, itable);
    return builder.CreateLoad(type, builder.CreateGEP(type, byte(table), index));
  }
  if (type->isFloatTy() && chance(25)) { // a structure per lane
    Value *point = builder.CreateGEP(ArrayType::get(builder.getInt32Ty(), 4),
                                     byte(offsetof(Args, points)), lane);
    return builder.CreateLoad(
        type, builder.CreateGEP(builder.getFloatTy(), point, builder.getInt64(below(3))));
  }
  Field field = inputField(type);
  Value *row = byte(field.offset + below(field.rows) * field.row);
  Value *index = chance(50) ? builder.CreateSExt(lane, builder.getInt64Ty()) : lane;
  return builder.CreateLoad(type, builder.CreateGEP(type, row, index));
}

/// Writes to the lane's own element, which it may read back.
void Generator::writeMemory() {
  Type *type = types[below(InMemory)];
  auto byte = [&](uint64_t offset) {
    return builder.CreateGEP(builder.getInt8Ty(), args, builder.getInt64(offset));
  };
  Value *address;
  if (chance(25)) {
    type = builder.getInt32Ty();
    Value *row = builder.CreateGEP(ArrayType::get(type, PRIVATE), byte(offsetof(Args, priv)), lane);
    Value *index = builder.CreateAnd(value(type, chance(30)), builder.getInt32(PRIVATE - 1));
    address = builder.CreateGEP(type, row, index);
  } else {
    Field field = outputField(type);
    address = builder.CreateGEP(type, byte(field.offset + below(field.rows) * field.row), lane);
  }
  Value *stored = value(type, chance(20));
  if (chance(30) && !type->isFloatingPointTy())
    stored = builder.CreateAdd(stored, builder.CreateLoad(type, address));
  builder.CreateStore(stored, address);
}

void Generator::usePrivateArray() {
  bool odd = chance(15);
  Type *type = odd ? builder.getIntNTy(24) : builder.getInt32Ty();
  Value *index =
      builder.CreateAnd(value(builder.getInt32Ty(), chance(30)), builder.getInt32(odd ? 3 : 7));
  Value *address = builder.CreateGEP(type, odd ? oddArray : array, index);
  if (chance(50))
    builder.CreateStore(value(type, chance(20)), address);
  else if (Variable *variable = variableOf(type, false); variable && !variable->uniform)
    builder.CreateStore(builder.CreateLoad(type, address), variable->memory);
}

/// Where an integer lies that may be read; or one of the lane's own.
Value *Generator::address(bool uniform, bool writable) {
  Type *type = builder.getInt32Ty();
  auto byte = [&](uint64_t offset) {
    return builder.CreateGEP(builder.getInt8Ty(), args, builder.getInt64(offset));
  };
  auto index = [&](unsigned mask) {
    return builder.CreateAnd(value(type, uniform || chance(30)), builder.getInt32(mask));
  };
  if (uniform || (!writable && chance(40)))
    return builder.CreateGEP(type, byte(offsetof(Args, itable)), index(TABLE - 1));
  if (mixesPointers && chance(40))
    return builder.CreateGEP(type, array, index(7));
  if (!writable && chance(40))
    return builder.CreateGEP(type, byte(offsetof(Args, i) + below(INPUTS) * sizeof(int) * LANES),
                             lane);
  Value *row = builder.CreateGEP(ArrayType::get(type, PRIVATE), byte(offsetof(Args, priv)), lane);
  return builder.CreateGEP(type, row, index(PRIVATE - 1));
}

void Generator::usePointer() {
  Type *type = builder.getInt32Ty();
  bool own = chance(30);
  Variable &pointer = own ? pointers.back() : pointers[below(pointers.size() - 1)];
  if (chance(40)) {
    Value *target = address(pointer.uniform, own);
    if (chance(20)) {
      Value *old = builder.CreateLoad(builder.getPtrTy(), pointer.memory);
      target = builder.CreateSelect(condition(pointer.uniform), target, old);
    }
    builder.CreateStore(target, pointer.memory);
    return;
  }
  Value *target = builder.CreateLoad(builder.getPtrTy(), pointer.memory);
  if (own && chance(50)) {
    builder.CreateStore(value(type, chance(20)), target);
    return;
  }
  Variable *variable = variableOf(type, false);
  if (!variable || variable->uniform)
    return;
  Value *result = builder.CreateLoad(type, target);
  if (chance(20)) {
    Value *other = builder.CreateLoad(builder.getPtrTy(), pointers[0].memory);
    result = builder.CreateSelect(builder.CreateICmpEQ(target, other), result,
                                  builder.CreateNot(result));
  }
  builder.CreateStore(result, variable->memory);
}

} // namespace anysl::test
