//===-- test/fuzz/RslcFuzzer.cpp - whatever rslc reads, it answers ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A libFuzzer target: the front end must answer any text with a verified module or with errors. It
// runs under AddressSanitizer and UndefinedBehaviorSanitizer; a module that the verifier refuses is
// an internal error and ends the program too. The mutator moves words of the language about, since
// changed bytes alone hardly ever get past the parser.
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Frontend.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/IR/LLVMContext.h"
#include "llvm/IR/Module.h"
#include <random>

using namespace llvm;
using namespace anysl;

extern "C" size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t maxSize);
extern "C" size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t maxSize, unsigned seed);
extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

namespace {

const StringRef words[] = {
#define RSL_TOKEN(name, description)
#define RSL_PUNCTUATOR(name, spelling) spelling,
#define RSL_KEYWORD(name, spelling) spelling,
#include "frontends/rsl/Tokens.def"
#define RSL_BUILTIN(result, name, operands, op, meaning) #name,
#include "frontends/rsl/Builtins.def"
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) #name,
#include <anysl/Globals.def>
    "x", "a[3]", "0", "1.5", "\"shader\"", "#define M(a) a", "#if 1", "#endif", "\n",
};

bool isWordCharacter(char c) { return llvm::isAlnum(c) || c == '_'; }

/// A text cut where words begin.
std::vector<std::string> split(StringRef text) {
  std::vector<std::string> parts;
  for (size_t i = 0; i < text.size();) {
    size_t end = i + 1;
    while (end < text.size() && isWordCharacter(text[i]) && isWordCharacter(text[end]))
      ++end;
    parts.push_back(text.slice(i, end).str());
    i = end;
  }
  return parts;
}

} // namespace

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t maxSize,
                                          unsigned seed) {
  std::minstd_rand random(seed);
  auto below = [&](size_t limit) { return size_t(random()) % limit; };
  if (below(4) == 0)
    return LLVMFuzzerMutate(data, size, maxSize);
  std::vector<std::string> parts = split({reinterpret_cast<const char *>(data), size});
  for (size_t changes = 1 + below(3); changes; --changes) {
    size_t at = below(parts.size() + 1);
    std::string word = (" " + words[below(std::size(words))] + " ").str();
    if (at == parts.size() || below(3) == 0) {
      parts.insert(parts.begin() + ptrdiff_t(at), word);
    } else if (below(2)) {
      // A stretch of the text goes elsewhere: whole declarations and statements, now and then.
      size_t last = std::min(parts.size(), at + 1 + below(12)), to = below(parts.size() + 1);
      std::vector<std::string> moved(parts.begin() + ptrdiff_t(at), parts.begin() + ptrdiff_t(last));
      if (below(2))
        parts.erase(parts.begin() + ptrdiff_t(at), parts.begin() + ptrdiff_t(last));
      to = std::min(to, parts.size());
      parts.insert(parts.begin() + ptrdiff_t(to), moved.begin(), moved.end());
    } else if (below(2)) {
      parts[at] = word;
    } else {
      parts.erase(parts.begin() + ptrdiff_t(at));
    }
  }
  size_t length = 0;
  for (const std::string &part : parts)
    for (char c : part)
      if (length < maxSize)
        data[length++] = uint8_t(c);
  return length;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  DiagnosticEngine diags("fuzzer", nulls());
  diags.setAllWarnings(true);
  LLVMContext context;
  rsl::FrontendOptions options;
  options.preprocessor.maxTokens = 1u << 16; // as strange as more of them, and sooner done
  options.text = StringRef(reinterpret_cast<const char *>(data), size);
  rsl::FrontendResult result = rsl::compile("fuzzer.sl", options, diags, context);
  if ((result.module != nullptr) == diags.hasErrors())
    report_fatal_error("neither a module nor an error, or both");
  return 0;
}
