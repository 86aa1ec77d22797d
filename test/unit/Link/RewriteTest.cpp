//===-- test/unit/Link/RewriteTest.cpp - the small rewrites of linking --------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/AsmParser/Parser.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/Verifier.h"
#include "llvm/Support/SourceMgr.h"
#include <catch2/catch.hpp>

using namespace llvm;

namespace {

std::unique_ptr<Module> parse(LLVMContext &context, StringRef text) {
  SMDiagnostic error;
  auto module = parseAssemblyString(text, error, context);
  INFO(error.getMessage().str());
  REQUIRE(module);
  return module;
}

bool isSound(const Module &module) { return !verifyModule(module, &errs()); }

} // namespace

TEST_CASE("pointers that only give results become returned values") {
  LLVMContext context;
  auto module = parse(context, R"(
    define internal void @ask(i32 %point, ptr %r, ptr %g) noinline {
      %more = icmp sgt i32 %point, 5
      br i1 %more, label %far, label %end
    far:
      store float 9.0, ptr %r
      br label %end
    end:
      store float 1.0, ptr %r
      store float 2.0, ptr %g
      ret void
    }
    define float @user(i32 %point) {
      %r = alloca float
      %g = alloca float
      call void @ask(i32 %point, ptr %r, ptr %g)
      %x = load float, ptr %r
      ret float %x
    })");
  anysl::link::returnOutputs(*module);
  CHECK(isSound(*module));
  Function *ask = module->getFunction("ask");
  REQUIRE(ask);
  CHECK(ask->arg_size() == 1);
  REQUIRE(ask->getReturnType()->isStructTy());
  CHECK(ask->getReturnType()->getStructNumElements() == 2);
  CHECK(ask->hasFnAttribute(Attribute::NoInline));
}

TEST_CASE("a pointer that is more than a result stays one") {
  // In turn: read as well, handed on, not written on every way, used by a function that others see.
  for (const char *text : {R"(
    define internal void @ask(ptr %r) {
      %old = load float, ptr %r
      store float 1.0, ptr %r
      ret void
    })",
                           R"(
    declare void @other(ptr)
    define internal void @ask(ptr %r) {
      store float 1.0, ptr %r
      call void @other(ptr %r)
      ret void
    })",
                           R"(
    define internal void @ask(ptr %r) {
      br i1 poison, label %write, label %end
    write:
      store float 1.0, ptr %r
      br label %end
    end:
      ret void
    })",
                           R"(
    define void @ask(ptr %r) {
      store float 1.0, ptr %r
      ret void
    })"}) {
    LLVMContext context;
    auto module = parse(context, text);
    anysl::link::returnOutputs(*module);
    INFO(text);
    CHECK(isSound(*module));
    CHECK(module->getFunction("ask")->arg_size() == 1);
    CHECK(module->getFunction("ask")->getReturnType()->isVoidTy());
  }
}

TEST_CASE("a function whose address is taken keeps its pointers") {
  LLVMContext context;
  auto module = parse(context, R"(
    @table = global ptr @ask
    define internal void @ask(ptr %r) {
      store float 1.0, ptr %r
      ret void
    })");
  anysl::link::returnOutputs(*module);
  CHECK(module->getFunction("ask")->arg_size() == 1);
}

TEST_CASE("a batch and its tables are invariant, its arrays are not") {
  LLVMContext context;
  auto module = parse(context, R"(
    define float @shade(ptr %args, i32 %point) {
      %field = getelementptr i8, ptr %args, i64 32
      %table = load ptr, ptr %field
      %entry = getelementptr ptr, ptr %table, i64 3
      %array = load ptr, ptr %entry
      %element = getelementptr float, ptr %array, i32 %point
      %value = load float, ptr %element
      ret float %value
    })");
  Function *shade = module->getFunction("shade");
  anysl::link::markInvariants(*shade);
  for (Instruction &instruction : instructions(shade)) {
    if (!isa<LoadInst>(instruction))
      continue;
    bool marked = instruction.hasMetadata(LLVMContext::MD_invariant_load);
    INFO(instruction.getName().str());
    CHECK(marked == (instruction.getName() != "value"));
  }
}
