//===-- lib/Rib/RibBinary.cpp - the binary form of RIB ----------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The specification's appendix on the bytestream gives bytes from 0200 on a meaning, so that text
// and binary words may follow each other; numbers have their most significant byte first:
//
//   0200 + 4 d + w          a number of w + 1 bytes, d of them behind the binary point
//   0220 + n                a string of n < 16 bytes
//   0240 + w                a string whose length takes w + 1 bytes
//   0244, 0245              a float, a double
//   0246 code               a request that has been defined
//   0310 + w                an array of floats whose length takes w + 1 bytes
//   0314 code string        defines a request
//   0315 + w, token, string defines a string, whose number takes w + 1 bytes (w < 2)
//   0317 + w, token         that string
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibLexer.h"

#include <bit>
#include <cmath>
#include <utility>

using namespace anysl::render;

uint64_t RibLexer::binaryNumber(unsigned bytes, size_t begin) {
  if (file->text.size() - position < bytes)
    throw UserError(location(begin), "a binary value that the file's end cuts short");
  uint64_t number = 0;
  for (; bytes > 0; --bytes)
    number = number << 8 | static_cast<unsigned char>(file->text[position++]);
  return number;
}

std::string RibLexer::binaryText(uint64_t length, size_t begin) {
  if (file->text.size() - position < length)
    throw UserError(location(begin), "a binary string that the file's end cuts short");
  position += length;
  return file->text.substr(position - length, length);
}

RibToken RibLexer::binaryToken(unsigned char code) {
  RibToken token;
  token.offset = position++;
  auto number = [&](double value) {
    if (!std::isfinite(value))
      throw UserError(location(token.offset), "this is not a number");
    token.kind = RibToken::Number;
    token.number = value;
    return token;
  };
  if (code < 0220) {
    unsigned size = (code & 3) + 1u, behindPoint = code >> 2 & 3;
    uint64_t bits = binaryNumber(size, token.offset);
    // Only a number of four bytes has room for a sign.
    double value = size == 4 ? double(int32_t(uint32_t(bits))) : double(bits);
    return number(std::ldexp(value, -8 * int(behindPoint)));
  }
  if (code < 0244) {
    uint64_t length =
        code < 0240 ? uint64_t(code) - 0220 : binaryNumber(code - 0240u + 1, token.offset);
    token.kind = RibToken::String;
    token.text = binaryText(length, token.offset);
    return token;
  }
  switch (code) {
  case 0244:
    return number(std::bit_cast<float>(uint32_t(binaryNumber(4, token.offset))));
  case 0245:
    return number(std::bit_cast<double>(binaryNumber(8, token.offset)));
  case 0246: {
    auto request = requests.find(unsigned(binaryNumber(1, token.offset)));
    if (request == requests.end())
      throw UserError(location(token.offset), "a binary request that has not been defined");
    token.kind = RibToken::Request;
    token.text = request->second;
    return token;
  }
  case 0310:
  case 0311:
  case 0312:
  case 0313:
    floatsLeft = binaryNumber(code - 0310u + 1, token.offset);
    if ((file->text.size() - position) / 4 < floatsLeft)
      throw UserError(location(token.offset), "a binary array that the file's end cuts short");
    endsFloats = true;
    token.kind = RibToken::ArrayBegin;
    return token;
  case 0314:
    defineRequest(token.offset);
    token.kind = RibToken::Nothing;
    return token;
  case 0315:
  case 0316:
    defineString(token.offset, code - 0315u + 1);
    token.kind = RibToken::Nothing;
    return token;
  case 0317:
  case 0320: {
    auto string = strings.find(binaryNumber(code - 0317u + 1, token.offset));
    if (string == strings.end())
      throw UserError(location(token.offset), "a binary string that has not been defined");
    token.kind = RibToken::String;
    token.text = string->second;
    return token;
  }
  case 0377: // what interactive streams end with
    token.kind = RibToken::Nothing;
    return token;
  }
  throw UserError(location(token.offset), "a byte that neither RIB's text nor its binary form has");
}

RibToken RibLexer::arrayToken() {
  RibToken token;
  token.offset = position;
  if (floatsLeft == 0) {
    endsFloats = false;
    token.kind = RibToken::ArrayEnd;
    return token;
  }
  --floatsLeft;
  token.kind = RibToken::Number;
  token.number = std::bit_cast<float>(uint32_t(binaryNumber(4, position)));
  if (!std::isfinite(token.number))
    throw UserError(location(token.offset), "this is not a number");
  return token;
}

void RibLexer::defineRequest(size_t begin) {
  unsigned code = unsigned(binaryNumber(1, begin));
  requests[code] = definition(begin);
}

void RibLexer::defineString(size_t begin, unsigned size) {
  uint64_t number = binaryNumber(size, begin);
  strings[number] = definition(begin);
}

std::string RibLexer::definition(size_t begin) {
  RibToken text = std::exchange(defining, true) ? RibToken() : word();
  defining = false;
  if (text.kind != RibToken::String)
    throw UserError(location(begin), "a binary definition without its text");
  return text.text;
}
