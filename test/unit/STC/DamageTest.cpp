//===-- test/unit/STC/DamageTest.cpp - damaged files get an error, never a crash ----*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Verifier.h"
#include "test/unit/STC/Samples.h"
#include <catch2/catch.hpp>
#include <random>

using namespace anysl::stc;

namespace {

/// Changes one to four bytes, or cuts, doubles or inserts a piece.
std::string mutate(std::string contents, std::mt19937 &random) {
  auto position = [&] { return random() % contents.size(); };
  switch (random() % 6) {
  case 0:
    contents.resize(position());
    break;
  case 1:
    contents.insert(position(), contents.substr(position(), 16));
    break;
  case 2:
    contents.erase(position(), 1 + random() % 16);
    break;
  default:
    for (unsigned count = 1 + random() % 4; count; --count)
      contents[position()] = char(random());
  }
  return contents;
}

std::string original(bool checksum) {
  llvm::LLVMContext context;
  auto module = sample::shader(context);
  return checksum ? sample::withChecksum(*module) : sample::plainBitcode(*module);
}

/// Either one error and nothing, or a module that holds the rules.
void checkSurvives(const std::string &contents) {
  llvm::LLVMContext context;
  auto result = sample::read(context, contents);
  if (!result.module) {
    CHECK(result.errors.size() == 1);
    CHECK_FALSE(result.firstError().empty());
  } else {
    CHECK(verify(*result.module->module).empty());
  }
}

} // namespace

TEST_CASE("every change to a file with a checksum is noticed") {
  std::string good = original(true);
  std::mt19937 random(1);
  for (unsigned i = 0; i < 400; ++i) {
    std::string bad = mutate(good, random);
    if (bad == good)
      continue;
    llvm::LLVMContext context;
    auto result = sample::read(context, bad);
    REQUIRE_FALSE(result.module);
    CHECK(result.errors.size() == 1);
  }
}

TEST_CASE("a file with a checksum may be cut anywhere") {
  std::string good = original(true);
  for (size_t length = 0; length < good.size(); length += 1 + length / 16) {
    llvm::LLVMContext context;
    auto result = sample::read(context, good.substr(0, length));
    REQUIRE_FALSE(result.module);
    CHECK(result.errors.size() == 1);
  }
}

TEST_CASE("damaged bitcode without a checksum does not crash the reader") {
  std::string good = original(false);
  std::mt19937 random(2);
  for (unsigned i = 0; i < 300; ++i)
    checkSurvives(mutate(good, random));
}

TEST_CASE("damaged text does not crash the reader") {
  llvm::LLVMContext context;
  std::string good = sample::text(*sample::shader(context));
  std::mt19937 random(3);
  for (unsigned i = 0; i < 200; ++i)
    checkSurvives(mutate(good, random));
}

TEST_CASE("what is no bitcode at all is refused") {
  llvm::LLVMContext context;
  CHECK(sample::read(context, "").firstError() == "the file is empty");
  CHECK_THAT(sample::read(context, "surface mirror() {}").firstError(),
             Catch::Contains("neither bitcode nor LLVM's text form"));
  CHECK_THAT(sample::read(context, "BC\xC0\xDEgarbage!").firstError(), Catch::Contains("bitcode"));
  CHECK_FALSE(sample::read(context, std::string(1 << 16, '\xff')).module);
}
