//===-- test/unit/STC/BuilderTest.cpp - what is written is what is read -------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Verifier.h"
#include "lib/STC/Writer.h"
#include "test/unit/STC/Samples.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include <catch2/catch.hpp>

using namespace anysl::stc;

namespace {

void checkShader(const ShaderInfo &shader) {
  CHECK(shader.name == "sample");
  CHECK(shader.kind == ShaderKind::Surface);
  REQUIRE(shader.body);
  CHECK(shader.body->getName() == "sample");
  CHECK(shader.init->getName() == "sample.init");
  REQUIRE(shader.params.size() == 2);
  CHECK(shader.params[0].name == "Kd");
  CHECK(shader.params[0].storage == Storage::Uniform);
  CHECK(shader.params[1].type == Type::colorTy);
  CHECK(shader.params[1].output);
  CHECK(shader.params[1].arrayLength == 2);
  CHECK(shader.params[1].cellCount() == 6);
  CHECK(shader.cellCount() == 7);
  CHECK(shader.paramOfCell(0) == &shader.params[0]);
  CHECK(shader.paramOfCell(6) == &shader.params[1]);
  CHECK(shader.paramOfCell(7) == nullptr);
  REQUIRE(shader.globals.size() == 3);
  CHECK(shader.globals[1].id == 6);
  CHECK(shader.globals[1].written);
  CHECK_FALSE(shader.globals[1].read);
}

} // namespace

TEST_CASE("what the builder makes passes the verifier") {
  llvm::LLVMContext context;
  auto module = sample::shader(context);
  std::vector<Problem> problems = verify(*module);
  for (const Problem &problem : problems)
    FAIL_CHECK(problem.message);
  CHECK(problems.empty());
}

TEST_CASE("every form of a file reads back the same") {
  llvm::LLVMContext context;
  auto module = sample::shader(context);
  for (const std::string &contents :
       {sample::withChecksum(*module), sample::plainBitcode(*module), sample::text(*module)}) {
    llvm::LLVMContext fresh;
    auto result = sample::read(fresh, contents);
    INFO(result.firstError());
    REQUIRE(result.module);
    CHECK(result.errors.empty());
    CHECK(result.module->producer == "test 1.0");
    REQUIRE(result.module->shaders.size() == 1);
    checkShader(result.module->shaders[0]);
  }
}

TEST_CASE("equal modules give equal files") {
  llvm::LLVMContext first, second;
  CHECK(sample::withChecksum(*sample::shader(first)) ==
        sample::withChecksum(*sample::shader(second)));
}

TEST_CASE("a checksum is found right, wrong or missing") {
  llvm::LLVMContext context;
  auto module = sample::shader(context);
  std::string contents = sample::withChecksum(*module);
  CHECK(checkChecksum(contents) == Checksum::Right);
  CHECK(checkChecksum(sample::plainBitcode(*module)) == Checksum::None);
  CHECK(checkChecksum(sample::text(*module)) == Checksum::None);
  contents.back() ^= 1;
  CHECK(checkChecksum(contents) == Checksum::Wrong);
}

TEST_CASE("positions survive, those of included files too") {
  llvm::LLVMContext context;
  auto module = sample::shader(context);
  bool seen = false;
  for (llvm::Instruction &instruction : llvm::instructions(module->getFunction("sample"))) {
    auto *call = llvm::dyn_cast<llvm::CallInst>(&instruction);
    if (!call || call->getCalledFunction()->getName() != "anysl_copy_float")
      continue;
    seen = true;
    anysl::FilePosition position = positionOf(*call);
    CHECK(position.file == "included.h");
    CHECK(position.line == 7);
    CHECK(position.column == 3);
  }
  CHECK(seen);
}

TEST_CASE("allocations stand in the entry block, wherever they are asked for") {
  llvm::LLVMContext context;
  auto module = sample::shader(context);
  llvm::Function *init = module->getFunction("sample.init");
  for (llvm::Instruction &instruction : llvm::instructions(init))
    if (auto *call = llvm::dyn_cast<llvm::CallInst>(&instruction))
      if (call->getCalledFunction()->getName() == "anysl_alloc") {
        CHECK(call->getParent() == &init->getEntryBlock());
        REQUIRE(slotInfo(call));
        CHECK(slotInfo(call)->type == Type::floatTy);
        CHECK(call->getMetadata("anysl.name"));
        CHECK(call->getMetadata("anysl.storage"));
      }
}
