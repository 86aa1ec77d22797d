//===-- tools/anysl-info/anysl-info.cpp - says what is in a file of shaders -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Support/Tool.h"
#include "tools/anysl-info/Description.h"
#include "llvm/BinaryFormat/Magic.h"

using namespace llvm;

static cl::OptionCategory category("anysl-info options");
static cl::opt<std::string> path(cl::Positional, cl::Required, cl::desc("FILE.stc.bc | FILE.so"),
                                 cl::cat(category));
static cl::opt<bool> json("json", cl::desc("Print JSON"), cl::cat(category));

static bool isElf(const std::string &file) {
  file_magic magic;
  return !identify_magic(file, magic) && magic.is_object() && magic != file_magic::bitcode;
}

int main(int argc, char **argv) {
  anysl::Tool tool(argc, argv, "anysl-info",
                   "Says what is in a compiled shader library or an STC file: shaders, parameters\n"
                   "and defaults, globals read and written, what is asked of the renderer.",
                   category);
  anysl::DiagnosticEngine diags("anysl-info");
  auto description = isElf(path) ? anysl::info::describeLibrary(diags, path)
                                 : anysl::info::describeStc(diags, path);
  if (!description)
    return anysl::userError;
  if (json)
    anysl::info::printJson(*description, outs());
  else
    anysl::info::printText(*description, outs());
  return anysl::success;
}
