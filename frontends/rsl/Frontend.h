//===-- frontends/rsl/Frontend.h - RSL to subroutine-threaded code ------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_FRONTEND_H
#define ANYSL_FRONTENDS_RSL_FRONTEND_H

#include "frontends/rsl/Preprocessor.h"
#include <memory>

namespace llvm {
class LLVMContext;
class Module;
} // namespace llvm

namespace anysl::rsl {

struct FrontendOptions {
  PreprocessorOptions preprocessor;
  /// What the file is taken to contain, instead of reading it.
  std::optional<llvm::StringRef> text;
  bool isLibrary = false;  ///< functions define operators
  bool debugInfo = false;  ///< native code shall have line tables
  int arrayCapacity = 64;  ///< room in arrays that grow by numbers which are not constant
  bool syntaxOnly = false; ///< stop after checking; a file need not contain a shader
};

struct FrontendResult {
  /// Verified STC; null after an error, and where only the syntax was asked for.
  std::unique_ptr<llvm::Module> module;
  /// All files read, the main one first.
  std::vector<std::string> dependencies;
};

/// The whole front end: characters to words, words to a tree, names and types, STC. Every problem
/// of the shader is reported to \p diags; a module that the verifier refuses is an internal error.
FrontendResult compile(llvm::StringRef path, const FrontendOptions &options,
                       DiagnosticEngine &diags, llvm::LLVMContext &context);

} // namespace anysl::rsl

#endif
