//===-- lib/STC/Writer.h - writes STC files -----------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// An STC file is LLVM bitcode inside LLVM's own bitcode wrapper, which every LLVM tool reads
// through. The wrapper's header holds a checksum besides. All numbers are little-endian:
//
//   u32 0x0b17c0de   u32 0   u32 offset of the bitcode (32)   u32 its size   u32 0xffffffff
//   u32 "STCh"       u64 xxh3 of the bitcode
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STC_WRITER_H
#define ANYSL_STC_WRITER_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/raw_ostream.h"
#include <optional>

namespace llvm {
class Module;
}

namespace anysl::stc {

/// Writes bitcode with its checksum.
void writeBitcode(const llvm::Module &module, llvm::raw_ostream &out);
/// Writes LLVM's text form.
void writeText(const llvm::Module &module, llvm::raw_ostream &out);

/// What a file's checksum says about it.
enum class Checksum { None, Right, Wrong };
Checksum checkChecksum(llvm::StringRef contents);

} // namespace anysl::stc

#endif
