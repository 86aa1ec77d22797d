//===-- lib/STC/Reader.h - reads STC files ------------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Reads STC as bitcode or as LLVM's text form and verifies it, so that what comes out of here never
// crashes a later stage.
//
// Files that the writer made carry a checksum of their contents and are parsed at once: damage
// shows in the checksum. LLVM's parsers trust their input, so anything else (hand-made bitcode,
// text) is first parsed in a child process, which may crash without harm.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STC_READER_H
#define ANYSL_STC_READER_H

#include "lib/STC/Shader.h"
#include "llvm/IR/Module.h"
#include "llvm/Support/MemoryBufferRef.h"
#include <memory>

namespace anysl {
class DiagnosticEngine;
}

namespace anysl::stc {

/// A verified module with its metadata as plain structures, whose functions belong to `module`.
struct StcModule {
  std::unique_ptr<llvm::Module> module;
  /// The file's name as it was given.
  std::string path;
  std::string producer;
  std::vector<ShaderInfo> shaders;
};

/// Reads and verifies a file; `-` is standard input. Reports one error and gives nothing if the
/// file cannot be read, is no STC, is damaged, is of another version or breaks a rule.
std::optional<StcModule> readFile(DiagnosticEngine &diags, llvm::LLVMContext &context,
                                  llvm::StringRef path);
/// The same for contents at hand; the buffer's name stands for the file's.
std::optional<StcModule> readBuffer(DiagnosticEngine &diags, llvm::LLVMContext &context,
                                    llvm::MemoryBufferRef buffer);

/// Whether contents look like STC or any other LLVM bitcode rather than text.
bool isBitcode(llvm::StringRef contents);

} // namespace anysl::stc

#endif
