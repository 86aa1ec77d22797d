//===-- passes/Registry.cpp - make the passes known to a pass builder -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Registry.h"

#include "passes/Vectorize/MathTier.h"
#include "passes/Vectorize/Normalize.h"
#include "passes/Vectorize/Stages.h"
#include "passes/Vectorize/Vectorize.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Passes/PassBuilder.h"

using namespace llvm;

namespace anysl {

/// Reads the text between the brackets of "anysl-vectorize<width=8;verify>". Says what is wrong on
/// standard error, as a pipeline's text has no other place, and returns nothing.
static std::optional<VectorizeOptions> parseOptions(StringRef text) {
  VectorizeOptions options;
  SmallVector<StringRef, 4> items;
  text.split(items, ';', -1, false);
  for (StringRef item : items) {
    if (item.consume_front("width=")) {
      if (!item.getAsInteger(10, options.width) && options.width >= 2 && options.width <= 64 &&
          isPowerOf2_32(options.width))
        continue;
      errs() << "anysl-vectorize: the width must be a power of two from 2 to 64, not '" << item
             << "'\n";
      return std::nullopt;
    }
    if (item == "no-cleanup") {
      options.cleanUp = false;
    } else if (item == "verify") {
      options.verifyEach = true;
    } else if (item == "keep-fp-flags") {
      options.keepFlags = true;
    } else if (item.consume_front("math=")) {
      std::vector<std::string> tiers = mathTiers();
      if (!is_contained(tiers, item)) {
        errs() << "anysl-vectorize: there is no math tier '" << item << "'; there are "
               << join(tiers, ", ") << "\n";
        return std::nullopt;
      }
      options.mathFile = mathTierFile(item);
    } else {
      errs() << "anysl-vectorize: unknown option '" << item
             << "'; there are width=W, math=TIER, keep-fp-flags, no-cleanup and verify\n";
      return std::nullopt;
    }
  }
  return options;
}

void registerPasses(PassBuilder &builder) {
  builder.registerPipelineParsingCallback(
      [](StringRef name, ModulePassManager &manager, ArrayRef<PassBuilder::PipelineElement>) {
#define MODULE_PASS(NAME, EXPRESSION)                                                              \
  if (StringRef text = name; text.consume_front(NAME)) {                                           \
    if (!text.empty() && !(text.consume_front("<") && text.consume_back(">")))                     \
      return false;                                                                                \
    std::optional<VectorizeOptions> parsed = parseOptions(text);                                   \
    if (!parsed)                                                                                   \
      return false;                                                                                \
    VectorizeOptions options = *parsed;                                                            \
    manager.addPass(EXPRESSION);                                                                   \
    return true;                                                                                   \
  }
#include "passes/Passes.def"
        return false;
      });
  builder.registerPipelineParsingCallback(
      [](StringRef name, FunctionPassManager &manager, ArrayRef<PassBuilder::PipelineElement>) {
#define FUNCTION_PASS(NAME, EXPRESSION)                                                            \
  if (name == NAME) {                                                                              \
    manager.addPass(EXPRESSION);                                                                   \
    return true;                                                                                   \
  }
#include "passes/Passes.def"
        return false;
      });
}

} // namespace anysl
