//===-- lib/Rib/RibLexer.cpp - words of a RIB file --------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibLexer.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

using namespace anysl::render;

namespace {
bool isSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
} // namespace

RibToken RibLexer::next() {
  for (;;)
    if (RibToken token = word(); token.kind != RibToken::Nothing)
      return token;
}

RibToken RibLexer::word() {
  const std::string &text = file->text;
  if (floatsLeft > 0 || endsFloats)
    return arrayToken();
  while (position < text.size()) {
    if (isSpace(text[position]))
      ++position;
    else if (text[position] == '#')
      position = std::min(text.find('\n', position), text.size());
    else
      break;
  }
  RibToken token;
  token.offset = position;
  if (position == text.size())
    return token;
  char c = text[position];
  if (c == '[' || c == ']') {
    ++position;
    token.kind = c == '[' ? RibToken::ArrayBegin : RibToken::ArrayEnd;
    return token;
  }
  if (c == '"')
    return stringToken();
  if (isDigit(c) || c == '-' || c == '+' || c == '.')
    return numberToken();
  if (isLetter(c)) {
    size_t end = position;
    while (end < text.size() && (isLetter(text[end]) || isDigit(text[end])))
      ++end;
    token.kind = RibToken::Request;
    token.text = text.substr(position, end - position);
    position = end;
    return token;
  }
  if (static_cast<unsigned char>(c) >= 0x80)
    return binaryToken(static_cast<unsigned char>(c));
  if (static_cast<unsigned char>(c) < ' ' || c == 0x7f)
    throw UserError(location(position), "a byte that neither RIB's text nor its binary form has");
  throw UserError(location(position), std::string("unexpected character '") + c + "'");
}

RibToken RibLexer::stringToken() {
  const std::string &text = file->text;
  RibToken token;
  token.kind = RibToken::String;
  token.offset = position++;
  for (;; ++position) {
    if (position == text.size())
      throw UserError(location(token.offset), "a string without its closing quote");
    char c = text[position];
    if (c == '"')
      break;
    if (c != '\\' || position + 1 == text.size()) {
      token.text += c;
      continue;
    }
    c = text[++position];
    if (c >= '0' && c <= '7') {
      unsigned code = 0, digits = 0;
      for (; digits < 3 && position < text.size() && text[position] >= '0' && text[position] <= '7';
           ++digits, ++position)
        code = code * 8 + unsigned(text[position] - '0');
      --position;
      token.text += char(code);
    } else if (c == '\n') {
      continue;
    } else {
      token.text += c == 'n'   ? '\n'
                    : c == 't' ? '\t'
                    : c == 'r' ? '\r'
                    : c == 'b' ? '\b'
                    : c == 'f' ? '\f'
                               : c;
    }
  }
  ++position;
  return token;
}

RibToken RibLexer::numberToken() {
  const std::string &text = file->text;
  RibToken token;
  token.kind = RibToken::Number;
  token.offset = position;
  const char *begin = text.data() + position, *end = text.data() + text.size();
  if (*begin == '+')
    ++begin;
  auto [rest, error] = std::from_chars(begin, end, token.number);
  if (error == std::errc::result_out_of_range)
    token.number = std::strtod(begin, nullptr); // too small is 0, or nearly
  if (error == std::errc::result_out_of_range && std::isinf(token.number))
    throw UserError(location(token.offset), "a number beyond what a double can hold");
  bool ended = rest == end || isSpace(*rest) || *rest == '[' || *rest == ']' || *rest == '#' ||
               *rest == '"' || static_cast<unsigned char>(*rest) >= 0x80;
  if (error == std::errc::invalid_argument || !ended || !std::isfinite(token.number))
    throw UserError(location(token.offset), "this is not a number");
  position = size_t(rest - text.data());
  return token;
}
