//===-- test/unit/Vectorize/FuzzTests.cpp - random functions beside their widened selves ------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Fixed seeds, so that a run can be repeated. ANYSL_FUZZ_COUNT=N tests N functions instead of a
// thousand, ANYSL_FUZZ_FIRST=S starts at another seed, ANYSL_FUZZ_WRITE=DIR writes each failing
// function to a file, which ANYSL_FUZZ_FILE=FILE with the hidden test "[file]" runs again (for
// llvm-reduce; ANYSL_FUZZ_WIDTH, ANYSL_FUZZ_OPTIMIZE and ANYSL_FUZZ_FLAGS say how), ANYSL_DUMP=1
// prints what is compiled.
//
//===------------------------------------------------------------------------------------------===//

#include "test/unit/Vectorize/Generator.h"
#include "test/unit/Vectorize/Lanes.h"

#include "llvm/IR/LLVMContext.h"
#include "llvm/IR/Verifier.h"
#include "llvm/IRReader/IRReader.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/SourceMgr.h"
#include "llvm/Support/raw_ostream.h"

#include <catch2/catch.hpp>

#include <cstdlib>

using namespace anysl::test;

static uint64_t number(const char *name, uint64_t otherwise) {
  const char *text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 0) : otherwise;
}

static void fuzz(uint64_t first, uint64_t count) {
  struct Target {
    unsigned width;
    const char *cpu;
  };
  const Target targets[] = {
      {4, "x86-64-v2"}, {8, "x86-64-v3"}, {16, "x86-64-v4"}, {8, "x86-64-v4"}};
  first = number("ANYSL_FUZZ_FIRST", first);
  count = number("ANYSL_FUZZ_COUNT", count);
  bool verbose = std::getenv("ANYSL_FUZZ_VERBOSE");
  for (uint64_t seed = first; seed < first + count; ++seed) {
    Target target = targets[seed % 4];
    if (!canRun(target.cpu))
      target = {4, "x86-64-v2"};
    if (verbose)
      llvm::errs() << "seed " << seed << "\n";
    llvm::LLVMContext context;
    bool mindsFlags = seed % 5 == 0;
    auto module = generateModule(context, seed, mindsFlags);
    REQUIRE(!llvm::verifyModule(*module, &llvm::errs()));
    Comparison how;
    how.width = target.width;
    how.cpu = target.cpu;
    how.seed = seed;
    how.rounds = 4;
    how.optimizeScalar = seed % 3 == 0;
    // What is tested is IR; good machine code takes most of the time.
    how.optimizeCode = seed % 11 == 0;
    how.mindFlags = mindsFlags;
    INFO("seed " << seed << ", " << target.width << " lanes for " << target.cpu);
    // Written before it is tried, as it may end the program.
    std::string path;
    if (const char *folder = std::getenv("ANYSL_FUZZ_WRITE")) {
      path = std::string(folder) + "/" + std::to_string(seed) + ".ll";
      std::error_code code;
      llvm::raw_fd_ostream file(path, code);
      module->print(file, nullptr);
    }
    std::string difference = compareLanes(*module, "fuzz", how);
    if (difference.empty() && !path.empty())
      llvm::sys::fs::remove(path);
    CHECK(difference == "");
  }
}

TEST_CASE("the function fuzz of a file gives the same bits in every lane", "[.file]") {
  const char *path = std::getenv("ANYSL_FUZZ_FILE");
  REQUIRE(path);
  llvm::LLVMContext context;
  llvm::SMDiagnostic problem;
  auto module = llvm::parseIRFile(path, problem, context);
  REQUIRE(module);
  Comparison how;
  how.width = number("ANYSL_FUZZ_WIDTH", 8);
  how.cpu = how.width == 4 ? "x86-64-v2" : how.width == 8 ? "x86-64-v3" : "x86-64-v4";
  how.rounds = 8;
  how.seed = number("ANYSL_FUZZ_FIRST", 1);
  how.optimizeScalar = number("ANYSL_FUZZ_OPTIMIZE", 0);
  how.mindFlags = number("ANYSL_FUZZ_FLAGS", 0);
  CHECK(compareLanes(*module, "fuzz", how) == "");
}

TEST_CASE("random functions give the same bits in every lane, first part", "[fuzz]") {
  fuzz(1, 1000);
}
TEST_CASE("random functions give the same bits in every lane, second part", "[fuzz]") {
  fuzz(10000, 1000);
}
TEST_CASE("random functions give the same bits in every lane, third part", "[fuzz]") {
  fuzz(20000, 1000);
}
