//===-- test/unit/Vectorize/Generator.cpp - random well-defined functions ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/Vectorize/Generator.h"

#include "test/unit/Vectorize/Kernels.h"

#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Verifier.h"
#include "llvm/Transforms/Utils/PromoteMemToReg.h"

#include <random>

using namespace llvm;

namespace anysl::test {

namespace {

class Generator {
public:
  Generator(LLVMContext &context, uint64_t seed, bool mindsFlags)
      : context(context), random(seed), builder(context), mindsFlags(mindsFlags),
        module(std::make_unique<Module>("fuzz", context)) {
    types = {builder.getInt32Ty(),  builder.getFloatTy(),  builder.getInt64Ty(),
             builder.getDoubleTy(), builder.getInt16Ty(),  builder.getInt8Ty(),
             builder.getInt1Ty(),   builder.getIntNTy(24), builder.getIntNTy(7)};
    pairType = StructType::get(context, {builder.getInt32Ty(), builder.getFloatTy()});
  }
  std::unique_ptr<Module> run();

private:
  struct Variable {
    AllocaInst *memory;
    Type *type;
    bool uniform; ///< only ever holds what is the same for all lanes
  };

  static constexpr unsigned InMemory = 6; ///< the first types, which inputs and outputs have

  unsigned below(unsigned bound) { return random() % bound; }
  bool chance(unsigned percent) { return below(100) < percent; }

  Function *generateHelper(unsigned number);
  void generateBody(Function *function, unsigned size, bool isKernel);
  void makeVariables(Function *function, bool isKernel);
  void step();
  void connect(ArrayRef<BasicBlock *> blocks, unsigned index, BasicBlock *end);
  BasicBlock *guarded(ArrayRef<BasicBlock *> blocks, unsigned from, unsigned to, BasicBlock *end);
  Value *condition(bool uniform);
  Value *value(Type *type, bool uniform);
  Value *constant(Type *type);
  Value *integerOperation(Type *type, bool uniform);
  Value *floatOperation(Type *type, bool uniform);
  Value *convert(Type *type, bool uniform);
  Value *readMemory(Type *type);
  void writeMemory();
  void divide();
  void callSomething();
  void callHelper(Variable &target);
  void usePrivateArray();
  void usePointer();
  Value *address(bool uniform, bool writable);
  Variable *variableOf(Type *type, bool uniform);
  Value *inputAddress(unsigned field, unsigned row, Type *element, Value *lane);

  LLVMContext &context;
  std::mt19937_64 random;
  IRBuilder<> builder;
  bool mindsFlags;
  std::unique_ptr<Module> module;
  SmallVector<Type *, 12> types;
  StructType *pairType; ///< what helpers take and return
  SmallVector<Function *, 4> helpers;
  Function *opaque = nullptr, *declared = nullptr;

  // Of the function being made.
  bool inKernel = false;
  Value *args = nullptr, *lane = nullptr;
  SmallVector<Variable, 24> variables;
  AllocaInst *fuel = nullptr, *array = nullptr, *oddArray = nullptr;
  SmallVector<Variable, 4> pointers; ///< to readable integers; the last to ones of the lane's own
  bool mixesPointers = false;        ///< whether some point into `array`
  unsigned calls = 0;
};

} // namespace

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

namespace {
struct Field {
  unsigned offset, row; ///< in bytes, and of one row of LANES elements
  unsigned rows;
};
} // namespace

static Field inputField(Type *type) {
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

static Field outputField(Type *type) {
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

//===-- Steps ---------------------------------------------------------------===//

/// if (divisor is good) x = a / divisor
void Generator::divide() {
  Type *type = types[below(types.size())];
  if (!type->isIntegerTy() || type->isIntegerTy(1))
    return;
  Variable *target = variableOf(type, false);
  if (!target || target->uniform)
    return;
  Value *a = value(type, chance(20)), *b = value(type, chance(30));
  bool isSigned = chance(50);
  Value *good = isSigned ? builder.CreateICmpSGT(b, ConstantInt::get(type, 0))
                         : builder.CreateICmpNE(b, ConstantInt::get(type, 0));
  Function *function = builder.GetInsertBlock()->getParent();
  BasicBlock *then = BasicBlock::Create(context, "divide", function);
  BasicBlock *after = BasicBlock::Create(context, "divided", function);
  builder.CreateCondBr(good, then, after);
  builder.SetInsertPoint(then);
  Instruction::BinaryOps ops[] = {Instruction::UDiv, Instruction::URem, Instruction::SDiv,
                                  Instruction::SRem};
  builder.CreateStore(builder.CreateBinOp(ops[2 * isSigned + below(2)], a, b), target->memory);
  builder.CreateBr(after);
  builder.SetInsertPoint(after);
}

void Generator::callSomething() {
  // Few calls, so that loops of recursive calls within loops come to an end.
  if (calls++ >= (inKernel ? 4 : 1))
    return;
  Type *type = builder.getInt32Ty();
  Variable *target = variableOf(type, false);
  if (!target || target->uniform)
    return;
  if (inKernel && chance(40)) {
    Value *result =
        builder.CreateCall(chance(50) ? opaque : declared,
                           {value(type, chance(30)), value(builder.getFloatTy(), chance(30))});
    builder.CreateStore(result, target->memory);
    return;
  }
  if (!helpers.empty())
    callHelper(*target);
}

/// Passes a structure as a value, chosen from two now and then, and gets one.
void Generator::callHelper(Variable &target) {
  Type *type = builder.getInt32Ty();
  Function *helper = helpers[below(helpers.size())];
  Value *depth = inKernel ? cast<Value>(builder.getInt32(below(3)))
                          : builder.CreateSub(builder.GetInsertBlock()->getParent()->getArg(3),
                                              builder.getInt32(1));
  auto pair = [&] {
    Value *one = builder.CreateInsertValue(PoisonValue::get(pairType), value(type, chance(40)), 0);
    return builder.CreateInsertValue(one, value(builder.getFloatTy(), chance(40)), 1);
  };
  Value *argument = pair();
  if (chance(40)) {
    Value *other = pair();
    argument = builder.CreateSelect(condition(chance(20)), argument, other);
  }
  Value *result = builder.CreateCall(helper, {args, lane, argument, depth});
  builder.CreateStore(builder.CreateExtractValue(result, 0), target.memory);
  Variable *number = variableOf(builder.getFloatTy(), false);
  if (number && !number->uniform)
    builder.CreateStore(builder.CreateExtractValue(result, 1), number->memory);
}

void Generator::step() {
  unsigned kind = below(100);
  if (kind < 8)
    return writeMemory();
  if (kind < 13)
    return divide();
  if (kind < 17)
    return callSomething();
  if (kind < 24)
    return usePrivateArray();
  if (kind < 29)
    return usePointer();
  Variable &target = variables[below(variables.size())];
  bool uniform = target.uniform;
  Value *result;
  if (kind < 43 && !uniform)
    result = readMemory(target.type);
  else if (kind < 57)
    result = convert(target.type, uniform);
  else if (kind < 63)
    result = value(target.type, uniform);
  else if (target.type->isFloatingPointTy())
    result = floatOperation(target.type, uniform);
  else
    result = integerOperation(target.type, uniform);
  builder.CreateStore(result, target.memory);
}

//===-- Control flow --------------------------------------------------------===//

/// The way to a block: one that leads back costs fuel, and without fuel leads to the end.
BasicBlock *Generator::guarded(ArrayRef<BasicBlock *> blocks, unsigned from, unsigned to,
                               BasicBlock *end) {
  if (to > from)
    return blocks[to];
  IRBuilder<>::InsertPointGuard saved(builder);
  Function *function = end->getParent();
  BasicBlock *check = BasicBlock::Create(context, "back", function);
  builder.SetInsertPoint(check);
  Value *left =
      builder.CreateSub(builder.CreateLoad(builder.getInt32Ty(), fuel), builder.getInt32(1));
  builder.CreateStore(left, fuel);
  builder.CreateCondBr(builder.CreateICmpSGT(left, builder.getInt32(0)), blocks[to], end);
  return check;
}

void Generator::connect(ArrayRef<BasicBlock *> blocks, unsigned index, BasicBlock *end) {
  auto target = [&]() -> BasicBlock * {
    if (chance(6))
      return end;
    // Mostly near and ahead, as programs are; now and then anywhere.
    unsigned to = chance(65) ? index + 1 + below(3) : below(blocks.size());
    return to < blocks.size() ? guarded(blocks, index, to, end) : end;
  };
  unsigned kind = below(100);
  bool uniform = chance(30);
  if (kind < 20) {
    builder.CreateBr(target());
  } else if (kind < 90) {
    Value *test = condition(uniform);
    BasicBlock *a = target(), *b = target();
    builder.CreateCondBr(test, a, b);
  } else {
    Value *selector = builder.CreateAnd(value(builder.getInt32Ty(), uniform), builder.getInt32(3));
    BasicBlock *otherwise = target();
    SwitchInst *choice = builder.CreateSwitch(selector, otherwise);
    for (unsigned i = 0; i < 3; ++i)
      choice->addCase(builder.getInt32(i), target());
  }
}

void Generator::makeVariables(Function *function, bool isKernel) {
  variables.clear();
  for (Type *type : types)
    for (unsigned i = 0; i < 3; ++i)
      variables.push_back({builder.CreateAlloca(type), type, i == 2});
  fuel = builder.CreateAlloca(builder.getInt32Ty(), nullptr, "fuel");
  array = builder.CreateAlloca(ArrayType::get(builder.getInt32Ty(), 8), nullptr, "array");
  oddArray = builder.CreateAlloca(ArrayType::get(builder.getIntNTy(24), 4), nullptr, "odd");
  for (AllocaInst *memory : {array, oddArray})
    for (unsigned i = 0; i < memory->getAllocatedType()->getArrayNumElements(); ++i) {
      Type *element = memory->getAllocatedType()->getArrayElementType();
      builder.CreateStore(Constant::getNullValue(element),
                          builder.CreateGEP(element, memory, builder.getInt64(i)));
    }
  mixesPointers = chance(40);
  pointers.clear();
  for (unsigned i = 0; i < 4; ++i)
    pointers.push_back({builder.CreateAlloca(builder.getPtrTy()), builder.getPtrTy(), i == 1});
  auto scalar = [&](uint64_t offset, Type *type) {
    return builder.CreateLoad(
        type, builder.CreateGEP(builder.getInt8Ty(), args, builder.getInt64(offset)));
  };
  builder.CreateStore(builder.getInt32(isKernel ? 4 + below(24) : 2 + below(4)), fuel);
  // All have a value before the first one's address is computed from another.
  for (Variable &variable : variables)
    builder.CreateStore(constant(variable.type), variable.memory);
  for (Variable &variable : variables) {
    Value *initial;
    if (!variable.uniform)
      initial = isKernel ? readMemory(variable.type) : constant(variable.type);
    else if (variable.type->isIntegerTy(32))
      initial = scalar(chance(50) ? offsetof(Args, n) : offsetof(Args, m), variable.type);
    else if (variable.type->isFloatTy())
      initial = scalar(offsetof(Args, uniform), variable.type);
    else
      initial = constant(variable.type);
    builder.CreateStore(initial, variable.memory);
  }
  for (Variable &pointer : pointers)
    builder.CreateStore(address(pointer.uniform, &pointer == &pointers.back()), pointer.memory);
}

void Generator::generateBody(Function *function, unsigned size, bool isKernel) {
  inKernel = isKernel;
  calls = 0;
  args = function->getArg(0);
  lane = function->getArg(1);
  BasicBlock *entry = BasicBlock::Create(context, "entry", function);
  builder.SetInsertPoint(entry);
  makeVariables(function, isKernel);
  BasicBlock *end = BasicBlock::Create(context, "end", function);
  if (!isKernel) {
    builder.CreateStore(builder.CreateExtractValue(function->getArg(2), 0), variables[0].memory);
    builder.CreateStore(builder.CreateExtractValue(function->getArg(2), 1), variables[3].memory);
    BasicBlock *deep = BasicBlock::Create(context, "deep", function);
    builder.CreateCondBr(builder.CreateICmpSGT(function->getArg(3), builder.getInt32(0)), deep,
                         end);
    builder.SetInsertPoint(deep);
  }
  SmallVector<BasicBlock *, 16> blocks;
  for (unsigned i = 0; i < size; ++i)
    blocks.push_back(BasicBlock::Create(context, "b", function));
  builder.CreateBr(blocks[0]);
  for (unsigned i = 0; i < size; ++i) {
    builder.SetInsertPoint(blocks[i]);
    for (unsigned n = 1 + below(7); n > 0; --n)
      step();
    connect(blocks, i, end);
  }
  builder.SetInsertPoint(end);
  if (!isKernel) {
    Value *result = PoisonValue::get(pairType);
    for (unsigned i = 0; i < 2; ++i)
      result = builder.CreateInsertValue(
          result,
          builder.CreateLoad(pairType->getElementType(i), variables[3 * i + below(2)].memory), i);
    builder.CreateRet(result);
    return;
  }
  for (Variable &variable : variables) {
    bool odd = !is_contained(ArrayRef(types).take_front(InMemory), variable.type);
    Type *type = odd ? builder.getInt32Ty() : variable.type;
    Field field = outputField(type);
    Value *row = builder.CreateGEP(
        builder.getInt8Ty(), args,
        builder.getInt64(field.offset + ((&variable - variables.data()) % field.rows) * field.row));
    Value *address = builder.CreateGEP(type, row, lane);
    Value *result = builder.CreateLoad(variable.type, variable.memory);
    if (odd) // what no row of its own holds
      result = builder.CreateXor(
          builder.CreateSExt(result, type),
          builder.CreateMul(builder.CreateLoad(type, address), builder.getInt32(31)));
    builder.CreateStore(result, address);
  }
  builder.CreateRetVoid();
}

/// A function that is only declared, with masked variants of 4, 8 and 16 lanes whose code is given.
static Function *declareWithVariants(Module &module) {
  LLVMContext &context = module.getContext();
  IRBuilder<> builder(context);
  Type *i32 = builder.getInt32Ty(), *number = builder.getFloatTy();
  auto *function = Function::Create(FunctionType::get(i32, {i32, number}, false),
                                    GlobalValue::ExternalLinkage, "anyslTestDeclared", module);
  for (unsigned width : {4, 8, 16}) {
    std::string count = std::to_string(width), name = "anyslTestDeclared_x" + count;
    auto lanes = [&](Type *type) { return FixedVectorType::get(type, width); };
    Type *types[] = {lanes(i32), lanes(number), lanes(builder.getInt1Ty())};
    auto *variant = Function::Create(FunctionType::get(types[0], types, false),
                                     GlobalValue::ExternalLinkage, name, module);
    variant->addFnAttr("min-legal-vector-width", std::to_string(32 * width));
    variant->addFnAttr("prefer-vector-width", std::to_string(32 * width));
    BasicBlock *block = BasicBlock::Create(context, "", variant);
    builder.SetInsertPoint(block);
    Value *result = Constant::getNullValue(types[0]);
    for (unsigned lane = 0; lane < width; ++lane) {
      BasicBlock *call = BasicBlock::Create(context, "", variant);
      BasicBlock *next = BasicBlock::Create(context, "", variant);
      Value *here[3];
      for (unsigned i = 0; i < 3; ++i)
        here[i] = builder.CreateExtractElement(variant->getArg(i), lane);
      builder.CreateCondBr(here[2], call, next);
      builder.SetInsertPoint(call);
      Value *made = builder.CreateInsertElement(
          result, builder.CreateCall(function, {here[0], here[1]}), lane);
      builder.CreateBr(next);
      builder.SetInsertPoint(next);
      PHINode *either = builder.CreatePHI(types[0], 2);
      either->addIncoming(result, block);
      either->addIncoming(made, call);
      result = either;
      block = next;
    }
    builder.CreateRet(result);
    function->addFnAttr("_ZGV_LLVM_M" + count + "vv_anyslTestDeclared(" + name + ")");
  }
  return function;
}

std::unique_ptr<Module> Generator::run() {
  Type *i32 = builder.getInt32Ty();
  opaque = Function::Create(FunctionType::get(i32, {i32, builder.getFloatTy()}, false),
                            GlobalValue::ExternalLinkage, "anyslTestOpaque", *module);
  declared = declareWithVariants(*module);
  auto *helperType = FunctionType::get(pairType, {builder.getPtrTy(), i32, pairType, i32}, false);
  for (unsigned i = 0, count = below(3); i < count; ++i)
    helpers.push_back(
        Function::Create(helperType, GlobalValue::InternalLinkage, "helper", *module));
  for (Function *helper : helpers)
    generateBody(helper, 2 + below(5), false);
  Function *kernel =
      Function::Create(FunctionType::get(builder.getVoidTy(), {builder.getPtrTy(), i32}, false),
                       GlobalValue::ExternalLinkage, "fuzz", *module);
  generateBody(kernel, 1 + below(2 + below(15)), true);
  return std::move(module);
}

std::unique_ptr<Module> generateModule(LLVMContext &context, uint64_t seed, bool mindsFlags) {
  return Generator(context, seed, mindsFlags).run();
}

} // namespace anysl::test
