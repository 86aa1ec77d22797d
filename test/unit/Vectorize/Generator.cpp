//===-- test/unit/Vectorize/Generator.cpp - random well-defined functions -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/Vectorize/Generator.h"

#include "test/unit/Vectorize/Kernels.h"
#include "test/unit/Vectorize/RandomFunction.h"

#include "llvm/IR/Verifier.h"
#include "llvm/Transforms/Utils/PromoteMemToReg.h"

using namespace llvm;

namespace anysl::test {

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
