//===-- test/unit/Vectorize/KernelTests.cpp - each kernel beside its widened self -------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/Vectorize/Lanes.h"

#include "llvm/IR/LLVMContext.h"
#include "llvm/IRReader/IRReader.h"
#include "llvm/Support/SourceMgr.h"

#include <catch2/catch.hpp>

using namespace anysl::test;

static llvm::Module &kernels() {
  static llvm::LLVMContext context;
  static llvm::SMDiagnostic problem;
  static std::unique_ptr<llvm::Module> module =
      llvm::parseIRFile(ANYSL_TEST_KERNELS, problem, context);
  if (!module)
    throw std::runtime_error(problem.getMessage().str());
  return *module;
}

static void check(const char *name) {
  struct Target {
    unsigned width;
    const char *cpu;
  };
  for (Target target : {Target{4, "x86-64-v2"}, Target{8, "x86-64-v3"}, Target{16, "x86-64-v4"},
                        Target{2, "x86-64-v2"}, Target{32, "x86-64-v3"}}) {
    if (!canRun(target.cpu))
      continue;
    for (bool optimizeScalar : {false, true}) {
      Comparison how;
      how.width = target.width;
      how.cpu = target.cpu;
      how.optimizeScalar = optimizeScalar;
      INFO(name << " on " << target.width << " lanes for " << target.cpu
                << (optimizeScalar ? ", optimised before" : ""));
      CHECK(compareLanes(kernels(), name, how) == "");
    }
  }
}

#define KERNEL(name)                                                                               \
  TEST_CASE("kernel " #name " gives the same bits in every lane", "[kernels]") { check(#name); }
#include "test/unit/Vectorize/Kernels.def"
