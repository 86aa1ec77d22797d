//===-- test/unit/rsl/Mutations.cpp - damaged shaders never crash the front end ---------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The example shaders and the front end's own test inputs, with words deleted, doubled, swapped or
// replaced by words from elsewhere: whatever comes out, the compiler must answer with a verified
// module or with errors. A module that the verifier refuses ends the program, so it is found too.
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Frontend.h"
#include "frontends/rsl/Lexer.h"
#include "llvm/IR/LLVMContext.h"
#include "llvm/IR/Module.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include <catch2/catch.hpp>
#include <random>

using namespace llvm;
using namespace anysl;
using namespace anysl::rsl;

namespace {

/// The words of a file as written, white space before each included.
std::vector<std::string> wordsOf(StringRef path) {
  DiagnosticEngine diags("test", nulls());
  unsigned buffer = cantFail(diags.addFile(path));
  StringRef text = diags.text(buffer);
  BumpPtrAllocator allocator;
  StringSaver saver(allocator);
  Lexer lexer(text, diags, saver);
  std::vector<std::string> words;
  const char *last = text.begin();
  for (Token token = lexer.next(); !token.is(TokenKind::End); token = lexer.next()) {
    words.emplace_back(last, token.end.getPointer());
    last = token.end.getPointer();
  }
  return words;
}

std::vector<std::vector<std::string>> allInputs() {
  std::vector<std::vector<std::string>> inputs;
  for (StringRef root : {EXAMPLE_SHADERS, FRONTEND_TESTS}) {
    std::error_code code;
    std::vector<std::string> paths;
    for (sys::fs::recursive_directory_iterator file(root, code), end; file != end && !code;
         file.increment(code))
      // The test of exploding macros takes its time even when it is whole.
      if (StringRef(file->path()).ends_with(".sl") && !StringRef(file->path()).contains("growth"))
        paths.push_back(file->path());
    llvm::sort(paths);
    for (const std::string &path : paths)
      inputs.push_back(wordsOf(path));
  }
  return inputs;
}

/// Compiles a text; true if it gave a module, and never both or neither of a module and errors.
bool compiles(StringRef text, bool isLibrary) {
  DiagnosticEngine diags("test", nulls());
  diags.setAllWarnings(true);
  LLVMContext context;
  FrontendOptions options;
  options.text = text;
  options.isLibrary = isLibrary;
  FrontendResult result = compile("mutation.sl", options, diags, context);
  REQUIRE((result.module != nullptr) != diags.hasErrors());
  return result.module != nullptr;
}

std::string joined(const std::vector<std::string> &words) {
  std::string text;
  for (const std::string &word : words)
    text += word;
  return text;
}

} // namespace

TEST_CASE("damaged shaders give errors or sound modules") {
  std::vector<std::vector<std::string>> inputs = allInputs();
  REQUIRE(inputs.size() > 20);
  std::mt19937 random(20260101);
  auto below = [&](size_t limit) {
    return std::uniform_int_distribution<size_t>(0, limit - 1)(random);
  };
  unsigned whole = 0, broken = 0;
  for (unsigned round = 0; round < 20000; ++round) {
    std::vector<std::string> words = inputs[below(inputs.size())];
    unsigned changes = below(4) ? 1 : 3;
    for (unsigned i = 0; i < changes && !words.empty(); ++i) {
      size_t at = below(words.size());
      const std::vector<std::string> &other = inputs[below(inputs.size())];
      switch (below(13)) {
      case 0:
        words.resize(at);
        break;
      case 1:
      case 2:
      case 3:
        words.erase(words.begin() + static_cast<ptrdiff_t>(at));
        break;
      case 4:
      case 5:
      case 6:
        words.insert(words.begin() + static_cast<ptrdiff_t>(at), words[at]);
        break;
      case 7:
      case 8:
      case 9:
        std::swap(words[at], words[below(words.size())]);
        break;
      default:
        words[at] = " " + other[below(other.size())];
        break;
      }
    }
    std::string text = joined(words);
    CAPTURE(text);
    (compiles(text, round % 8 == 0) ? whole : broken) += 1;
  }
  // Were it all one or the other, the mutations would test little.
  CHECK(whole > 500);
  CHECK(broken > 10000);
}

TEST_CASE("random bytes give errors") {
  std::mt19937 random(7);
  constexpr StringLiteral words = " \n#\"\\/*(){}[];,.<>=+-^!&|?:a1e";
  for (unsigned round = 0; round < 300; ++round) {
    std::string text;
    size_t length = random() % 400;
    for (size_t i = 0; i < length; ++i)
      text += static_cast<char>(round % 2 ? random() % 256 : words[random() % words.size()]);
    CAPTURE(text);
    CHECK_FALSE(compiles(text, false));
  }
}
