//===-- lib/STC/Writer.cpp - writes STC files ---------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Writer.h"
#include "llvm/Bitcode/BitcodeWriter.h"
#include "llvm/IR/Module.h"
#include "llvm/Support/EndianStream.h"
#include "llvm/Support/xxhash.h"

using namespace llvm;

namespace anysl::stc {
namespace {

constexpr uint32_t wrapperMagic = 0x0b17c0de;
constexpr uint32_t checksumTag = 0x68435453; // "STCh"
constexpr unsigned tagOffset = 20;
constexpr unsigned headerSize = 32;

SmallString<headerSize> headerFor(StringRef bitcode) {
  SmallString<headerSize> header;
  raw_svector_ostream out(header);
  for (uint32_t field : {wrapperMagic, 0u, headerSize, uint32_t(bitcode.size()), ~0u, checksumTag})
    support::endian::write(out, field, endianness::little);
  support::endian::write(out, xxh3_64bits(bitcode), endianness::little);
  return header;
}

} // namespace

void writeBitcode(const Module &module, raw_ostream &out) {
  SmallString<0> bitcode;
  raw_svector_ostream stream(bitcode);
  WriteBitcodeToFile(module, stream);
  out << headerFor(bitcode) << bitcode;
}

void writeText(const Module &module, raw_ostream &out) { module.print(out, nullptr); }

Checksum checkChecksum(StringRef contents) {
  if (contents.size() < headerSize)
    return Checksum::None;
  const char *data = contents.data();
  if (support::endian::read32le(data) != wrapperMagic ||
      support::endian::read32le(data + tagOffset) != checksumTag)
    return Checksum::None;
  StringRef header = contents.take_front(headerSize);
  return header == headerFor(contents.drop_front(headerSize)) ? Checksum::Right : Checksum::Wrong;
}

} // namespace anysl::stc
