//===-- tools/anysl-render/RibLexer.h - words of a RIB file -----------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_RIBLEXER_H
#define ANYSL_RENDER_RIBLEXER_H

#include "tools/anysl-render/Diagnostics.h"

namespace anysl::render {

struct RibToken {
  enum Kind { Request, Number, String, ArrayBegin, ArrayEnd, End } kind = End;
  size_t offset = 0;
  double number = 0;
  std::string text; ///< of a request or string
};

/// Splits the text form of RIB into words. Comments run from # to the line's end.
class RibLexer {
public:
  explicit RibLexer(std::shared_ptr<const SourceFile> file) : file(std::move(file)) {}

  /// The next word. Throws UserError where the text is no word at all.
  RibToken next();
  Location location(size_t offset) const { return {file, offset}; }

private:
  RibToken stringToken();
  RibToken numberToken();

  std::shared_ptr<const SourceFile> file;
  size_t position = 0;
};

} // namespace anysl::render

#endif
