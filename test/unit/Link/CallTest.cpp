//===-- test/unit/Link/CallTest.cpp - who calls whom --------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Emit/Target.h"
#include "lib/Link/Session.h"
#include "llvm/AsmParser/Parser.h"
#include "llvm/Support/SourceMgr.h"
#include <catch2/catch.hpp>

using namespace llvm;

TEST_CASE("calls left are named once, intrinsics are none") {
  LLVMContext context;
  SMDiagnostic error;
  auto module = parseAssemblyString(R"(
    declare float @llvm.sqrt.f32(float)
    declare void @service(float)
    define void @f(ptr %pointer, float %x) {
      %root = call float @llvm.sqrt.f32(float %x)
      call void @service(float %root)
      call void @service(float %x)
      call void %pointer(float %x)
      ret void
    })",
                                    error, context);
  REQUIRE(module);
  std::vector<std::string> calls = anysl::link::callsIn(*module->getFunction("f"));
  CHECK(calls == std::vector<std::string>{"service", "a service"});
}

TEST_CASE("what is reachable is found through every function between") {
  LLVMContext context;
  SMDiagnostic error;
  auto module = parseAssemblyString(R"(
    define void @a() { call void @b() ret void }
    define void @b() { call void @c() ret void }
    define void @c() { call void @a() ret void }
    define void @d() { ret void })",
                                    error, context);
  REQUIRE(module);
  auto reached = anysl::link::reachableFrom(module->getFunction("a"));
  CHECK(reached.size() == 3);
  CHECK_FALSE(reached.contains(module->getFunction("d")));
}

TEST_CASE("expanded, a function has what it calls once a call") {
  LLVMContext context;
  SMDiagnostic error;
  auto module = parseAssemblyString(R"(
    declare void @service()
    define void @twice() { call void @once() call void @once() call void @service() ret void }
    define void @once() { call void @leaf() ret void }
    define void @leaf() { ret void })",
                                    error, context);
  REQUIRE(module);
  // Calls count themselves: 1, 1 + 1 + 1, and 4 + 3 + 3.
  CHECK(anysl::link::expandedInstructions(*module->getFunction("leaf")) == 1);
  CHECK(anysl::link::expandedInstructions(*module->getFunction("once")) == 3);
  CHECK(anysl::link::expandedInstructions(*module->getFunction("twice")) == 10);
}

TEST_CASE("native widths and features follow from the processor") {
  anysl::DiagnosticEngine diags("link-tests");
  struct {
    const char *cpu;
    unsigned width;
    bool avx2, avx512;
  } expected[] = {
      {"x86-64", 4, false, false}, {"haswell", 8, true, false}, {"skylake-avx512", 16, true, true}};
  for (auto &processor : expected) {
    auto target = anysl::makeTarget(diags, processor.cpu, "x86_64-pc-linux-gnu");
    REQUIRE(target);
    INFO(processor.cpu);
    CHECK(anysl::link::nativeWidth(*target) == processor.width);
    std::string features = "," + anysl::link::cpuFeatures(*target) + ",";
    CHECK((features.find(",avx2,") != std::string::npos) == processor.avx2);
    CHECK((features.find(",avx512f,") != std::string::npos) == processor.avx512);
    CHECK(features.find(",aes,") == std::string::npos);
  }
}
