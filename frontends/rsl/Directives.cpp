//===-- frontends/rsl/Directives.cpp - the preprocessor's directives --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Preprocessor.h"

#include "frontends/rsl/Condition.h"
#include "frontends/rsl/Literals.h"
#include "frontends/rsl/Warnings.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"

using namespace llvm;

namespace anysl::rsl {

static constexpr unsigned MaxIncludeDepth = 100;

bool Preprocessor::enterFile(StringRef path, SMLoc from) {
  Expected<unsigned> buffer = diags.addFile(path, from);
  if (!buffer) {
    incomplete = true;
    diags.error(from, "cannot read '" + path + "': " + toString(buffer.takeError()));
    return false;
  }
  enterBuffer(*buffer);
  if (!is_contained(files, path))
    files.push_back(path.str());
  return true;
}

/// Reads to the end of the directive's line.
void Preprocessor::endDirective() {
  Token token = lexer().next();
  if (!token.is(TokenKind::EndOfDirective))
    diags.warning(token.loc, warn::ExtraTokens, "extra words at the end of a directive");
  while (!token.is(TokenKind::EndOfDirective))
    token = lexer().next();
  lexer().inDirective = false;
}

void Preprocessor::directive() {
  lexer().inDirective = true;
  Token name = lexer().next();
  if (name.is(TokenKind::EndOfDirective)) {
    lexer().inDirective = false;
    return;
  }
  if (name.is(TokenKind::Number)) // the output of another preprocessor
    return lineDirective(name.loc, &name);
  if (name.text == "define")
    return defineDirective();
  if (name.text == "undef")
    return undefDirective();
  if (name.text == "include")
    return includeDirective(name.loc);
  if (name.text == "if")
    return ifDirective(name.loc);
  if (name.text == "ifdef" || name.text == "ifndef")
    return ifdefDirective(name.loc, name.text == "ifdef");
  if (name.text == "else" || name.text == "elif")
    return elseDirective(name);
  if (name.text == "endif")
    return endifDirective(name);
  if (name.text == "line")
    return lineDirective(name.loc, nullptr);
  if (name.text == "error" || name.text == "warning") {
    StringRef message = lexer().restOfLine();
    if (name.text == "error")
      diags.error(name.loc, "#error " + message).range(name.range());
    else
      diags.warning(name.loc, warn::UserWarning, "#warning " + message).range(name.range());
  } else if (name.text != "pragma" && name.text != "ident") {
    diags
        .error(name.loc, "unknown directive '#" + name.text + "'" +
                             didYouMean(name.text, {"define", "undef", "include", "if", "ifdef",
                                                    "ifndef", "else", "elif", "endif", "line",
                                                    "error", "warning", "pragma"}))
        .range(name.range());
  }
  lexer().skipping = true;
  lexer().restOfLine();
  lexer().skipping = false;
  lexer().inDirective = false;
}

//===-- Macros ----------------------------------------------------------------------------------//

void Preprocessor::defineDirective() {
  Token name = lexer().next();
  if (!name.is(TokenKind::Identifier) || name.text == "defined") {
    diags.error(name.loc, "a macro needs a name");
    lexer().restOfLine();
    lexer().inDirective = false;
    return;
  }
  auto macro = std::make_unique<Macro>();
  macro->name = name;
  Token token = lexer().next();
  if (token.is(TokenKind::LeftParen) && !token.afterSpace) {
    macro->isFunction = true;
    token = lexer().next();
    while (!token.is(TokenKind::RightParen)) {
      if (token.is(TokenKind::Ellipsis)) {
        macro->isVariadic = true;
        macro->parameters.push_back("__VA_ARGS__");
      } else if (token.is(TokenKind::Identifier)) {
        macro->parameters.push_back(token.text);
      } else {
        diags.error(token.loc, "expected a macro's parameter or ')'").range(token.range());
        lexer().restOfLine();
        lexer().inDirective = false;
        return;
      }
      token = lexer().next();
      if (token.is(TokenKind::Comma) && !macro->isVariadic)
        token = lexer().next();
      else if (!token.is(TokenKind::RightParen)) {
        diags.error(token.loc, "expected ',' or ')' between a macro's parameters")
            .range(token.range());
        lexer().restOfLine();
        lexer().inDirective = false;
        return;
      }
    }
    token = lexer().next();
  }
  for (; !token.is(TokenKind::EndOfDirective); token = lexer().next())
    macro->body.push_back(token);
  lexer().inDirective = false;

  std::unique_ptr<Macro> &entry = macros[name.text];
  if (entry) {
    bool same = entry->isFunction == macro->isFunction && entry->parameters == macro->parameters &&
                entry->body.size() == macro->body.size();
    for (size_t i = 0; same && i < macro->body.size(); ++i)
      same = entry->body[i].text == macro->body[i].text;
    if (!same)
      diags.warning(name.loc, warn::MacroRedefined, "macro '" + name.text + "' redefined")
          .range(name.range())
          .note(entry->name.loc, "previously defined here");
    retired.push_back(std::move(entry));
  }
  entry = std::move(macro);
}

void Preprocessor::undefDirective() {
  Token name = lexer().next();
  if (!name.is(TokenKind::Identifier)) {
    diags.error(name.loc, "#undef needs a macro's name");
  } else if (auto found = macros.find(name.text); found != macros.end()) {
    retired.push_back(std::move(found->second));
    macros.erase(found);
  }
  endDirective();
}

//===-- Files -----------------------------------------------------------------------------------//

void Preprocessor::includeDirective(SMLoc loc) {
  Token name = lexer().nextHeaderName();
  if (name.is(TokenKind::Identifier) && expand(name))
    name = lex();
  if (!name.isOneOf(TokenKind::String, TokenKind::HeaderName)) {
    diags.error(name.loc, "#include needs \"FILE\" or <FILE>");
    while (!name.is(TokenKind::EndOfDirective) && !name.is(TokenKind::End))
      name = lexRaw();
    lexer().inDirective = false;
    return;
  }
  dropExpansions();
  endDirective();
  StringRef wanted = name.text.drop_front().drop_back();
  if (stack.size() > MaxIncludeDepth) {
    diags.error(name.loc, "files include each other more than " + Twine(MaxIncludeDepth) + " deep")
        .range(name.range());
    // Two such includes in one file would go on for 2^100 files.
    gaveUp = incomplete = true;
    return;
  }
  std::vector<std::string> searched;
  auto tryFile = [&](StringRef folder) {
    SmallString<128> path(folder);
    sys::path::append(path, wanted);
    if (!sys::fs::exists(path) || sys::fs::is_directory(path)) {
      if (std::string name = folder.empty() ? "." : folder.str(); !is_contained(searched, name))
        searched.push_back(name);
      return false;
    }
    enterFile(path, loc);
    return true;
  };
  if (sys::path::is_absolute(wanted)) {
    if (tryFile(""))
      return;
  } else {
    if (name.is(TokenKind::String)) {
      StringRef current =
          diags.sources().getMemoryBuffer(stack.back()->buffer)->getBufferIdentifier();
      if (tryFile(sys::path::parent_path(current)))
        return;
    }
    for (StringRef folder : options.includeDirs)
      if (tryFile(folder))
        return;
  }
  incomplete = true;
  std::string places = "no -I folder is given";
  if (!searched.empty()) {
    constexpr size_t named = 5;
    size_t more = searched.size() > named ? searched.size() - named : 0;
    searched.resize(searched.size() - more);
    places = "searched in " + join(searched, ", ");
    if (more)
      places += " and in " + utostr(more) + " more folders";
  }
  diags.error(name.loc, "cannot find '" + wanted + "' (" + places + ")").range(name.range());
}

void Preprocessor::lineDirective(SMLoc loc, const Token *first) {
  Token number = first ? *first : lexer().next();
  if (number.is(TokenKind::Identifier) && expand(number))
    number = lex();
  dropExpansions();
  unsigned line = 0;
  if (!number.is(TokenKind::Number) || number.text.getAsInteger(10, line)) {
    diags.error(number.loc, "#line needs a line number").range(number.range());
  } else {
    Token file = lexer().next();
    if (file.is(TokenKind::String))
      diags.setPresumed(loc, line, saver.save(unquote(file.text)));
    else
      diags.setPresumed(loc, line, "");
  }
  lexer().restOfLine();
  lexer().inDirective = false;
}

//===-- Conditionals ----------------------------------------------------------------------------//

void Preprocessor::ifdefDirective(SMLoc loc, bool wanted) {
  Token name = lexer().next();
  bool holds = false;
  if (!name.is(TokenKind::Identifier))
    diags.error(name.loc, "expected a macro's name");
  else
    holds = (macros.count(name.text) != 0) == wanted;
  endDirective();
  conditions.push_back({loc, holds, false});
  if (!holds)
    skipBranch();
}

void Preprocessor::ifDirective(SMLoc loc) {
  bool holds = evaluateCondition(loc);
  conditions.push_back({loc, holds, false});
  if (!holds)
    skipBranch();
}

/// Reached only at the end of a branch that was read: all the others are left out.
void Preprocessor::elseDirective(const Token &name) {
  if (conditions.size() <= stack.back()->openConditions) {
    diags.error(name.loc, "'#" + name.text + "' without an #if").range(name.range());
    lexer().restOfLine();
    lexer().inDirective = false;
    return;
  }
  Condition &condition = conditions.back();
  if (condition.sawElse)
    diags.error(name.loc, "'#" + name.text + "' after #else")
        .range(name.range())
        .note(condition.loc, "the conditional begins here");
  condition.sawElse |= name.text == "else";
  lexer().restOfLine();
  lexer().inDirective = false;
  skipBranch();
}

void Preprocessor::endifDirective(const Token &name) {
  if (conditions.size() <= stack.back()->openConditions)
    diags.error(name.loc, "#endif without an #if").range(name.range());
  else
    conditions.pop_back();
  endDirective();
}

/// Leaves out text up to the branch that is to be read, or the #endif.
void Preprocessor::skipBranch() {
  unsigned depth = 0;
  Lexer &lexer = this->lexer();
  lexer.skipping = true;
  while (true) {
    Token token = lexer.next();
    if (token.is(TokenKind::End))
      break; // the end of the file reports the open conditional
    if (!token.is(TokenKind::Hash) || !token.startsLine)
      continue;
    lexer.inDirective = true;
    Token name = lexer.next();
    if (name.text == "if" || name.text == "ifdef" || name.text == "ifndef") {
      ++depth;
    } else if (name.text == "endif") {
      if (depth == 0) {
        conditions.pop_back();
        lexer.skipping = false;
        endDirective();
        return;
      }
      --depth;
    } else if (depth == 0 && (name.text == "else" || name.text == "elif")) {
      Condition &condition = conditions.back();
      if (condition.sawElse)
        diags.error(name.loc, "'#" + name.text + "' after #else")
            .range(name.range())
            .note(condition.loc, "the conditional begins here");
      bool isElse = name.text == "else";
      condition.sawElse |= isElse;
      if (!condition.taken) {
        lexer.skipping = false;
        bool holds = isElse || evaluateCondition(name.loc);
        if (isElse)
          endDirective();
        if (holds) {
          condition.taken = true;
          return;
        }
        lexer.skipping = true;
        continue;
      }
    }
    lexer.restOfLine();
    lexer.inDirective = false;
  }
  lexer.skipping = false;
}

/// Reads the condition up to the line's end, expanding macros except behind `defined`.
bool Preprocessor::evaluateCondition(SMLoc loc) {
  std::vector<Token> tokens;
  while (true) {
    Token token = lexRaw();
    if (token.isOneOf(TokenKind::EndOfDirective, TokenKind::End) || ++made > options.maxTokens)
      break;
    if (token.is(TokenKind::Identifier) && token.text == "defined") {
      Token name = lexRaw();
      bool parenthesised = name.is(TokenKind::LeftParen);
      if (parenthesised)
        name = lexRaw();
      if (!name.is(TokenKind::Identifier))
        diags.error(token.loc, "'defined' needs a macro's name").range(token.range());
      if (name.isOneOf(TokenKind::EndOfDirective, TokenKind::End))
        break;
      if (parenthesised && !lexRaw().is(TokenKind::RightParen))
        diags.error(token.loc, "'defined(' without ')'").range(token.range());
      tokens.push_back(number(token, macros.count(name.text) != 0));
      continue;
    }
    if (token.is(TokenKind::Identifier) && !token.neverExpand && expand(token))
      continue;
    tokens.push_back(token);
  }
  dropExpansions();
  lexer().inDirective = false;
  return conditionHolds(tokens, loc, diags);
}

} // namespace anysl::rsl
