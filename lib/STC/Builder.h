//===-- lib/STC/Builder.h - writes subroutine-threaded code -------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The one way in which front ends make STC. The builder knows the operators' signatures and holds
// every operand against them (by assertions: a wrong operand is a bug of the front end), declares
// operators and type symbols as they are used, keeps allocations in the entry block, gives every
// call a debug location, and writes the metadata.
//
// Control flow, `i1` logic and `i32` counters are plain LLVM: use `ir()`, and nothing of it beyond
// what docs/architecture.md allows.
//
//   stc::Builder b(context, "mirror.sl", "rslc 0.1.0");
//   stc::ShaderInfo shader;
//   b.setLocation("mirror.sl", 1, 1);
//   shader.init = b.beginFunction("mirror.init");
//   b.ir().CreateRetVoid();
//   shader.body = b.beginFunction("mirror");
//   auto *dir = b.alloc(Type::vectorTy, "dir", Storage::Varying);
//   b.call(Op::reflect, {dir, I, N});
//   …
//   b.addShader(shader);
//   std::unique_ptr<llvm::Module> module = b.finish();
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STC_BUILDER_H
#define ANYSL_STC_BUILDER_H

#include "lib/STC/Shader.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/IR/DIBuilder.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Module.h"
#include <memory>

namespace anysl::stc {

class Builder {
public:
  /// Starts a module for `sourceFile`; `producer` is the front end's name and version. Positions
  /// are always recorded; with `debugInfo` (-g) they also reach the native code as line tables.
  Builder(llvm::LLVMContext &context, llvm::StringRef sourceFile, llvm::StringRef producer,
          bool debugInfo = false);
  ~Builder();

  llvm::Module &module() { return *mod; }
  /// For branches, `i1` logic and counters. Its insertion point is where `call` puts operators.
  llvm::IRBuilder<> &ir() { return builder; }

  /// Everything added from here on stands at this place of the source; `file` may differ from the
  /// module's own (an included file). A location must be set before the first function begins.
  void setLocation(llvm::StringRef file, unsigned line, unsigned column);

  /// Begins a function `void name(ptr ctx)`, a shader's body or init, and continues in its entry.
  llvm::Function *beginFunction(llvm::StringRef name);
  /// Begins the definition of an operator, for the shading library. Parameters as in the table.
  llvm::Function *beginOperator(Op op);
  /// Begins a function of the module's own, called by `callFunction`.
  llvm::Function *beginFunction(llvm::StringRef name, ResultKind result,
                                llvm::ArrayRef<OpParam> params);
  /// The function being written.
  llvm::Function *function() const { return current; }
  /// Its context argument; null if it has none (an operator without `Ctx`).
  llvm::Value *context() const;
  /// Appends a basic block to the function being written.
  llvm::BasicBlock *block(llvm::StringRef name);

  /// A slot for one value, made in the entry block.
  llvm::Value *alloc(Type type, llvm::StringRef name, Storage storage);
  /// A slot for `length` values.
  llvm::Value *allocArray(Type type, unsigned length, llvm::StringRef name, Storage storage);
  /// The slot of one element of an array (from allocArray or an array argument).
  llvm::Value *element(llvm::Value *array, llvm::Value *index);

  /// Calls an operator. Gives the i1 or i32 of a Test or Index operator, else the call itself.
  llvm::Value *call(Op op, llvm::ArrayRef<llvm::Value *> operands);
  /// Calls a function of the module's own.
  llvm::Value *callFunction(llvm::Function *callee, llvm::ArrayRef<llvm::Value *> operands);

  // Operands that are no slots.
  llvm::Constant *id(unsigned number) { return builder.getInt32(number); }
  llvm::Constant *length(unsigned number) { return builder.getInt32(number); }
  llvm::Constant *index(int number) { return builder.getInt32(uint32_t(number)); }
  llvm::Constant *number(double value);
  /// Constant text, without NUL in it; equal texts share one constant.
  llvm::Constant *text(llvm::StringRef value);
  llvm::Constant *typeSymbol(Type type);

  /// Writes a shader's metadata, when its functions and its globals' use are complete.
  void addShader(const ShaderInfo &shader);

  /// Ends the module: completes debug information and hands it over. Only destruction may follow.
  std::unique_ptr<llvm::Module> finish();

private:
  llvm::Function *begin(llvm::Function *created);
  llvm::CallInst *makeCall(llvm::Function *callee, llvm::ArrayRef<llvm::Value *> operands);
  llvm::CallInst *makeAlloc(Op op, llvm::ArrayRef<llvm::Value *> operands, llvm::StringRef name,
                            Storage storage);
  llvm::Function *declaration(Op op);
  llvm::DIFile *fileNamed(llvm::StringRef path);
  llvm::DILocation *location();

  std::unique_ptr<llvm::Module> mod;
  llvm::IRBuilder<> builder;
  llvm::DIBuilder debug;
  llvm::StringMap<llvm::DIFile *> files;
  llvm::StringMap<llvm::Constant *> texts;
  llvm::Function *current = nullptr;
  llvm::CallInst *lastAlloc = nullptr;
  struct {
    std::string file;
    unsigned line = 0;
    unsigned column = 0;
  } place;
};

} // namespace anysl::stc

#endif
