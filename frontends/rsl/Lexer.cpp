//===-- frontends/rsl/Lexer.cpp - characters to words -----------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lexer.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringSwitch.h"

using namespace llvm;

namespace anysl::rsl {

StringRef describe(TokenKind kind) {
  switch (kind) {
#define RSL_TOKEN(name, description)                                                               \
  case TokenKind::name:                                                                            \
    return description;
#include "frontends/rsl/Tokens.def"
  }
  llvm_unreachable("unknown token kind");
}

TokenKind keywordKind(StringRef text) {
  return StringSwitch<TokenKind>(text)
#define RSL_KEYWORD(name, spelling) .Case(spelling, TokenKind::name)
#include "frontends/rsl/Tokens.def"
      .Default(TokenKind::Identifier);
}

static bool startsName(char c) { return isAlpha(c) || c == '_'; }
static bool continuesName(char c) { return isAlnum(c) || c == '_'; }

/// Length of a backslash and newline at a place, 0 where there is none. Blanks between the two are
/// accepted, as other preprocessors do.
unsigned Lexer::spliceLength(const char *at) const {
  if (at >= end || *at != '\\')
    return 0;
  const char *after = at + 1;
  while (after < end && (*after == ' ' || *after == '\t'))
    ++after;
  if (after == end)
    return static_cast<unsigned>(after - at);
  return *after == '\n' ? static_cast<unsigned>(after + 1 - at) : 0;
}

bool Lexer::skipSplices() {
  bool any = false;
  while (unsigned length = spliceLength(cursor)) {
    cursor += length;
    any = true;
  }
  return any;
}

/// Skips white space and comments; stops at a newline inside a directive. Returns whether there was
/// any.
bool Lexer::skipBlanks() {
  const char *begin = cursor;
  while (cursor < end) {
    if (skipSplices())
      continue;
    char c = *cursor;
    if (c == '\n') {
      if (inDirective)
        break;
      atLineStart = true;
      ++cursor;
    } else if (c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0' || c == '\x1a') {
      ++cursor;
    } else if (c == '/' && peek(1) == '/') {
      while (cursor < end && *cursor != '\n')
        if (!skipSplices())
          ++cursor;
    } else if (c == '/' && peek(1) == '*') {
      const char *open = cursor;
      StringRef rest(cursor + 2, end - cursor - 2);
      size_t close = rest.find("*/");
      if (close == StringRef::npos) {
        diags.error(SMLoc::getFromPointer(open), "comment without an end")
            .range(SMLoc::getFromPointer(open), SMLoc::getFromPointer(open + 2));
        cursor = end;
      } else {
        cursor += close + 4;
      }
    } else if (StringRef(cursor, end - cursor).starts_with("\xEF\xBB\xBF")) {
      cursor += 3; // a byte order mark
    } else {
      break;
    }
  }
  return cursor != begin;
}

StringRef Lexer::spelling(const char *begin, const char *stop) {
  StringRef raw(begin, stop - begin);
  if (!raw.contains('\\'))
    return raw;
  std::string clean;
  for (const char *at = begin; at < stop;) {
    if (unsigned length = spliceLength(at)) {
      at += length;
    } else {
      // An escape's second character does not begin a splice.
      if (*at == '\\' && at + 1 < stop)
        clean += *at++;
      clean += *at++;
    }
  }
  return clean.size() == raw.size() ? raw : saver.save(clean);
}

Token Lexer::make(TokenKind kind, const char *begin) {
  Token token;
  token.kind = kind;
  token.loc = SMLoc::getFromPointer(begin);
  token.end = SMLoc::getFromPointer(cursor);
  token.text = spelling(begin, cursor);
  return token;
}

/// digits [. digits] [e [sign] digits] [f]; the first character is a digit, or a dot before one.
void Lexer::lexNumber() {
  auto digits = [&] {
    while (isDigit(peek()) || skipSplices())
      if (isDigit(peek()))
        ++cursor;
  };
  if (peek() == '0' && (peek(1) == 'x' || peek(1) == 'X') && isHexDigit(peek(2))) {
    cursor += 2;
    while (isHexDigit(peek()))
      ++cursor;
    return;
  }
  digits();
  if (peek() == '.') {
    ++cursor;
    digits();
  }
  if (peek() == 'e' || peek() == 'E') {
    unsigned sign = peek(1) == '+' || peek(1) == '-';
    if (isDigit(peek(1 + sign))) {
      cursor += 1 + sign;
      digits();
    }
  }
  // C's suffix, which some shaders have and which says nothing here.
  if ((peek() == 'f' || peek() == 'F') && !continuesName(peek(1)))
    ++cursor;
}

/// The opening quote is already behind the cursor.
bool Lexer::lexString(const char *begin) {
  while (cursor < end && *cursor != '\n') {
    if (skipSplices())
      continue;
    if (*cursor == '"') {
      ++cursor;
      return true;
    }
    cursor += *cursor == '\\' && cursor + 1 < end && cursor[1] != '\n' ? 2 : 1;
  }
  if (cursor > end)
    cursor = end;
  if (!skipping)
    diags.error(SMLoc::getFromPointer(begin), "string without a closing '\"' on its line")
        .range(SMLoc::getFromPointer(begin), SMLoc::getFromPointer(cursor));
  return false;
}

Token Lexer::next() {
  bool space = skipBlanks();
  bool startsLine = atLineStart;
  const char *begin = cursor;
  auto finish = [&](TokenKind kind) {
    Token token = make(kind, begin);
    token.startsLine = startsLine;
    token.afterSpace = space;
    atLineStart = false;
    return token;
  };
  if (cursor >= end)
    return finish(inDirective ? TokenKind::EndOfDirective : TokenKind::End);
  char c = *cursor;
  if (c == '\n') // only inside a directive
    return finish(TokenKind::EndOfDirective);
  if (startsName(c)) {
    do
      ++cursor;
    while (continuesName(peek()) || (skipSplices() && continuesName(peek())));
    return finish(TokenKind::Identifier);
  }
  if (isDigit(c) || (c == '.' && isDigit(peek(1)))) {
    lexNumber();
    return finish(TokenKind::Number);
  }
  if (c == '"') {
    ++cursor;
    bool closed = lexString(begin);
    Token token = finish(TokenKind::String);
    if (!closed) // so that whoever strips the quotes finds two
      token.text = saver.save(token.text.size() > 1 ? token.text + Twine('"') : Twine("\"\""));
    return token;
  }
  StringRef rest(cursor, end - cursor);
#define RSL_PUNCTUATOR(name, spelling)                                                             \
  if (rest.starts_with(spelling)) {                                                                \
    cursor += sizeof(spelling) - 1;                                                                \
    return finish(TokenKind::name);                                                                \
  }
#include "frontends/rsl/Tokens.def"
  do // all bytes of one UTF-8 character
    ++cursor;
  while (cursor < end && (static_cast<unsigned char>(*cursor) & 0xC0) == 0x80);
  return finish(TokenKind::Unknown);
}

StringRef Lexer::restOfLine() {
  skipBlanks();
  const char *begin = cursor;
  while (cursor < end && *cursor != '\n')
    if (!skipSplices())
      ++cursor;
  return spelling(begin, cursor).rtrim();
}

Token Lexer::nextHeaderName() {
  bool space = skipBlanks();
  if (peek() != '<')
    return next();
  const char *begin = cursor;
  while (cursor < end && *cursor != '\n' && *cursor != '>')
    ++cursor;
  if (peek() != '>')
    return make(TokenKind::Unknown, begin);
  ++cursor;
  Token token = make(TokenKind::HeaderName, begin);
  token.afterSpace = space;
  return token;
}

} // namespace anysl::rsl
