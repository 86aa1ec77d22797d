//===-- lib/Support/Output.h - files that are whole or not there --------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SUPPORT_OUTPUT_H
#define ANYSL_LIB_SUPPORT_OUTPUT_H

#include "llvm/ADT/STLFunctionalExtras.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

namespace anysl {

class DiagnosticEngine;

/// Writes a file under a temporary name beside `path` and renames it when `write` has succeeded, so
/// that nobody ever sees half a file and an older file survives a failure. The temporary file also
/// goes when the process is killed by a signal. `-` writes to standard output; what is no regular
/// file (/dev/null) is written directly.
///
/// Returns false, with the error reported, if `write` fails or the file cannot be written.
bool writeFile(DiagnosticEngine &diags, llvm::StringRef path,
               llvm::function_ref<llvm::Error(llvm::raw_pwrite_stream &)> write);

/// The same for a producer that needs a name to write to rather than a stream, such as a linker.
/// Not for standard output.
bool writeNamedFile(DiagnosticEngine &diags, llvm::StringRef path,
                    llvm::function_ref<llvm::Error(llvm::StringRef temporary)> write);

} // namespace anysl

#endif
