//===-- test/unit/STC/Samples.cpp - modules to test with ----------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/STC/Samples.h"
#include "lib/STC/Builder.h"
#include "lib/STC/Writer.h"
#include "llvm/Bitcode/BitcodeWriter.h"

using namespace anysl::stc;

namespace sample {
namespace {

/// void brighten(InOut(color) c, In(float) by): a function of the module's own.
llvm::Function *buildHelper(Builder &b) {
  llvm::Function *helper = b.beginFunction(
      "brighten", ResultKind::None,
      {OpParam{ParamKind::InOut, Type::colorTy}, OpParam{ParamKind::In, Type::floatTy}});
  b.call(Op::scale_color, {helper->getArg(0), helper->getArg(0), helper->getArg(1)});
  b.ir().CreateRetVoid();
  return helper;
}

/// Kd = 0.5 unless the host has set it.
llvm::Function *buildInit(Builder &b) {
  llvm::Function *init = b.beginFunction("sample.init");
  llvm::Value *set = b.call(Op::param_is_set, {b.context(), b.id(0)});
  llvm::BasicBlock *compute = b.block("default"), *end = b.block("end");
  b.ir().CreateCondBr(set, end, compute);
  b.ir().SetInsertPoint(compute);
  llvm::Value *value = b.alloc(Type::floatTy, "Kd", Storage::Uniform);
  b.call(Op::const_float, {value, b.number(0.5)});
  b.call(Op::store_param_float, {b.context(), b.id(0), value});
  b.ir().CreateBr(end);
  b.ir().SetInsertPoint(end);
  b.ir().CreateRetVoid();
  return init;
}

/// Sums the four elements of an array that holds Kd, and brightens Cs by it where u < Kd.
llvm::Function *buildBody(Builder &b, llvm::Function *helper) {
  llvm::Function *body = b.beginFunction("sample");
  llvm::Value *kd = b.alloc(Type::floatTy, "Kd", Storage::Uniform);
  llvm::Value *u = b.alloc(Type::floatTy, "u", Storage::Varying);
  llvm::Value *sum = b.alloc(Type::floatTy, "sum", Storage::Varying);
  llvm::Value *color = b.alloc(Type::colorTy, "Ci", Storage::Varying);
  llvm::Value *name = b.alloc(Type::stringTy, "space", Storage::Uniform);
  llvm::Value *array = b.allocArray(Type::floatTy, 4, "values", Storage::Varying);
  b.call(Op::load_param_float, {kd, b.context(), b.id(0)});
  b.call(Op::load_global_float, {u, b.context(), b.id(8)});
  b.call(Op::load_global_color, {color, b.context(), b.id(4)});
  b.call(Op::const_string, {name, b.text("hsv")});

  llvm::BasicBlock *before = b.ir().GetInsertBlock();
  llvm::BasicBlock *loop = b.block("loop"), *after = b.block("after");
  b.ir().CreateBr(loop);
  b.ir().SetInsertPoint(loop);
  llvm::PHINode *i = b.ir().CreatePHI(b.ir().getInt32Ty(), 2, "i");
  b.setLocation("included.h", 7, 3);
  llvm::Value *element = b.element(array, i);
  b.call(Op::copy_float, {element, kd});
  b.call(Op::add_float, {sum, sum, element});
  b.setLocation("sample.sl", 5, 9);
  llvm::Value *next = b.ir().CreateAdd(i, b.index(1));
  i->addIncoming(b.index(0), before);
  i->addIncoming(next, loop);
  b.ir().CreateCondBr(b.ir().CreateICmpSLT(next, b.index(4)), loop, after);

  b.ir().SetInsertPoint(after);
  llvm::BasicBlock *yes = b.block("yes"), *end = b.block("end");
  llvm::Value *less = b.call(Op::lt_float, {u, kd});
  llvm::Value *equal = b.call(Op::eq_float, {u, kd});
  b.ir().CreateCondBr(b.ir().CreateOr(less, equal), yes, end);
  b.ir().SetInsertPoint(yes);
  b.callFunction(helper, {color, sum});
  b.ir().CreateBr(end);
  b.ir().SetInsertPoint(end);
  b.call(Op::store_global_color, {b.context(), b.id(6), color});
  b.ir().CreateRetVoid();
  return body;
}

} // namespace

std::unique_ptr<llvm::Module> shader(llvm::LLVMContext &context) {
  Builder b(context, "sample.sl", "test 1.0");
  b.setLocation("sample.sl", 1, 1);
  llvm::Function *helper = buildHelper(b);
  ShaderInfo info;
  info.name = "sample";
  info.kind = ShaderKind::Surface;
  info.init = buildInit(b);
  b.setLocation("sample.sl", 3, 5);
  info.body = buildBody(b, helper);
  info.params = {{"Kd", Type::floatTy, Storage::Uniform, false, 0, 0},
                 {"Cout", Type::colorTy, Storage::Varying, true, 2, 1}};
  info.globals = {{4, true, false}, {6, false, true}, {8, true, false}};
  b.addShader(info);
  return b.finish();
}

std::string withChecksum(const llvm::Module &module) {
  std::string contents;
  llvm::raw_string_ostream out(contents);
  writeBitcode(module, out);
  return contents;
}

std::string plainBitcode(const llvm::Module &module) {
  std::string contents;
  llvm::raw_string_ostream out(contents);
  llvm::WriteBitcodeToFile(module, out);
  return contents;
}

std::string text(const llvm::Module &module) {
  std::string contents;
  llvm::raw_string_ostream out(contents);
  writeText(module, out);
  return contents;
}

ReadResult read(llvm::LLVMContext &context, llvm::StringRef contents) {
  ReadResult result;
  anysl::DiagnosticEngine diags("test");
  diags.setConsumer([&](const anysl::Diagnostic &error) { result.errors.push_back(error); });
  result.module = readBuffer(diags, context, llvm::MemoryBufferRef(contents, "sample.stc.bc"));
  return result;
}

} // namespace sample
