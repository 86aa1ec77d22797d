//===-- lib/Support/Tool.cpp - what every command-line program does alike -----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Support/Tool.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/Support/ErrorHandling.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/Signals.h"
#include "llvm/Support/raw_ostream.h"
#include <unistd.h>

using namespace llvm;

namespace anysl {
namespace {

std::string toolName = "anysl";

std::string internalErrorText(StringRef reason) {
  return toolName + ": internal error: " + reason.str() + "\n" + toolName +
         ": this is a mistake of AnySL's, not of your shader; please report it with the command "
         "line and the input files\n";
}

void onFatalError(void *, const char *reason, bool) {
  errs() << internalErrorText(reason);
  sys::RunInterruptHandlers();
  _exit(internalError);
}

/// In a signal handler nothing may be allocated, so the message was made before.
std::string &crashText() {
  static std::string text;
  return text;
}

void onCrash(void *) {
  [[maybe_unused]] ssize_t written = write(STDERR_FILENO, crashText().data(), crashText().size());
  _exit(internalError);
}

void printVersion(raw_ostream &out) {
  out << toolName << " (AnySL " ANYSL_VERSION ", LLVM " LLVM_VERSION_STRING ")\n";
}

} // namespace

Tool::CrashHandler::CrashHandler(StringRef name) {
  toolName = name.str();
  crashText() = internalErrorText("the program crashed");
  sys::AddSignalHandler(onCrash, nullptr);
}

Tool::Tool(int &argc, char **&argv, StringLiteral name, StringLiteral overview,
           cl::OptionCategory &category)
    : crashes(name), init(argc, argv, /*InstallPipeSignalExitHandler=*/true), program(argv[0]) {
  remove_fatal_error_handler();
  install_fatal_error_handler(onFatalError);
  remove_bad_alloc_error_handler();
  install_bad_alloc_error_handler(onFatalError);
  cl::HideUnrelatedOptions(category);
  cl::SetVersionPrinter(printVersion);
  cl::ParseCommandLineOptions(argc, argv, overview);
  // The values stay; the names go, because lld registers options of its own (-mcpu) when it runs.
  SmallVector<cl::Option *> own;
  for (auto &entry : cl::getRegisteredOptions())
    if (is_contained(entry.second->Categories, &category))
      own.push_back(entry.second);
  for (cl::Option *option : own)
    option->removeArgument();
}

std::string Tool::programFolder() const {
  std::string path = sys::fs::getMainExecutable(program, reinterpret_cast<void *>(printVersion));
  return sys::path::parent_path(path).str();
}

std::string Tool::resourceDir() const {
  SmallString<256> path(programFolder());
  sys::path::append(path, "..", "lib", "anysl");
  sys::path::remove_dots(path, /*remove_dot_dot=*/true);
  return path.str().str();
}

void reportInternalError(const Twine &message) {
  onFatalError(nullptr, message.str().c_str(), false);
  llvm_unreachable("the handler does not return");
}

} // namespace anysl
