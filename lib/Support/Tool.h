//===-- lib/Support/Tool.h - what every command-line program does alike -------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
//   int main(int argc, char **argv) {
//     anysl::Tool tool(argc, argv, "rslc", "Compiles RSL shaders to subroutine-threaded code.");
//     …
//     return diags.hasErrors() ? anysl::userError : anysl::success;
//   }
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SUPPORT_TOOL_H
#define ANYSL_LIB_SUPPORT_TOOL_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/CommandLine.h"
#include "llvm/Support/InitLLVM.h"
#include <string>

namespace anysl {

/// Exit statuses: a wrong input or command line is the user's error, everything that should not be
/// possible is an internal one, which asks for a report.
enum ExitStatus { success = 0, userError = 1, internalError = 2 };

/// Set-up and tear-down of a program. A crash, a failed check inside LLVM or memory running out
/// ends the program with `internalError` and one message that asks for a report.
class Tool {
public:
  /// Parses the command line: options are llvm::cl::opt variables of category `category`, the only
  /// ones that --help shows. --version and --help do not return; a wrong command line ends the
  /// program with `userError`.
  Tool(int &argc, char **&argv, llvm::StringLiteral name, llvm::StringLiteral overview,
       llvm::cl::OptionCategory &category);

  /// The folder of the running program.
  std::string programFolder() const;
  /// The folder of runtimes and libraries, lib/anysl beside the folder of the running program.
  std::string resourceDir() const;

private:
  /// Comes before LLVM's own handlers, which print a stack and ask for a report to LLVM's authors.
  struct CrashHandler {
    explicit CrashHandler(llvm::StringRef name);
  };

  CrashHandler crashes;
  llvm::InitLLVM init;
  const char *program;
};

/// Ends the program with `internalError` and a message.
[[noreturn]] void reportInternalError(const llvm::Twine &message);

} // namespace anysl

#endif
