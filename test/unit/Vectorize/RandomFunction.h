//===-- test/unit/Vectorize/RandomFunction.h - what generateModule() works with -------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_UNIT_VECTORIZE_RANDOMFUNCTION_H
#define ANYSL_TEST_UNIT_VECTORIZE_RANDOMFUNCTION_H

#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Module.h"

#include <memory>
#include <random>

namespace anysl::test {

/// Makes one module; see generateModule().
class Generator {
public:
  Generator(llvm::LLVMContext &context, uint64_t seed, bool mindsFlags)
      : context(context), random(seed), builder(context), mindsFlags(mindsFlags),
        module(std::make_unique<llvm::Module>("fuzz", context)) {
    types = {builder.getInt32Ty(),  builder.getFloatTy(),  builder.getInt64Ty(),
             builder.getDoubleTy(), builder.getInt16Ty(),  builder.getInt8Ty(),
             builder.getInt1Ty(),   builder.getIntNTy(24), builder.getIntNTy(7)};
    pairType = llvm::StructType::get(context, {builder.getInt32Ty(), builder.getFloatTy()});
  }
  std::unique_ptr<llvm::Module> run();

private:
  struct Variable {
    llvm::AllocaInst *memory;
    llvm::Type *type;
    bool uniform; ///< only ever holds what is the same for all lanes
  };

  /// Where the kernel's arguments have values of a type (Kernels.h).
  struct Field {
    unsigned offset, row; ///< in bytes, and of one row of LANES elements
    unsigned rows;
  };
  static Field inputField(llvm::Type *type);
  static Field outputField(llvm::Type *type);

  static constexpr unsigned InMemory = 6; ///< the first types, which inputs and outputs have

  unsigned below(unsigned bound) { return random() % bound; }
  bool chance(unsigned percent) { return below(100) < percent; }

  llvm::Function *generateHelper(unsigned number);
  void generateBody(llvm::Function *function, unsigned size, bool isKernel);
  void makeVariables(llvm::Function *function, bool isKernel);
  void step();
  void connect(llvm::ArrayRef<llvm::BasicBlock *> blocks, unsigned index, llvm::BasicBlock *end);
  llvm::BasicBlock *guarded(llvm::ArrayRef<llvm::BasicBlock *> blocks, unsigned from, unsigned to,
                            llvm::BasicBlock *end);
  llvm::Value *condition(bool uniform);
  llvm::Value *value(llvm::Type *type, bool uniform);
  llvm::Value *constant(llvm::Type *type);
  llvm::Value *integerOperation(llvm::Type *type, bool uniform);
  llvm::Value *floatOperation(llvm::Type *type, bool uniform);
  llvm::Value *convert(llvm::Type *type, bool uniform);
  llvm::Value *readMemory(llvm::Type *type);
  void writeMemory();
  void divide();
  void callSomething();
  void callHelper(Variable &target);
  void usePrivateArray();
  void usePointer();
  llvm::Value *address(bool uniform, bool writable);
  Variable *variableOf(llvm::Type *type, bool uniform);
  llvm::Value *inputAddress(unsigned field, unsigned row, llvm::Type *element, llvm::Value *lane);

  llvm::LLVMContext &context;
  std::mt19937_64 random;
  llvm::IRBuilder<> builder;
  bool mindsFlags;
  std::unique_ptr<llvm::Module> module;
  llvm::SmallVector<llvm::Type *, 12> types;
  llvm::StructType *pairType; ///< what helpers take and return
  llvm::SmallVector<llvm::Function *, 4> helpers;
  llvm::Function *opaque = nullptr, *declared = nullptr;

  // Of the function being made.
  bool inKernel = false;
  llvm::Value *args = nullptr, *lane = nullptr;
  llvm::SmallVector<Variable, 24> variables;
  llvm::AllocaInst *fuel = nullptr, *array = nullptr, *oddArray = nullptr;
  llvm::SmallVector<Variable, 4>
      pointers;               ///< to readable integers; the last to ones of the lane's own
  bool mixesPointers = false; ///< whether some point into `array`
  unsigned calls = 0;
};

} // namespace anysl::test

#endif
