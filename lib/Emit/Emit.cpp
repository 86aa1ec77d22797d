//===-- lib/Emit/Emit.cpp - from a module to a file ---------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Emit/Emit.h"
#include "lib/Emit/SharedLibrary.h"
#include "lib/Support/Diagnostics.h"
#include "lib/Support/Output.h"
#include "llvm/Analysis/TargetLibraryInfo.h"
#include "llvm/Bitcode/BitcodeWriter.h"
#include "llvm/IR/DebugInfoMetadata.h"
#include "llvm/IR/LegacyPassManager.h"
#include "llvm/Support/Path.h"

using namespace llvm;

namespace anysl {
namespace {

struct KindName {
  OutputKind kind;
  StringLiteral name;
  StringLiteral suffix;
};

constexpr KindName kindNames[] = {{OutputKind::SharedLibrary, "so", ".so"},
                                  {OutputKind::Object, "obj", ".o"},
                                  {OutputKind::Assembly, "asm", ".s"},
                                  {OutputKind::Bitcode, "bc", ".bc"},
                                  {OutputKind::Text, "ll", ".ll"}};

/// Runs code generation into a stream.
Error generateCode(Module &module, TargetMachine &target, CodeGenFileType type,
                   raw_pwrite_stream &out) {
  legacy::PassManager passes;
  TargetLibraryInfoImpl library(target.getTargetTriple());
  library.disableAllFunctions();
  passes.add(new TargetLibraryInfoWrapperPass(library));
  if (target.addPassesToEmitFile(passes, out, nullptr, type))
    return createStringError("LLVM cannot write this kind of file for '" +
                             target.getTargetTriple().str() + "'");
  passes.run(module);
  return Error::success();
}

/// Whether code generation will write line tables.
bool hasDebugInfo(const Module &module) {
  return any_of(module.debug_compile_units(), [](const DICompileUnit *unit) {
    return unit->getEmissionKind() != DICompileUnit::NoDebug;
  });
}

} // namespace

std::optional<OutputKind> outputKindNamed(StringRef name) {
  for (const KindName &entry : kindNames)
    if (entry.name == name)
      return entry.kind;
  return std::nullopt;
}

std::optional<OutputKind> outputKindOfFile(StringRef path) {
  for (const KindName &entry : kindNames)
    if (sys::path::extension(path) == entry.suffix)
      return entry.kind;
  return std::nullopt;
}

StringRef suffixOf(OutputKind kind) {
  for (const KindName &entry : kindNames)
    if (entry.kind == kind)
      return entry.suffix;
  llvm_unreachable("no such kind of output");
}

bool emitModule(DiagnosticEngine &diags, Module &module, TargetMachine &target, OutputKind kind,
                StringRef path) {
  switch (kind) {
  case OutputKind::Text:
    return writeFile(diags, path, [&](raw_pwrite_stream &out) {
      module.print(out, nullptr);
      return Error::success();
    });
  case OutputKind::Bitcode:
    return writeFile(diags, path, [&](raw_pwrite_stream &out) {
      WriteBitcodeToFile(module, out);
      return Error::success();
    });
  case OutputKind::Assembly:
    return writeFile(diags, path, [&](raw_pwrite_stream &out) {
      return generateCode(module, target, CodeGenFileType::AssemblyFile, out);
    });
  case OutputKind::Object:
    return writeFile(diags, path, [&](raw_pwrite_stream &out) {
      return generateCode(module, target, CodeGenFileType::ObjectFile, out);
    });
  case OutputKind::SharedLibrary:
    break;
  }
  if (path == "-") {
    diags.error("a shared library cannot go to standard output");
    return false;
  }
  bool strip = !hasDebugInfo(module);
  SmallString<0> object;
  raw_svector_ostream out(object);
  if (Error error = generateCode(module, target, CodeGenFileType::ObjectFile, out)) {
    diags.error(toString(std::move(error)));
    return false;
  }
  return writeNamedFile(diags, path, [&](StringRef temporary) {
    return linkSharedLibrary(object, temporary, strip);
  });
}

} // namespace anysl
