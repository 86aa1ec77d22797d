//===-- tools/rslc/rslc.cpp - compiles RSL shaders --------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Frontend.h"
#include "lib/STC/Shader.h"
#include "lib/STC/Writer.h"
#include "lib/Support/Output.h"
#include "lib/Support/Tool.h"
#include "lib/Support/VerifyDiagnostics.h"
#include "llvm/IR/LLVMContext.h"
#include "llvm/IR/Module.h"
#include "llvm/Support/Path.h"

using namespace llvm;
using namespace anysl;

namespace {

cl::OptionCategory category("rslc");

cl::opt<std::string> input(cl::Positional, cl::desc("FILE.sl"), cl::cat(category));
cl::opt<std::string> output("o",
                            cl::desc("Write to FILE; - is standard output (default: FILE.stc.bc)"),
                            cl::value_desc("FILE"), cl::cat(category));
cl::opt<bool> asText("S", cl::desc("Write readable text"), cl::cat(category));
cl::list<std::string> includeDirs("I", cl::Prefix, cl::desc("Look for included files in DIR"),
                                  cl::value_desc("DIR"), cl::cat(category));
cl::list<std::string> defines("D", cl::Prefix, cl::desc("Define a macro"),
                              cl::value_desc("NAME[=VALUE]"), cl::cat(category));
cl::opt<bool> writeDependencies("MD", cl::desc("Write a dependency file for make"),
                                cl::cat(category));
cl::opt<std::string> dependencyFile("MF", cl::desc("Its name (default: as the output, with .d)"),
                                    cl::value_desc("FILE"), cl::cat(category));
// LLVM's library has taken -W for an option of its own; main() spells it out.
cl::list<std::string> warnings("warning",
                               cl::desc("Also -WNAME. -Wall: all warnings; -Werror: warnings are "
                                        "errors; -WNAME, -Wno-NAME: one of them"),
                               cl::value_desc("NAME"), cl::cat(category));
cl::opt<bool> noWarnings("w", cl::desc("No warnings"), cl::cat(category));
cl::opt<bool> syntaxOnly("fsyntax-only", cl::desc("Only check; write nothing"), cl::cat(category));
cl::opt<unsigned> errorLimit("ferror-limit",
                             cl::desc("Stop after N errors; 0: never (default: 20)"),
                             cl::value_desc("N"), cl::init(20), cl::cat(category));
cl::opt<bool> debugInfo("g", cl::desc("Give native code line tables, for debuggers and profilers"),
                        cl::cat(category));
cl::opt<bool> isLibrary("library", cl::desc("The functions of the file define operators"),
                        cl::cat(category));
cl::opt<unsigned> arrayCapacity("array-capacity",
                                cl::desc("Room in arrays that grow, where no constant says how "
                                         "much they need (default: 64)"),
                                cl::value_desc("N"), cl::init(64), cl::cat(category));
cl::opt<bool> verifyMode("verify",
                         cl::desc("Compare messages with the file's expected-error and "
                                  "expected-warning comments"),
                         cl::cat(category));

/// A misspelt option would otherwise be a warning that never comes.
void checkWarningName(DiagnosticEngine &diags, StringRef name) {
  static const StringRef known[] = {
#define RSL_WARNING(id, option, onByDefault, about) option,
#include "frontends/rsl/Warnings.def"
  };
  if (!is_contained(known, name))
    diags.error("unknown warning option '-W" + name + "'" + didYouMean(name, known));
}

void applyWarnings(DiagnosticEngine &diags) {
  for (StringRef name : warnings) {
    if (name == "all" || name == "extra")
      diags.setAllWarnings(true);
    else if (name == "error")
      diags.setWarningsAsErrors(true);
    else {
      bool isOn = !name.consume_front("no-");
      checkWarningName(diags, name);
      diags.setWarning(name, isOn);
    }
  }
  diags.setNoWarnings(noWarnings);
  diags.setErrorLimit(errorLimit);
}

/// `dir/wood.sl` gives `wood.stc.bc` in the current folder.
std::string outputName() {
  if (!output.empty())
    return output;
  StringRef stem = input == "-" ? "shader" : sys::path::filename(input);
  stem.consume_back(".sl");
  return (stem + (asText ? ".stc.ll" : ".stc.bc")).str();
}

std::string dependencyName() {
  if (!dependencyFile.empty())
    return dependencyFile;
  std::string name = outputName();
  for (StringRef suffix : {".bc", ".ll", ".stc"})
    if (StringRef(name).ends_with(suffix))
      name.resize(name.size() - suffix.size());
  return name + ".d";
}

/// A name as make reads it.
std::string escaped(StringRef name) {
  std::string text;
  for (char c : name) {
    if (c == ' ' || c == '#' || c == '\\')
      text += '\\';
    else if (c == '$')
      text += '$';
    text += c;
  }
  return text;
}

/// One rule for the output, and an empty one for each header, so that make does not mind one that
/// is gone.
Error printDependencies(raw_ostream &out, ArrayRef<std::string> files) {
  out << escaped(outputName()) << ":";
  for (StringRef file : files)
    out << " \\\n  " << escaped(file);
  out << "\n";
  for (StringRef file : files.drop_front())
    out << "\n" << escaped(file) << ":\n";
  return Error::success();
}

} // namespace

int main(int argc, char **argv) {
  std::vector<std::string> words(argv, argv + argc);
  std::vector<char *> pointers;
  for (std::string &word : words) {
    if (StringRef(word).starts_with("-W") && word.size() > 2)
      word = "-warning=" + word.substr(2);
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  argv = pointers.data();
  Tool tool(argc, argv, "rslc", "Compiles RenderMan shaders to subroutine-threaded code", category);
  DiagnosticEngine diags("rslc");
  applyWarnings(diags);
  std::vector<Diagnostic> collected;
  if (verifyMode)
    diags.setConsumer([&](const Diagnostic &diagnostic) { collected.push_back(diagnostic); });

  if (input.empty())
    diags.error("no input file; see rslc --help");
  if (arrayCapacity < 1 || arrayCapacity > stc::maxArrayLength)
    diags.error("--array-capacity must be from 1 to " + Twine(stc::maxArrayLength));
  if (diags.hasErrors())
    return userError;

  rsl::FrontendOptions options;
  options.preprocessor.includeDirs = includeDirs;
  options.preprocessor.defines = defines;
  options.isLibrary = isLibrary;
  options.debugInfo = debugInfo;
  options.arrayCapacity = int(arrayCapacity);
  options.syntaxOnly = syntaxOnly;
  LLVMContext context;
  rsl::FrontendResult result = rsl::compile(input, options, diags, context);
  if (verifyMode)
    return verifyDiagnostics(diags, collected, errs()) ? success : userError;

  if (result.module && !syntaxOnly)
    writeFile(diags, outputName(), [&](raw_pwrite_stream &out) {
      if (asText)
        stc::writeText(*result.module, out);
      else
        stc::writeBitcode(*result.module, out);
      return Error::success();
    });
  if (!diags.hasErrors() && (writeDependencies || !dependencyFile.empty()))
    writeFile(diags, dependencyName(),
              [&](raw_pwrite_stream &out) { return printDependencies(out, result.dependencies); });
  diags.printSummary();
  // Modules and arenas need no orderly end in a process that is about to go.
  return diags.hasErrors() ? userError : success;
}
