//===-- frontends/rsl/ParseDecl.cpp - shaders, functions, variables ---------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Parser.h"
#include "frontends/rsl/Warnings.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringSwitch.h"

using namespace llvm;

namespace anysl::rsl {

StringRef nameOf(ShaderType type) {
  switch (type) {
  case ShaderType::Surface:
    return "surface";
  case ShaderType::Displacement:
    return "displacement";
  case ShaderType::Light:
    return "light";
  case ShaderType::Volume:
    return "volume";
  case ShaderType::Imager:
    return "imager";
  case ShaderType::Method:
    return "method";
  }
  llvm_unreachable("unknown shader type");
}

/// The kind that a word in front of a shader's name means. These words are not reserved: shaders
/// use `light` and `surface` as names of variables and built-ins.
static std::optional<ShaderType> shaderType(StringRef word) {
  return StringSwitch<std::optional<ShaderType>>(word)
      .Case("surface", ShaderType::Surface)
      .Case("displacement", ShaderType::Displacement)
      .Case("light", ShaderType::Light)
      .Cases("volume", "transformation", ShaderType::Volume)
      .Case("imager", ShaderType::Imager)
      .Default(std::nullopt);
}

//===-- Words -----------------------------------------------------------------------------------//

Token Parser::take() {
  Token token = peek();
  if (position + 1 < tokens.size())
    ++position;
  return token;
}

bool Parser::accept(TokenKind kind) {
  if (!at(kind))
    return false;
  take();
  return true;
}

void Parser::errorHere(const Twine &message) {
  diags.error(peek().loc, message).range(peek().range());
}

/// Takes a word, or reports that it is missing; `open` is the bracket that it belongs to, if any.
bool Parser::expect(TokenKind kind, StringRef where, SMLoc open) {
  if (accept(kind))
    return true;
  // What is missing is missing behind the last word, which may be lines above the next.
  bool isBehind = kind == TokenKind::Semicolon || at(TokenKind::End) ||
                  diags.presumed(lastEnd()).line != diags.presumed(peek().loc).line;
  SMLoc loc = isBehind ? lastEnd() : peek().loc;
  auto error = diags.error(loc, "expected " + describe(kind) + " " + where);
  if (kind == TokenKind::Semicolon)
    error.fixit({lastEnd(), lastEnd()}, ";");
  if (open.isValid())
    error.note(open, "to match this '" + StringRef(open.getPointer(), 1) + "'",
               {open, SMLoc::getFromPointer(open.getPointer() + 1)});
  return false;
}

bool Parser::enter(SMLoc loc) {
  static constexpr unsigned MaxNesting = 256;
  if (depth >= MaxNesting) {
    diags.error(loc, "nested more than " + Twine(MaxNesting) + " levels deep");
    return false;
  }
  ++depth;
  return true;
}

/// Skips to behind the next ';' of this block, or to what closes or opens a block or starts a
/// declaration.
void Parser::skipStatement() {
  while (!peek().isOneOf(TokenKind::End, TokenKind::RightBrace)) {
    if (accept(TokenKind::Semicolon))
      return;
    if (at(TokenKind::LeftBrace)) {
      skipBrackets();
      return;
    }
    take();
  }
}

/// At a '{': skips to behind the '}' that belongs to it.
void Parser::skipBrackets() {
  unsigned open = 0;
  do {
    if (at(TokenKind::LeftBrace))
      ++open;
    else if (at(TokenKind::RightBrace))
      --open;
    take();
  } while (open && !at(TokenKind::End));
}

/// In a parameter list that makes no sense: skips the rest of the definition.
void Parser::skipBody() {
  while (!peek().isOneOf(TokenKind::End, TokenKind::LeftBrace, TokenKind::RightBrace))
    take();
  if (at(TokenKind::LeftBrace))
    skipBrackets();
}

void Parser::skipToDeclaration() {
  while (!at(TokenKind::End)) {
    if (at(TokenKind::LeftBrace)) {
      skipBrackets();
      return;
    }
    if (accept(TokenKind::Semicolon))
      return;
    take();
    if (at(TokenKind::Identifier) && shaderType(peek().text) && peek(1).is(TokenKind::Identifier) &&
        peek(2).is(TokenKind::LeftParen))
      return;
  }
}

bool Parser::atTypeName() const {
  return peek().kind >= TokenKind::KwFloat && peek().kind <= TokenKind::KwVoid;
}

bool Parser::atSpecifier() const {
  return atTypeName() || atNamedType() || atConstant() ||
         peek().isOneOf(TokenKind::KwUniform, TokenKind::KwVarying, TokenKind::KwOutput,
                        TokenKind::KwExtern);
}

//===-- Top level -------------------------------------------------------------------------------//

void Parser::parseFile() {
  while (!at(TokenKind::End) && !diags.reachedLimit()) {
    if (accept(TokenKind::Semicolon))
      continue;
    parseTopLevel();
  }
}

void Parser::parseTopLevel() {
  const Token &first = peek();
  if (first.is(TokenKind::Identifier) && first.text == "plugin" && peek(1).is(TokenKind::String))
    return parsePlugin();
  if (atDefinition("class", TokenKind::LeftParen))
    return parseClass();
  if (atDefinition("struct", TokenKind::LeftBrace)) {
    ast.items.push_back({nullptr, nullptr, parseStruct()});
    return;
  }
  if (!atNamedType() && first.is(TokenKind::Identifier) && peek(1).is(TokenKind::Identifier)) {
    if (std::optional<ShaderType> type = shaderType(first.text))
      return parseShader(*type);
    if (first.text == "class" || first.text == "struct") {
      diags
          .error(peek(1).end, first.text == "class"
                                  ? "expected '(' and a class's parameters; there is no inheritance"
                                  : "expected '{' behind the name of a structure")
          .range(peek(1).range());
      return skipToDeclaration();
    }
    diags
        .error(first.loc,
               "unknown kind of shader '" + first.text + "'" +
                   didYouMean(first.text, {"surface", "displacement", "light", "volume", "imager",
                                           "class", "struct", "void", "float", "color", "point",
                                           "vector", "normal", "matrix", "string"}))
        .range(first.range());
    return skipToDeclaration();
  }
  bool isUntypedFunction = first.is(TokenKind::Identifier) && peek(1).is(TokenKind::LeftParen);
  if (!atSpecifier() && !isUntypedFunction) {
    errorHere("expected a shader or a function, not " + (first.is(TokenKind::Identifier)
                                                             ? "'" + first.text.str() + "'"
                                                             : describe(first.kind).str()));
    return skipToDeclaration();
  }
  Specifiers specifiers = parseSpecifiers();
  if (!parseArrayResult(specifiers))
    return skipToDeclaration();
  if (!at(TokenKind::Identifier) || !peek(1).is(TokenKind::LeftParen)) {
    if (at(TokenKind::Identifier))
      errorHere("variables cannot be declared outside of shaders and functions");
    else
      errorHere("expected the name of a function, not " + describe(peek().kind));
    return skipToDeclaration();
  }
  if (FunctionDecl *decl = parseFunction(specifiers)) {
    ast.functions.push_back(decl);
    ast.items.push_back({decl, nullptr, nullptr});
  }
}

/// `plugin "name";` names compiled code of another renderer. The shader may still do without it.
void Parser::parsePlugin() {
  SMLoc begin = take().loc;
  Token name = take();
  diags
      .warning(begin, warn::Plugin,
               "plugin " + name.text + " is ignored: its functions are unknown")
      .range(rangeFrom(begin));
  accept(TokenKind::Semicolon);
}

void Parser::parseShader(ShaderType type) {
  take();
  Token name = take();
  std::vector<VarDecl *> params;
  if (!parseParams(VarKind::ShaderParam, params, nullptr))
    return skipBody();
  if (!at(TokenKind::LeftBrace)) {
    expect(TokenKind::LeftBrace, "before the body of a shader");
    return skipToDeclaration();
  }
  for (size_t i = 0; i < params.size(); ++i)
    params[i]->id = static_cast<unsigned>(i);
  ShaderDecl shader{type, name.text, name.range(), ast.copy<VarDecl *>(params)};
  shader.body = parseBlock();
  auto *decl = ast.make<ShaderDecl>(shader);
  ast.shaders.push_back(decl);
  ast.items.push_back({nullptr, decl, nullptr});
}

FunctionDecl *Parser::parseFunction(const Specifiers &specifiers) {
  Token name = take();
  auto *decl = ast.make<FunctionDecl>();
  decl->name = name.text;
  decl->range = name.range();
  decl->result = {specifiers.hasType ? specifiers.type : TypeKind::Void, specifiers.varying,
                  specifiers.isArray ? Type::AnyLength : Type::NoArray, specifiers.structure};
  decl->resultHasStorage = specifiers.hasStorage;
  decl->resultLength = specifiers.length;
  decl->outer = function;
  function = decl;
  std::vector<VarDecl *> params;
  bool ok = parseParams(VarKind::FunctionParam, params, decl);
  if (!ok) {
    skipBody();
  } else if (!at(TokenKind::LeftBrace)) {
    expect(TokenKind::LeftBrace, "before the body of a function");
    skipToDeclaration();
    ok = false;
  } else {
    decl->params = ast.copy<VarDecl *>(params);
    decl->body = parseBlock();
  }
  function = decl->outer;
  if (ok)
    makeShorterForms(*decl);
  return ok ? decl : nullptr;
}

/// Whether `[…] name(` stands there, as between the type of a function's result and its name.
bool Parser::atArrayResult(unsigned ahead) const {
  if (!peek(ahead).is(TokenKind::LeftBracket))
    return false;
  unsigned open = 0;
  do {
    if (peek(ahead).isOneOf(TokenKind::End, TokenKind::Semicolon, TokenKind::LeftBrace))
      return false;
    open += peek(ahead).is(TokenKind::LeftBracket);
    open -= peek(ahead).is(TokenKind::RightBracket);
    ++ahead;
  } while (open);
  return peek(ahead).is(TokenKind::Identifier) && peek(ahead + 1).is(TokenKind::LeftParen);
}

/// `[]` or `[length]` of a function that gives an array; false after an error.
bool Parser::parseArrayResult(Specifiers &specifiers) {
  if (!specifiers.hasType || !atArrayResult(0))
    return true;
  SMLoc begin = take().loc;
  specifiers.isArray = true;
  if (!at(TokenKind::RightBracket) && !(specifiers.length = parseExpr()))
    return false;
  if (!expect(TokenKind::RightBracket, "after the length of an array"))
    return false;
  if (specifiers.type == TypeKind::Void) {
    diags.error(begin, "there are no arrays of 'void'").range(rangeFrom(begin));
    specifiers.type = TypeKind::Error;
  }
  return true;
}

/// Functions for calls that leave out the last arguments, the longest first. Where a parameter was,
/// they have a variable with its default, and they call the next longer one:
/// `float f(float a; float b = 2 * a)` also is `float f(float a) { float b = 2 * a; return f(a, b);
/// }`
void Parser::makeShorterForms(FunctionDecl &decl) {
  size_t required = decl.params.size();
  while (required > 0 && decl.params[required - 1]->init)
    --required;
  for (size_t i = 0; i < required; ++i)
    if (VarDecl &param = *decl.params[i]; param.init) {
      diags
          .error(param.init->loc,
                 "parameter '" + param.name + "' cannot have a default: one behind it has none")
          .range(param.init->range);
      param.init = nullptr;
    }
  std::vector<FunctionDecl *> forms;
  for (size_t count = decl.params.size(); count-- > required;) {
    auto *form = ast.make<FunctionDecl>(decl);
    std::vector<VarDecl *> params;
    std::vector<Expr *> arguments;
    for (VarDecl *param : decl.params) {
      if (params.size() <= count) {
        params.push_back(ast.make<VarDecl>(*param));
        params.back()->owner = form;
        params.back()->init = nullptr;
      }
      if (arguments.size() <= count)
        arguments.push_back(ast.make<NameExpr>(param->range, param->name));
    }
    VarDecl *left = params.back();
    params.pop_back();
    left->kind = VarKind::Local;
    left->isOutput = false;
    left->init = std::exchange(decl.params[count]->init, nullptr);
    auto *call = ast.make<CallExpr>(decl.range, decl.range, decl.name, ast.copy<Expr *>(arguments));
    bool isVoid = decl.result.kind == TypeKind::Void;
    Stmt *steps[] = {ast.make<DeclarationStmt>(left->range.Start, ast.copy<VarDecl *>(left)),
                     isVoid ? static_cast<Stmt *>(ast.make<ExpressionStmt>(call))
                            : ast.make<ReturnStmt>(decl.range.Start, call)};
    form->params = ast.copy<VarDecl *>(params);
    form->body = ast.make<BlockStmt>(decl.range.Start, decl.range.End, ast.copy<Stmt *>(steps));
    forms.push_back(form);
  }
  decl.shorter = ast.copy<FunctionDecl *>(forms);
}

/// `(type a, b; type c …)`; a comma may also stand before a new type.
bool Parser::parseParams(VarKind kind, std::vector<VarDecl *> &params, FunctionDecl *owner) {
  if (!expect(TokenKind::LeftParen, "before parameters"))
    return false;
  while (!at(TokenKind::RightParen)) {
    if (accept(TokenKind::Semicolon))
      continue;
    if (!atSpecifier()) {
      errorHere("expected a parameter's type or ')', not " + (at(TokenKind::Identifier)
                                                                  ? "'" + peek().text.str() + "'"
                                                                  : describe(peek().kind).str()));
      return false;
    }
    Specifiers specifiers = parseSpecifiers();
    if (!specifiers.hasType || specifiers.type == TypeKind::Void) {
      if (specifiers.type == TypeKind::Void && at(TokenKind::RightParen) && params.empty())
        continue; // (void)
      diags.error(specifiers.loc, "a parameter needs a type");
      specifiers.type = TypeKind::Float;
    }
    do {
      VarDecl *param = parseVariable(kind, specifiers, owner);
      if (!param)
        return false;
      params.push_back(param);
    } while (accept(TokenKind::Comma) && !atSpecifier());
    if (!at(TokenKind::RightParen) && !at(TokenKind::Semicolon) && !atSpecifier()) {
      errorHere("expected ';', ',' or ')' after a parameter, not " + describe(peek().kind));
      return false;
    }
  }
  take();
  return true;
}

Parser::Specifiers Parser::parseSpecifiers() {
  Specifiers specifiers;
  specifiers.loc = peek().loc;
  while (atSpecifier() && !(specifiers.hasType && atNamedType())) {
    const Token &token = peek();
    switch (token.kind) {
    case TokenKind::KwOutput:
      specifiers.isOutput = true;
      break;
    case TokenKind::KwExtern:
      specifiers.isExtern = true;
      break;
    case TokenKind::KwUniform:
    case TokenKind::KwVarying:
      specifiers.hasStorage = true;
      specifiers.varying = token.is(TokenKind::KwVarying);
      break;
    case TokenKind::Identifier:
      if (atConstant()) { // the same for the whole surface: uniform is all that shaders notice
        specifiers.hasStorage = true;
        specifiers.varying = false;
        break;
      }
      specifiers.hasType = true;
      specifiers.structure = structNamed(token.text);
      specifiers.type = specifiers.structure ? TypeKind::Struct : TypeKind::Shader;
      break;
    default:
      if (specifiers.hasType) {
        errorHere("two types in one declaration");
        break;
      }
      specifiers.hasType = true;
      switch (token.kind) {
      case TokenKind::KwFloat:
        specifiers.type = TypeKind::Float;
        break;
      case TokenKind::KwColor:
        specifiers.type = TypeKind::Color;
        break;
      case TokenKind::KwPoint:
        specifiers.type = TypeKind::Point;
        break;
      case TokenKind::KwVector:
        specifiers.type = TypeKind::Vector;
        break;
      case TokenKind::KwNormal:
        specifiers.type = TypeKind::Normal;
        break;
      case TokenKind::KwMatrix:
        specifiers.type = TypeKind::Matrix;
        break;
      case TokenKind::KwString:
        specifiers.type = TypeKind::String;
        break;
      default:
        specifiers.type = TypeKind::Void;
        break;
      }
    }
    take();
  }
  return specifiers;
}

/// `name`, `name[length]`, each with an optional `= value`.
VarDecl *Parser::parseVariable(VarKind kind, const Specifiers &specifiers, FunctionDecl *owner) {
  if (!at(TokenKind::Identifier)) {
    if (peek().isKeyword())
      errorHere("'" + peek().text + "' is a reserved word and cannot be a name");
    else
      errorHere("expected a name in a declaration, not " + describe(peek().kind));
    return nullptr;
  }
  Token name = take();
  auto *decl = ast.make<VarDecl>();
  decl->kind = kind;
  decl->name = name.text;
  decl->range = name.range();
  decl->owner = owner;
  decl->isOutput = specifiers.isOutput;
  decl->hasStorage = specifiers.hasStorage;
  // Parameters of shaders are uniform unless they say otherwise, everything else varies.
  decl->type.kind = specifiers.type;
  decl->type.structure = specifiers.structure;
  decl->type.varying = specifiers.hasStorage ? specifiers.varying : kind != VarKind::ShaderParam;
  if (accept(TokenKind::LeftBracket)) {
    decl->type.length = Type::AnyLength;
    if (!at(TokenKind::RightBracket) && !(decl->length = parseExpr()))
      return nullptr;
    if (!expect(TokenKind::RightBracket, "after the length of an array"))
      return nullptr;
  }
  if (accept(TokenKind::Equal) && !(decl->init = parseExpr()))
    return nullptr;
  // An array of no shaders.
  if (auto *none = dyn_cast_or_null<NameExpr>(decl->init);
      none && none->name == "null" && decl->type.isArray())
    decl->init = ast.make<ListExpr>(none->range, MutableArrayRef<Expr *>());
  return decl;
}

} // namespace anysl::rsl
