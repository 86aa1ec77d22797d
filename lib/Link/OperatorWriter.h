//===-- lib/Link/OperatorWriter.h - writes operators into threaded code -------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_OPERATORWRITER_H
#define ANYSL_LIB_LINK_OPERATORWRITER_H

#include "lib/STC/Ops.h"
#include "llvm/ADT/ArrayRef.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Module.h"

namespace anysl::link {

/// Writes operators into functions of one module that are there already.
class OperatorWriter {
public:
  explicit OperatorWriter(llvm::Module &module) : module(module), builder(module.getContext()) {}

  /// Goes on just before an instruction, at its place in the source. `why`: what is written is
  /// there because of that; it has to last as long as the writer is used for it.
  void before(llvm::Instruction &instruction, llvm::StringRef why = "") {
    builder.SetInsertPoint(&instruction);
    cause = why;
  }

  /// Fills `slot` with a constant, or with text if there are no numbers.
  void construct(llvm::Value *slot, stc::Type type, llvm::ArrayRef<double> numbers,
                 llvm::StringRef text = "");

  /// A variable of the function that is written to.
  llvm::Value *alloc(stc::Type type);

  llvm::CallInst *call(stc::Op op, llvm::ArrayRef<llvm::Value *> operands);

  llvm::IRBuilder<> &ir() { return builder; }

private:
  llvm::Module &module;
  llvm::IRBuilder<> builder;
  llvm::StringRef cause;
};

} // namespace anysl::link

#endif
