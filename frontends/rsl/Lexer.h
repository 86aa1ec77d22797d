//===-- frontends/rsl/Lexer.h - characters to words ---------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_LEXER_H
#define ANYSL_FRONTENDS_RSL_LEXER_H

#include "frontends/rsl/Token.h"
#include "lib/Support/Diagnostics.h"
#include "llvm/Support/StringSaver.h"

namespace anysl::rsl {

/// Cuts one buffer into words. White space, comments and spliced lines disappear; keywords are
/// still identifiers, because macros may be named like them. The text need not end with a newline.
class Lexer {
public:
  /// \p text must be followed by a zero byte, as a MemoryBuffer's is. \p saver keeps the spelling
  /// of words that a line splice cuts.
  Lexer(llvm::StringRef text, DiagnosticEngine &diags, llvm::StringSaver &saver)
      : cursor(text.begin()), end(text.end()), diags(diags), saver(saver) {}

  /// The next word. Inside a directive the line's end is EndOfDirective.
  Token next();
  /// The rest of the line as written, for #error and #pragma.
  llvm::StringRef restOfLine();
  /// After #include: `<file>` is one word.
  Token nextHeaderName();

  bool inDirective = false;
  /// In text that a conditional leaves out, an apostrophe or half a string is no error.
  bool skipping = false;

private:
  char peek(unsigned ahead = 0) const { return cursor + ahead < end ? cursor[ahead] : '\0'; }
  unsigned spliceLength(const char *at) const;
  bool skipSplices();
  bool skipBlanks();
  Token make(TokenKind kind, const char *begin);
  void lexNumber();
  bool lexString(const char *begin);
  llvm::StringRef spelling(const char *begin, const char *stop);

  const char *cursor;
  const char *end;
  DiagnosticEngine &diags;
  llvm::StringSaver &saver;
  bool atLineStart = true;
};

} // namespace anysl::rsl

#endif
