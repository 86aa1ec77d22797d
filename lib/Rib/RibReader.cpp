//===-- lib/Rib/RibReader.cpp - RIB file to scene ---------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibReader.h"
#include "lib/Rib/RibLexer.h"
#include "lib/Rib/RibState.h"

using namespace anysl::render;

namespace {

/// Reads the array whose opening bracket has been read.
RibArgument readArray(RibLexer &lexer, size_t begin) {
  RibArgument argument;
  argument.where = lexer.location(begin);
  argument.isArray = true;
  for (;;) {
    RibToken token = lexer.next();
    switch (token.kind) {
    case RibToken::ArrayEnd:
      return argument;
    case RibToken::Number:
      argument.numbers.push_back(token.number);
      break;
    case RibToken::String:
      argument.strings.push_back(std::move(token.text));
      break;
    case RibToken::ArrayBegin:
      throw UserError(lexer.location(token.offset), "an array inside an array");
    case RibToken::Request:
      throw UserError(lexer.location(token.offset), "expected a number, a string or ']'");
    case RibToken::End:
      throw UserError(argument.where, "an array without its closing ']'");
    case RibToken::Nothing: // which the lexer keeps for itself
      break;
    }
    if (!argument.numbers.empty() && !argument.strings.empty())
      throw UserError(lexer.location(token.offset), "an array of both numbers and strings");
  }
}

} // namespace

void anysl::render::readRequests(const std::shared_ptr<const SourceFile> &file, RibState &state) {
  RibLexer lexer(file);
  RibToken token = lexer.next();
  while (token.kind != RibToken::End) {
    if (token.kind != RibToken::Request)
      throw UserError(lexer.location(token.offset), "expected the name of a request");
    RibRequest request{std::move(token.text), lexer.location(token.offset), {}};
    for (token = lexer.next(); token.kind != RibToken::Request && token.kind != RibToken::End;
         token = lexer.next()) {
      if (token.kind == RibToken::ArrayEnd)
        throw UserError(lexer.location(token.offset), "']' without '['");
      if (token.kind == RibToken::ArrayBegin) {
        request.arguments.push_back(readArray(lexer, token.offset));
        continue;
      }
      RibArgument argument;
      argument.where = lexer.location(token.offset);
      if (token.kind == RibToken::Number)
        argument.numbers.push_back(token.number);
      else
        argument.strings.push_back(std::move(token.text));
      request.arguments.push_back(std::move(argument));
    }
    state.execute(request);
  }
}

std::vector<SceneDescription> anysl::render::readRib(std::shared_ptr<const SourceFile> file,
                                                     Warnings &warnings) {
  RibState state(file->name, warnings);
  readRequests(file, state);
  return state.finish({file, file->text.size()});
}
