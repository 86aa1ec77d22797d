//===-- frontends/rsl/Frontend.cpp - RSL to subroutine-threaded code --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Frontend.h"

#include "frontends/rsl/Lower.h"
#include "frontends/rsl/Parser.h"
#include "frontends/rsl/Prelude.h"
#include "frontends/rsl/Sema.h"
#include "lib/STC/Verifier.h"
#include "lib/Support/Tool.h"
#include "llvm/IR/Module.h"

using namespace llvm;

namespace anysl::rsl {

FrontendResult compile(StringRef path, const FrontendOptions &options, DiagnosticEngine &diags,
                       LLVMContext &context) {
  FrontendResult result;
  Preprocessor preprocessor(diags, options.preprocessor);
  std::vector<Token> tokens = preprocessor.run(path, options.text);
  result.dependencies = preprocessor.dependencies();
  if (preprocessor.isIncomplete())
    return result;

  Ast ast;
  Preprocessor builtIn(diags, {});
  if (StringRef prelude = preludeFor(tokens); !prelude.empty())
    Parser(builtIn.run("<built-in>", prelude), ast, diags).parseFile();
  ast.firstOwnItem = ast.items.size();
  Parser(std::move(tokens), ast, diags).parseFile();
  Sema(ast, diags, {options.isLibrary, options.arrayCapacity}).check();
  // From here on the tree is correct: lowering has nothing to complain about but a library's
  // operators.
  if (!diags.hasErrors() && ast.shaders.empty() && !ast.hasClasses() && !options.isLibrary &&
      !options.syntaxOnly)
    diags.error(FilePosition{path.str()}, "the file contains no shader");
  if (diags.hasErrors() || options.syntaxOnly)
    return result;

  result.module = lower(ast, diags, context, path, options);
  if (!result.module)
    return result;
  std::vector<stc::Problem> problems = stc::verify(*result.module);
  if (!problems.empty())
    reportInternalError(
        "the front end wrote code that breaks the rules: " + problems[0].position.file + ":" +
        Twine(problems[0].position.line) + ": " + problems[0].message);
  return result;
}

} // namespace anysl::rsl
