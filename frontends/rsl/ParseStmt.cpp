//===-- frontends/rsl/ParseStmt.cpp - statements ----------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Parser.h"

#include "llvm/ADT/StringSwitch.h"

using namespace llvm;

namespace anysl::rsl {

BlockStmt *Parser::parseBlock() {
  Token open = take();
  size_t outerStructs = structs.size();
  std::vector<Stmt *> body;
  while (!at(TokenKind::RightBrace) && !at(TokenKind::End) && !diags.reachedLimit())
    if (Stmt *stmt = parseStatement())
      body.push_back(stmt);
  structs.resize(outerStructs);
  SMLoc end = peek().loc;
  if (!accept(TokenKind::RightBrace))
    diags.error(lastEnd(), "expected '}' at the end of a block")
        .note(open.loc, "to match this '{'", open.range());
  return ast.make<BlockStmt>(open.loc, end, ast.copy<Stmt *>(body));
}

/// Null after an error, when the rest of the statement has been skipped.
Stmt *Parser::parseStatement() {
  if (!enter(peek().loc)) {
    if (at(TokenKind::LeftBrace))
      skipBrackets();
    else
      skipStatement();
    return nullptr;
  }
  size_t before = position;
  Stmt *stmt = parseStatementInner();
  --depth;
  if (!stmt) {
    skipStatement();
    if (position == before)
      take();
  }
  return stmt;
}

/// At `name(…) {`: a nested function without a result type.
bool Parser::atUntypedFunction() const {
  if (!at(TokenKind::Identifier) || !peek(1).is(TokenKind::LeftParen))
    return false;
  unsigned open = 0;
  for (unsigned i = 1; !peek(i).is(TokenKind::End); ++i) {
    if (peek(i).is(TokenKind::LeftParen))
      ++open;
    else if (peek(i).is(TokenKind::RightParen) && --open == 0)
      return peek(i + 1).is(TokenKind::LeftBrace);
    else if (peek(i).isOneOf(TokenKind::LeftBrace, TokenKind::RightBrace))
      return false;
  }
  return false;
}

Stmt *Parser::parseStatementInner() {
  SMLoc loc = peek().loc;
  switch (peek().kind) {
  case TokenKind::Semicolon:
    take();
    return ast.make<Stmt>(StmtKind::Empty, loc);
  case TokenKind::LeftBrace:
    return parseBlock();
  case TokenKind::KwIf:
    return parseIf();
  case TokenKind::KwWhile:
    return parseWhile();
  case TokenKind::KwFor:
    return parseFor();
  case TokenKind::KwIlluminance:
    return parseLight(StmtKind::Illuminance);
  case TokenKind::KwIlluminate:
    return parseLight(StmtKind::Illuminate);
  case TokenKind::KwSolar:
    return parseLight(StmtKind::Solar);
  case TokenKind::KwGather:
    return parseGather();
  case TokenKind::KwBreak:
  case TokenKind::KwContinue: {
    StmtKind kind = at(TokenKind::KwBreak) ? StmtKind::Break : StmtKind::Continue;
    take();
    Expr *count = nullptr;
    if (!at(TokenKind::Semicolon) && !(count = parseExpr()))
      return nullptr;
    if (!expect(TokenKind::Semicolon,
                kind == StmtKind::Break ? "after 'break'" : "after 'continue'"))
      return nullptr;
    return ast.make<JumpStmt>(kind, loc, count);
  }
  case TokenKind::KwReturn: {
    take();
    Expr *value = nullptr;
    if (!at(TokenKind::Semicolon) && !(value = parseExpr()))
      return nullptr;
    if (!expect(TokenKind::Semicolon, "after 'return'"))
      return nullptr;
    return ast.make<ReturnStmt>(loc, value);
  }
  case TokenKind::KwElse:
    errorHere("'else' without an 'if'");
    take();
    return parseStatement();
  default:
    break;
  }
  if (atDefinition("struct", TokenKind::LeftBrace))
    return ast.make<StructStmt>(loc, parseStruct());
  // A type's name also begins a conversion, but then no name and no storage class follows it.
  if (atSpecifier() && (!atTypeName() || peek(1).is(TokenKind::Identifier) || peek(1).isKeyword() ||
                        atArrayResult(1))) {
    bool isConversion = atTypeName() && peek(2).is(TokenKind::LeftParen);
    if (isConversion) {
      // `float f(…) {` against `float noise(…);`
      ++position;
      isConversion = !atUntypedFunction();
      --position;
    }
    if (!isConversion)
      return parseDeclaration();
  }
  if (atUntypedFunction()) {
    FunctionDecl *decl = parseFunction(Specifiers());
    return decl ? nestedFunction(loc, decl) : nullptr;
  }
  if (at(TokenKind::Identifier) && peek(1).is(TokenKind::Identifier) &&
      peek(2).isOneOf(TokenKind::Semicolon, TokenKind::Comma, TokenKind::Equal,
                      TokenKind::LeftBracket))
    return parseUnknownType();
  Expr *expr = parseExpr();
  if (!expr)
    return nullptr;
  // Without its ';' the statement is still whole: what follows is probably the next one.
  expect(TokenKind::Semicolon, "after an expression");
  return ast.make<ExpressionStmt>(expr);
}

/// `colour c = 1;`: reported, but the variables are there, so that their uses are not reported too.
Stmt *Parser::parseUnknownType() {
  Token type = take();
  StringRef types[] = {"float", "color", "point", "vector", "normal", "matrix", "string"};
  auto likely = StringSwitch<std::optional<StringRef>>(type.text)
                    .Cases("int", "double", "bool", "half", "float")
                    .Cases("vec3", "float3", "vector")
                    .Cases("mat4", "float4x4", "matrix")
                    .Default(suggest(type.text, types));
  std::string question = likely ? "; did you mean '" + likely->str() + "'?" : "";
  auto error = diags.error(type.loc, "unknown type '" + type.text + "'" + question);
  error.range(type.range());
  if (likely)
    error.fixit(type.range(), *likely);
  Specifiers specifiers;
  specifiers.loc = type.loc;
  specifiers.hasType = true;
  return parseVariables(specifiers);
}

Stmt *Parser::nestedFunction(SMLoc loc, FunctionDecl *decl) {
  ast.functions.push_back(decl);
  return ast.make<FunctionStmt>(loc, decl);
}

Stmt *Parser::parseDeclaration() {
  Specifiers specifiers = parseSpecifiers();
  SMLoc loc = specifiers.loc;
  if (!parseArrayResult(specifiers))
    return nullptr;
  if (at(TokenKind::Identifier) && peek(1).is(TokenKind::LeftParen)) {
    FunctionDecl *decl = parseFunction(specifiers);
    return decl ? nestedFunction(loc, decl) : ast.make<Stmt>(StmtKind::Empty, loc);
  }
  if (!specifiers.hasType || specifiers.type == TypeKind::Void) {
    diags.error(loc,
                specifiers.hasType ? "a variable cannot be 'void'" : "a declaration needs a type");
    return nullptr;
  }
  if (specifiers.isOutput)
    diags.error(loc, "only parameters can be 'output'");
  return parseVariables(specifiers);
}

/// The names of a declaration and what follows them.
Stmt *Parser::parseVariables(const Specifiers &specifiers) {
  std::vector<VarDecl *> variables;
  do {
    VarDecl *variable = parseVariable(VarKind::Local, specifiers, function);
    if (!variable)
      return nullptr;
    variables.push_back(variable);
  } while (accept(TokenKind::Comma));
  expect(TokenKind::Semicolon, "after a declaration");
  if (specifiers.isExtern)
    return ast.make<ExternStmt>(specifiers.loc, ast.copy<VarDecl *>(variables));
  return ast.make<DeclarationStmt>(specifiers.loc, ast.copy<VarDecl *>(variables));
}

Stmt *Parser::parseIf() {
  SMLoc loc = take().loc, open = peek().loc;
  if (!expect(TokenKind::LeftParen, "after 'if'"))
    return nullptr;
  Expr *condition = parseExpr();
  if (!condition || !expect(TokenKind::RightParen, "after a condition", open))
    return nullptr;
  Stmt *thenBody = parseStatement();
  Stmt *elseBody = accept(TokenKind::KwElse) ? parseStatement() : nullptr;
  if (!thenBody)
    thenBody = ast.make<Stmt>(StmtKind::Empty, loc);
  return ast.make<IfStmt>(loc, condition, thenBody, elseBody);
}

Stmt *Parser::parseWhile() {
  SMLoc loc = take().loc, open = peek().loc;
  if (!expect(TokenKind::LeftParen, "after 'while'"))
    return nullptr;
  Expr *condition = parseExpr();
  if (!condition || !expect(TokenKind::RightParen, "after a condition", open))
    return nullptr;
  auto *loop = ast.make<LoopStmt>(StmtKind::While, loc);
  loop->condition = condition;
  loop->body = parseStatement();
  return loop;
}

Stmt *Parser::parseFor() {
  SMLoc loc = take().loc, open = peek().loc;
  if (!expect(TokenKind::LeftParen, "after 'for'"))
    return nullptr;
  auto *loop = ast.make<LoopStmt>(StmtKind::For, loc);
  if (!accept(TokenKind::Semicolon)) {
    if (atSpecifier()) {
      if (!(loop->init = parseDeclaration()))
        return nullptr;
    } else {
      Expr *init = parseList();
      if (!init || !expect(TokenKind::Semicolon, "after the start of a 'for'"))
        return nullptr;
      loop->init = ast.make<ExpressionStmt>(init);
    }
  }
  if (!at(TokenKind::Semicolon) && !(loop->condition = parseList()))
    return nullptr;
  if (!expect(TokenKind::Semicolon, "after the condition of a 'for'"))
    return nullptr;
  if (!at(TokenKind::RightParen) && !(loop->step = parseList()))
    return nullptr;
  if (!expect(TokenKind::RightParen, "after the head of a 'for'", open))
    return nullptr;
  loop->body = parseStatement();
  return loop;
}

Stmt *Parser::parseLight(StmtKind kind) {
  SMLoc loc = take().loc;
  std::vector<Expr *> args;
  if (!parseArguments(args))
    return nullptr;
  Stmt *body = parseStatement();
  if (!body)
    body = ast.make<Stmt>(StmtKind::Empty, loc);
  return ast.make<LightStmt>(kind, loc, ast.copy<Expr *>(args), body);
}

Stmt *Parser::parseGather() {
  SMLoc loc = take().loc;
  std::vector<Expr *> args;
  if (!parseArguments(args))
    return nullptr;
  Stmt *body = parseStatement();
  Stmt *elseBody = accept(TokenKind::KwElse) ? parseStatement() : nullptr;
  if (!body)
    body = ast.make<Stmt>(StmtKind::Empty, loc);
  return ast.make<GatherStmt>(loc, ast.copy<Expr *>(args), body, elseBody);
}

} // namespace anysl::rsl
