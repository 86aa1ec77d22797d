//===-- frontends/rsl/Token.h - the words of a shader -------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_TOKEN_H
#define ANYSL_FRONTENDS_RSL_TOKEN_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/SMLoc.h"
#include <cstdint>

namespace anysl::rsl {

enum class TokenKind : uint8_t {
#define RSL_TOKEN(name, spelling) name,
#include "frontends/rsl/Tokens.def"
};

/// How a kind is shown to people: `';'`, `'surface'`, `a number`.
llvm::StringRef describe(TokenKind kind);

/// The keyword that an identifier is, or TokenKind::Identifier.
TokenKind keywordKind(llvm::StringRef text);

struct Token {
  TokenKind kind = TokenKind::End;
  bool startsLine = false;  ///< first on its line: a # here opens a directive
  bool afterSpace = false;  ///< white space or a comment stands before it
  bool neverExpand = false; ///< a macro's own name inside its expansion
  llvm::SMLoc loc;          ///< where messages point: for a macro's token, the macro's use
  llvm::SMLoc end;
  llvm::StringRef text; ///< its characters, line splices removed; strings keep their quotes

  bool is(TokenKind other) const { return kind == other; }
  bool isKeyword() const { return kind >= TokenKind::KwFloat; }
  template <typename... Kinds>
  bool isOneOf(Kinds... kinds) const {
    return (is(kinds) || ...);
  }
  llvm::SMRange range() const { return {loc, end}; }
};

} // namespace anysl::rsl

#endif
