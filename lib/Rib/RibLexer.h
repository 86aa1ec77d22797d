//===-- lib/Rib/RibLexer.h - words of a RIB file ----------------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_RIB_RIBLEXER_H
#define ANYSL_LIB_RIB_RIBLEXER_H

#include "lib/Rib/Diagnostics.h"

#include <cstdint>
#include <map>

namespace anysl::render {

struct RibToken {
  enum Kind { Request, Number, String, ArrayBegin, ArrayEnd, End, Nothing } kind = End;
  size_t offset = 0;
  double number = 0;
  std::string text; ///< of a request or string
};

/// Splits RIB into words, text and binary form mixed as they may be. Comments run from # to the
/// line's end.
class RibLexer {
public:
  explicit RibLexer(std::shared_ptr<const SourceFile> file) : file(std::move(file)) {}

  /// The next word. Throws UserError where the text is no word at all.
  RibToken next();
  Location location(size_t offset) const { return {file, offset}; }

private:
  RibToken word();
  RibToken stringToken();
  RibToken numberToken();

  // The binary form (RibBinary.cpp)
  RibToken binaryToken(unsigned char code);
  RibToken arrayToken();
  void defineRequest(size_t begin);
  void defineString(size_t begin, unsigned size);
  uint64_t binaryNumber(unsigned bytes, size_t begin);
  std::string binaryText(uint64_t length, size_t begin);
  std::string definition(size_t begin);

  std::shared_ptr<const SourceFile> file;
  size_t position = 0;
  size_t floatsLeft = 0; ///< of a binary array that has begun
  bool endsFloats = false, defining = false;
  std::map<unsigned, std::string> requests;
  std::map<uint64_t, std::string> strings;
};

} // namespace anysl::render

#endif
