//===-- frontends/rsl/ParseStruct.cpp - structures and class shaders --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Parser.h"

using namespace llvm;

namespace anysl::rsl {

/// The structure that a name means here; null if it means none.
StructDecl *Parser::structNamed(StringRef name) const {
  for (StructDecl *structure : llvm::reverse(structs))
    if (structure->name == name)
      return structure;
  return nullptr;
}

/// At a type that is no reserved word: `shader`, or the name of a structure, in front of a name or
/// of the brackets of a function's result.
bool Parser::atNamedType() const {
  return at(TokenKind::Identifier) && (peek(1).is(TokenKind::Identifier) || atArrayResult(1)) &&
         (peek().text == "shader" || structNamed(peek().text));
}

/// At `constant` in front of a type.
bool Parser::atConstant() const {
  bool isType = peek(1).kind >= TokenKind::KwFloat && peek(1).kind <= TokenKind::KwString;
  return at(TokenKind::Identifier) && peek().text == "constant" &&
         (isType || (peek(1).is(TokenKind::Identifier) && peek(2).is(TokenKind::Identifier)));
}

/// At `word name` and what opens a definition. These words are not reserved either.
bool Parser::atDefinition(StringRef word, TokenKind open) const {
  return at(TokenKind::Identifier) && peek().text == word && peek(1).is(TokenKind::Identifier) &&
         peek(2).is(open);
}

/// struct name { type member = default, …; … methods … }
StructDecl *Parser::parseStruct() {
  take();
  Token name = take();
  auto *decl = ast.make<StructDecl>();
  decl->name = name.text;
  decl->range = name.range();
  parseMembers(*decl);
  accept(TokenKind::Semicolon);
  structs.push_back(decl);
  return decl;
}

/// class name(parameters) { members and methods }
void Parser::parseClass() {
  take();
  Token name = take();
  auto *decl = ast.make<StructDecl>();
  decl->name = name.text;
  decl->range = name.range();
  decl->isClass = true;
  std::vector<VarDecl *> params;
  if (!parseParams(VarKind::ShaderParam, params, nullptr))
    return skipBody();
  for (size_t i = 0; i < params.size(); ++i)
    params[i]->id = static_cast<unsigned>(i);
  decl->params = ast.copy<VarDecl *>(params);
  if (!at(TokenKind::LeftBrace)) {
    expect(TokenKind::LeftBrace, "before the members of a class");
    return skipToDeclaration();
  }
  size_t outerStructs = structs.size();
  parseMembers(*decl);
  structs.resize(outerStructs);
  accept(TokenKind::Semicolon);
  ast.items.push_back({nullptr, nullptr, decl});
}

void Parser::parseMembers(StructDecl &decl) {
  Token open = take();
  std::vector<VarDecl *> members;
  std::vector<FunctionDecl *> methods;
  std::vector<StructDecl *> inner;
  while (!at(TokenKind::RightBrace) && !at(TokenKind::End) && !diags.reachedLimit()) {
    if (accept(TokenKind::Semicolon))
      continue;
    if (atDefinition("struct", TokenKind::LeftBrace)) {
      inner.push_back(parseStruct());
      continue;
    }
    size_t before = position;
    if (!parseMember(decl, members, methods)) {
      skipStatement();
      if (position == before)
        take();
    }
  }
  if (!accept(TokenKind::RightBrace))
    diags.error(lastEnd(), "expected '}' at the end of '" + decl.name + "'")
        .note(open.loc, "to match this '{'", open.range());
  decl.members = ast.copy<VarDecl *>(members);
  decl.methods = ast.copy<FunctionDecl *>(methods);
  decl.inner = ast.copy<StructDecl *>(inner);
}

/// `[public] type name = default, …;` or a method; false after an error.
bool Parser::parseMember(StructDecl &decl, std::vector<VarDecl *> &members,
                         std::vector<FunctionDecl *> &methods) {
  bool isPublic = false;
  while (at(TokenKind::Identifier) && (peek().text == "public" || peek().text == "private"))
    isPublic = take().text == "public";
  Specifiers specifiers = parseSpecifiers();
  if (!parseArrayResult(specifiers))
    return false;
  if (at(TokenKind::Identifier) && peek(1).is(TokenKind::LeftParen)) {
    size_t before = methods.size();
    FunctionDecl *method = parseFunction(specifiers);
    if (!method)
      return true; // what is wrong has been skipped
    methods.push_back(method);
    methods.insert(methods.end(), method->shorter.begin(), method->shorter.end());
    method->shorter = {};
    for (FunctionDecl *form : ArrayRef(methods).drop_front(before)) {
      form->parent = &decl;
      form->isPublic = isPublic;
    }
    return true;
  }
  if (!specifiers.hasType || specifiers.type == TypeKind::Void) {
    if (at(TokenKind::Identifier) && peek(1).is(TokenKind::Identifier))
      errorHere("unknown type '" + peek().text + "'");
    else
      errorHere("expected a member or a method");
    return false;
  }
  do {
    VarDecl *member = parseVariable(VarKind::Local, specifiers, function);
    if (!member)
      return false;
    // A structure's members are uniform unless they say otherwise.
    if (!decl.isClass && !specifiers.hasStorage)
      member->type.varying = false;
    members.push_back(member);
  } while (accept(TokenKind::Comma));
  expect(TokenKind::Semicolon, "after a member");
  return true;
}

/// `a->b`, `a->f(…)`
Expr *Parser::parseArrow(Expr *base, SMLoc begin) {
  take();
  if (!at(TokenKind::Identifier)) {
    errorHere("expected the name of a member after '->', not " + describe(peek().kind));
    return nullptr;
  }
  if (peek(1).is(TokenKind::LeftParen)) {
    auto *call = cast_or_null<CallExpr>(parseCall());
    if (!call)
      return nullptr;
    call->object = base;
    call->range = rangeFrom(begin);
    call->depth = std::max(call->depth, base->depth + 1);
    return call;
  }
  Token name = take();
  auto *member = ast.make<MemberExpr>(rangeFrom(begin), base, name.text, name.range());
  member->depth = base->depth + 1;
  return member;
}

} // namespace anysl::rsl
