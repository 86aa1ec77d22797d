//===-- lib/Emit/Emit.h - from a module to a file -----------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_EMIT_EMIT_H
#define ANYSL_LIB_EMIT_EMIT_H

#include "llvm/ADT/StringRef.h"
#include "llvm/IR/Module.h"
#include "llvm/Target/TargetMachine.h"
#include <optional>

namespace anysl {

class DiagnosticEngine;

enum class OutputKind { SharedLibrary, Object, Assembly, Bitcode, Text };

/// The kind of a name as --emit has it: so, obj, asm, bc, ll.
std::optional<OutputKind> outputKindNamed(llvm::StringRef name);
/// The kind that a file name's suffix stands for: .so .o .s .bc .ll.
std::optional<OutputKind> outputKindOfFile(llvm::StringRef path);
/// The suffix of a kind, with its dot.
llvm::StringRef suffixOf(OutputKind kind);

/// Writes a module. The file is there afterwards and whole, or nothing has changed and an error has
/// been reported. A shared library exports what the module does, and needs libc and libm only where
/// the code calls them. Native code is made from the module in place, which is of no use
/// afterwards. `-` writes to standard output, unless it is a shared library.
bool emitModule(DiagnosticEngine &diags, llvm::Module &module, llvm::TargetMachine &target,
                OutputKind kind, llvm::StringRef path);

} // namespace anysl

#endif
