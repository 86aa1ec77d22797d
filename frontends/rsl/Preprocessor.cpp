//===-- frontends/rsl/Preprocessor.cpp - words and macros -------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Preprocessor.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace anysl::rsl {

Preprocessor::Preprocessor(DiagnosticEngine &diags, PreprocessorOptions options)
    : diags(diags), options(std::move(options)), saver(allocator) {}

Preprocessor::~Preprocessor() = default;

void Preprocessor::enterBuffer(unsigned buffer) {
  auto source = std::make_unique<Source>();
  source->lexer = std::make_unique<Lexer>(diags.text(buffer), diags, saver);
  source->buffer = buffer;
  source->openConditions = conditions.size();
  stack.push_back(std::move(source));
}

std::vector<Token> Preprocessor::run(StringRef path, std::optional<StringRef> text) {
  std::vector<Token> tokens;
  if (text) {
    enterBuffer(diags.addText(path, *text));
    files.push_back(path.str());
  } else if (!enterFile(path, SMLoc())) {
    return {Token()};
  }
  if (!options.defines.empty()) {
    // The command line's macros are a file of their own that is read first.
    std::string lines;
    for (StringRef define : options.defines) {
      auto [name, value] = define.split('=');
      lines += ("#define " + name + " " + (define.contains('=') ? value : "1") + "\n").str();
    }
    enterBuffer(diags.addText("<command line>", lines));
  }
  while (true) {
    Token token = lex();
    if (token.is(TokenKind::Identifier))
      token.kind = keywordKind(token.text);
    else if (token.is(TokenKind::Unknown)) {
      diags.error(token.loc, "unexpected character '" + token.text + "'");
      continue;
    }
    tokens.push_back(token);
    if (token.is(TokenKind::End))
      return tokens;
  }
}

Lexer &Preprocessor::lexer() {
  // Directives are read only while a file is on top.
  return *stack.back()->lexer;
}

Token Preprocessor::lexRaw() {
  while (true) {
    Source &source = *stack.back();
    if (source.isWall || gaveUp)
      return Token();
    if (!source.lexer) {
      if (source.position < source.tokens.size())
        return source.tokens[source.position++];
      if (source.macro)
        source.macro->disabled = false;
      stack.pop_back();
      continue;
    }
    Token token = source.lexer->next();
    if (token.is(TokenKind::Hash) && token.startsLine && !source.lexer->inDirective) {
      directive();
      continue;
    }
    if (!token.is(TokenKind::End))
      return token;
    while (conditions.size() > source.openConditions) {
      diags.error(conditions.back().loc, "conditional without an #endif");
      conditions.pop_back();
    }
    if (stack.size() == 1)
      return token;
    stack.pop_back();
  }
}

Token Preprocessor::lex() {
  while (true) {
    Token token = lexRaw();
    if (++made > options.maxTokens || gaveUp) {
      if (!gaveUp)
        diags.error(token.loc, "macros expand to more than " + Twine(options.maxTokens) + " words");
      gaveUp = incomplete = true;
      Token end;
      end.loc = end.end = token.loc;
      return end;
    }
    if (token.is(TokenKind::Identifier) && !token.neverExpand && expand(token))
      continue;
    return token;
  }
}

void Preprocessor::push(std::vector<Token> tokens, Macro *macro) {
  auto source = std::make_unique<Source>();
  source->tokens = std::move(tokens);
  source->macro = macro;
  if (macro)
    macro->disabled = true;
  stack.push_back(std::move(source));
}

/// Forgets what is left of expansions above a file or wall.
void Preprocessor::dropExpansions() {
  while (!stack.back()->lexer && !stack.back()->isWall) {
    if (stack.back()->macro)
      stack.back()->macro->disabled = false;
    stack.pop_back();
  }
}

Token Preprocessor::number(const Token &like, unsigned value) {
  Token token = like;
  token.kind = TokenKind::Number;
  token.text = saver.save(utostr(value));
  return token;
}

/// Replaces a macro's name by its expansion, which is put in front of what is still to be read.
/// Returns false if the name is no macro, or stands for itself here.
bool Preprocessor::expand(Token &name) {
  auto found = macros.find(name.text);
  if (found == macros.end()) {
    if (name.text == "__LINE__") {
      push({number(name, diags.presumed(name.loc).line)}, nullptr);
      return true;
    }
    if (name.text == "__FILE__") {
      Token token = name;
      token.kind = TokenKind::String;
      token.text = saver.save("\"" + Twine(diags.presumed(name.loc).file) + "\"");
      push({token}, nullptr);
      return true;
    }
    return false;
  }
  Macro &macro = *found->second;
  if (macro.disabled) {
    name.neverExpand = true;
    return false;
  }
  if (macro.isFunction)
    return expandFunction(name, macro);
  push(substitute(name, macro, {}), &macro);
  return true;
}

bool Preprocessor::expandFunction(const Token &name, Macro &macro) {
  Token open = lexRaw();
  if (!open.is(TokenKind::LeftParen)) {
    if (!open.isOneOf(TokenKind::End, TokenKind::EndOfDirective))
      push({open}, nullptr);
    return false;
  }
  std::vector<std::vector<Token>> arguments(1);
  unsigned depth = 0;
  while (true) {
    Token token = lexRaw();
    if (token.isOneOf(TokenKind::End, TokenKind::EndOfDirective)) {
      diags.error(name.loc, "the use of macro '" + name.text + "' has no closing ')'")
          .range(name.loc, name.end)
          .note(macro.name.loc, "macro '" + name.text + "' is defined here");
      return true;
    }
    if (++made > options.maxTokens)
      return true;
    if (token.is(TokenKind::RightParen) && depth-- == 0)
      break;
    if (token.is(TokenKind::LeftParen))
      ++depth;
    bool inRest = macro.isVariadic && arguments.size() == macro.parameters.size();
    if (token.is(TokenKind::Comma) && depth == 0 && !inRest)
      arguments.emplace_back();
    else
      arguments.back().push_back(token);
  }
  size_t wanted = macro.parameters.size();
  if (wanted == 0 && arguments.size() == 1 && arguments[0].empty())
    arguments.clear();
  if (macro.isVariadic && arguments.size() + 1 == wanted)
    arguments.emplace_back();
  if (arguments.size() != wanted) {
    diags
        .error(name.loc, "macro '" + name.text + "' takes " + Twine(wanted) + " argument" +
                             (wanted == 1 ? "" : "s") + ", not " + Twine(arguments.size()))
        .range(name.loc, name.end)
        .note(macro.name.loc, "macro '" + name.text + "' is defined here");
    arguments.resize(wanted);
  }
  push(substitute(name, macro, arguments), &macro);
  return true;
}

std::vector<Token> Preprocessor::expandAlone(ArrayRef<Token> tokens) {
  auto wall = std::make_unique<Source>();
  wall->isWall = true;
  stack.push_back(std::move(wall));
  push(tokens.vec(), nullptr);
  std::vector<Token> out;
  for (Token token = lex(); !token.is(TokenKind::End); token = lex())
    out.push_back(token);
  dropExpansions(); // a run that gave up leaves some above the wall
  stack.pop_back();
  return out;
}

Token Preprocessor::stringize(const Token &hash, ArrayRef<Token> tokens) {
  std::string text = "\"";
  for (const Token &token : tokens) {
    if (token.afterSpace && text.size() > 1)
      text += ' ';
    for (char c : token.text) {
      if (token.is(TokenKind::String) && (c == '"' || c == '\\'))
        text += '\\';
      text += c;
    }
  }
  Token made = hash;
  made.kind = TokenKind::String;
  made.text = saver.save(text + "\"");
  return made;
}

/// Joins \p right to the last word of \p out.
void Preprocessor::paste(std::vector<Token> &out, const Token &right) {
  Token &left = out.back();
  // The lexer wants text with a zero behind it, which the saver gives.
  StringRef joined = saver.save(left.text + right.text);
  Lexer lexer(joined, diags, saver);
  lexer.inDirective = true;
  Token first = lexer.next();
  if (!lexer.next().is(TokenKind::EndOfDirective)) {
    diags.error(left.loc, "'##' makes '" + joined + "', which is not one word");
    out.push_back(right);
    return;
  }
  left.kind = first.kind;
  left.text = joined;
  left.neverExpand = false;
}

std::vector<Token> Preprocessor::substitute(const Token &name, const Macro &macro,
                                            const std::vector<std::vector<Token>> &arguments) {
  auto parameterOf = [&](const Token &token) -> int {
    if (token.is(TokenKind::Identifier))
      for (size_t i = 0; i < macro.parameters.size(); ++i)
        if (macro.parameters[i] == token.text)
          return static_cast<int>(i);
    return -1;
  };
  // Of macros in macros the outermost counts: its use is what a message points at.
  diags.setExpansion(name.loc, name.text, macro.name.loc);
  std::vector<Token> out;
  std::vector<std::optional<std::vector<Token>>> expanded(arguments.size());
  const std::vector<Token> &body = macro.body;
  bool pasteNext = false;
  for (size_t i = 0; i < body.size(); ++i) {
    Token token = body[i];
    token.loc = name.loc;
    token.end = name.end;
    token.startsLine = false;
    if (token.is(TokenKind::HashHash) && i + 1 < body.size() && i > 0) {
      pasteNext = true;
      continue;
    }
    std::vector<Token> piece;
    int parameter = parameterOf(token);
    if (token.is(TokenKind::Hash) && macro.isFunction && i + 1 < body.size() &&
        parameterOf(body[i + 1]) >= 0) {
      piece.push_back(stringize(token, arguments[parameterOf(body[++i])]));
    } else if (parameter >= 0) {
      bool raw = pasteNext || (i + 1 < body.size() && body[i + 1].is(TokenKind::HashHash));
      if (raw) {
        piece = arguments[parameter];
      } else {
        if (!expanded[parameter])
          expanded[parameter] = expandAlone(arguments[parameter]);
        piece = *expanded[parameter];
      }
      if (!piece.empty())
        piece.front().afterSpace = token.afterSpace;
    } else {
      piece.push_back(token);
    }
    size_t from = 0;
    if (pasteNext && !out.empty() && !piece.empty()) {
      paste(out, piece.front());
      from = 1;
    }
    pasteNext = false;
    out.insert(out.end(), piece.begin() + static_cast<ptrdiff_t>(from), piece.end());
    made += piece.size();
    if (made > options.maxTokens)
      break;
  }
  for (Token &token : out)
    token.startsLine = false;
  return out;
}

} // namespace anysl::rsl
