//===-- frontends/rsl/ParseExpr.cpp - expressions ---------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Literals.h"
#include "frontends/rsl/Parser.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace anysl::rsl {

/// Deeper trees than people write would overflow the stack of what walks them.
static constexpr unsigned MaxDepth = 1000;

StringRef spelling(BinaryOp op) {
  switch (op) {
  case BinaryOp::Add:
    return "+";
  case BinaryOp::Subtract:
    return "-";
  case BinaryOp::Multiply:
    return "*";
  case BinaryOp::Divide:
    return "/";
  case BinaryOp::Dot:
    return ".";
  case BinaryOp::Cross:
    return "^";
  case BinaryOp::Less:
    return "<";
  case BinaryOp::LessEqual:
    return "<=";
  case BinaryOp::Greater:
    return ">";
  case BinaryOp::GreaterEqual:
    return ">=";
  case BinaryOp::Equal:
    return "==";
  case BinaryOp::NotEqual:
    return "!=";
  case BinaryOp::And:
    return "&&";
  case BinaryOp::Or:
    return "||";
  }
  llvm_unreachable("unknown operator");
}

/// Gives a node the depth of its children plus one; null if that is too much.
template <typename T>
T *Parser::grown(T *node, std::initializer_list<const Expr *> children) {
  for (const Expr *child : children)
    if (child)
      node->depth = std::max(node->depth, child->depth + 1);
  if (node->depth <= MaxDepth)
    return node;
  diags.error(node->loc, "expression too long: more than " + Twine(MaxDepth) + " levels deep");
  return nullptr;
}

Expr *Parser::parseExpr() {
  if (!enter(peek().loc))
    return nullptr;
  Expr *expr = parseAssignment();
  --depth;
  return expr;
}

/// Expressions with commas between them.
Expr *Parser::parseList() {
  SMLoc begin = peek().loc;
  Expr *first = parseExpr();
  if (!first || !at(TokenKind::Comma))
    return first;
  std::vector<Expr *> elements{first};
  while (accept(TokenKind::Comma)) {
    Expr *next = parseExpr();
    if (!next)
      return nullptr;
    elements.push_back(next);
  }
  auto *list = ast.make<CommaExpr>(rangeFrom(begin), ast.copy<Expr *>(elements));
  for (Expr *element : elements)
    list->depth = std::max(list->depth, element->depth + 1);
  return list;
}

Expr *Parser::parseAssignment() {
  SMLoc begin = peek().loc;
  Expr *target = parseConditional();
  if (!target)
    return nullptr;
  std::optional<BinaryOp> op;
  switch (peek().kind) {
  case TokenKind::Equal:
    break;
  case TokenKind::PlusEqual:
    op = BinaryOp::Add;
    break;
  case TokenKind::MinusEqual:
    op = BinaryOp::Subtract;
    break;
  case TokenKind::StarEqual:
    op = BinaryOp::Multiply;
    break;
  case TokenKind::SlashEqual:
    op = BinaryOp::Divide;
    break;
  case TokenKind::CaretEqual:
    op = BinaryOp::Cross;
    break;
  default:
    return target;
  }
  SMLoc loc = take().loc;
  Expr *value = parseExpr(); // to the right: a = b = c
  if (!value)
    return nullptr;
  SMRange range = rangeFrom(begin);
  return grown(op ? ast.make<AssignExpr>(loc, range, *op, target, value)
                  : ast.make<AssignExpr>(loc, range, target, value),
               {target, value});
}

Expr *Parser::parseConditional() {
  SMLoc begin = peek().loc;
  Expr *condition = parseBinary(1);
  if (!condition || !at(TokenKind::Question))
    return condition;
  SMLoc loc = take().loc;
  Expr *whenTrue = parseExpr();
  if (!whenTrue || !expect(TokenKind::Colon, "in '?:'"))
    return nullptr;
  Expr *whenFalse = parseExpr();
  if (!whenFalse)
    return nullptr;
  return grown(ast.make<ConditionalExpr>(loc, rangeFrom(begin), condition, whenTrue, whenFalse),
               {condition, whenTrue, whenFalse});
}

namespace {
struct BinaryLevel {
  int level = 0;
  BinaryOp op = BinaryOp::Add;
};
} // namespace

static BinaryLevel binaryLevel(TokenKind kind) {
  switch (kind) {
  case TokenKind::OrOr:
    return {1, BinaryOp::Or};
  case TokenKind::AndAnd:
    return {2, BinaryOp::And};
  case TokenKind::EqualEqual:
    return {3, BinaryOp::Equal};
  case TokenKind::NotEqual:
    return {3, BinaryOp::NotEqual};
  case TokenKind::Less:
    return {4, BinaryOp::Less};
  case TokenKind::LessEqual:
    return {4, BinaryOp::LessEqual};
  case TokenKind::Greater:
    return {4, BinaryOp::Greater};
  case TokenKind::GreaterEqual:
    return {4, BinaryOp::GreaterEqual};
  case TokenKind::Plus:
    return {5, BinaryOp::Add};
  case TokenKind::Minus:
    return {5, BinaryOp::Subtract};
  case TokenKind::Caret:
    return {6, BinaryOp::Cross};
  case TokenKind::Star:
    return {7, BinaryOp::Multiply};
  case TokenKind::Slash:
    return {7, BinaryOp::Divide};
  case TokenKind::Dot:
    return {8, BinaryOp::Dot};
  default:
    return {};
  }
}

Expr *Parser::parseBinary(int least) {
  SMLoc begin = peek().loc;
  Expr *left = parseUnary();
  while (left) {
    if (at(TokenKind::Percent)) {
      errorHere("RSL has no '%'; use mod(a, b)");
      return nullptr;
    }
    BinaryLevel next = binaryLevel(peek().kind);
    if (!next.level || next.level < least)
      return left;
    SMLoc loc = take().loc;
    Expr *right = parseBinary(next.level + 1);
    if (!right)
      return nullptr;
    left = grown(ast.make<BinaryExpr>(loc, rangeFrom(begin), next.op, left, right), {left, right});
  }
  return nullptr;
}

/// RSL has no `--`: in `a--1` and `--1` it is two minus signs. Before and behind a variable alone
/// it is what other languages have, see parseIncrement.
void Parser::splitMinus(bool isPrefix) {
  if (!at(TokenKind::MinusMinus) || !(peek(1).isOneOf(TokenKind::Number, TokenKind::LeftParen) ||
                                      (!isPrefix && peek(1).is(TokenKind::Identifier))))
    return;
  Token first = peek(), second = first;
  first.kind = second.kind = TokenKind::Minus;
  first.end = second.loc = SMLoc::getFromPointer(first.loc.getPointer() + 1);
  tokens[position] = first;
  tokens.insert(tokens.begin() + static_cast<ptrdiff_t>(position) + 1, second);
}

Expr *Parser::parseUnary() {
  splitMinus(/*isPrefix=*/true);
  const Token &token = peek();
  if (token.isOneOf(TokenKind::Minus, TokenKind::Not, TokenKind::Plus)) {
    TokenKind kind = token.kind;
    SMLoc loc = take().loc;
    if (!enter(loc))
      return nullptr;
    Expr *operand = parseUnary();
    --depth;
    if (!operand || kind == TokenKind::Plus)
      return operand;
    if (kind == TokenKind::Not)
      return grown(ast.make<NotExpr>(loc, rangeFrom(loc), operand), {operand});
    return grown(ast.make<NegateExpr>(loc, rangeFrom(loc), operand), {operand});
  }
  if (token.isOneOf(TokenKind::PlusPlus, TokenKind::MinusMinus))
    return parseIncrement(nullptr, token.loc);
  if (atTypeName())
    return parseCast();
  return parsePostfix();
}

Expr *Parser::parseCast() {
  Token type = take();
  TypeKind kind = TypeKind::Error;
  switch (type.kind) {
  case TokenKind::KwFloat:
    kind = TypeKind::Float;
    break;
  case TokenKind::KwColor:
    kind = TypeKind::Color;
    break;
  case TokenKind::KwPoint:
    kind = TypeKind::Point;
    break;
  case TokenKind::KwVector:
    kind = TypeKind::Vector;
    break;
  case TokenKind::KwNormal:
    kind = TypeKind::Normal;
    break;
  case TokenKind::KwMatrix:
    kind = TypeKind::Matrix;
    break;
  case TokenKind::KwString:
    kind = TypeKind::String;
    break;
  default:
    diags.error(type.loc, "a value cannot be converted to 'void'").range(type.range());
    return nullptr;
  }
  Expr *space = nullptr;
  if (at(TokenKind::String) && kind != TypeKind::String) {
    Token name = take();
    space = ast.make<StringExpr>(name.range(), ast.save(unquote(name.text)));
  }
  if (!enter(type.loc))
    return nullptr;
  Expr *operand = parseUnary();
  --depth;
  if (!operand)
    return nullptr;
  return grown(ast.make<CastExpr>(type.loc, rangeFrom(type.loc), kind, space, operand), {operand});
}

Expr *Parser::parsePostfix() {
  SMLoc begin = peek().loc;
  Expr *expr = parsePrimary();
  while (expr && peek().isOneOf(TokenKind::LeftBracket, TokenKind::Arrow)) {
    if (at(TokenKind::Arrow)) {
      expr = parseArrow(expr, begin);
      if (expr && !grown(expr, {}))
        return nullptr;
      continue;
    }
    SMLoc loc = take().loc;
    Expr *index = parseExpr();
    if (!index || !expect(TokenKind::RightBracket, "after an index", loc))
      return nullptr;
    expr = grown(ast.make<IndexExpr>(loc, rangeFrom(begin), expr, index), {expr, index});
  }
  splitMinus(/*isPrefix=*/false);
  if (expr && peek().isOneOf(TokenKind::PlusPlus, TokenKind::MinusMinus))
    return parseIncrement(expr, begin);
  return expr;
}

/// At a `++` or `--` behind its operand, or, where that is null, in front of it: reported, and
/// taken for what it means.
Expr *Parser::parseIncrement(Expr *operand, SMLoc begin) {
  Token token = take();
  std::string instead = (token.text.take_front() + "= 1").str();
  auto error = diags.error(token.loc, "RSL has no '" + token.text + "'; write '" + instead + "'");
  error.range(token.range());
  if (operand)
    error.fixit(token.range(), " " + instead);
  else if (!enter(token.loc))
    return nullptr;
  else if (operand = parsePostfix(), --depth; !operand)
    return nullptr;
  auto *one = ast.make<NumberExpr>(token.range(), 1.0);
  return grown(
      ast.make<AssignExpr>(token.loc, rangeFrom(begin),
                           token.is(TokenKind::PlusPlus) ? BinaryOp::Add : BinaryOp::Subtract,
                           operand, one),
      {operand, one});
}

Expr *Parser::parsePrimary() {
  const Token &token = peek();
  switch (token.kind) {
  case TokenKind::Number: {
    double value = 0;
    if (!parseNumber(token.text, value))
      diags.error(token.loc, "'" + token.text + "' is not a number").range(token.range());
    return ast.make<NumberExpr>(take().range(), value);
  }
  case TokenKind::String: {
    SMLoc begin = token.loc;
    std::string value;
    while (at(TokenKind::String)) // adjacent strings are one
      value += unquote(take().text);
    return ast.make<StringExpr>(rangeFrom(begin), ast.save(value));
  }
  case TokenKind::Identifier:
    if (peek(1).is(TokenKind::LeftParen))
      return parseCall();
    return ast.make<NameExpr>(take().range(), token.text);
  case TokenKind::LeftParen:
    return parseParenthesised();
  case TokenKind::LeftBrace:
    return parseInitialiser();
  default:
    break;
  }
  if (token.isKeyword())
    errorHere("expected an expression, not the reserved word '" + token.text + "'");
  else
    errorHere("expected an expression, not " + describe(token.kind));
  return nullptr;
}

bool Parser::parseArguments(std::vector<Expr *> &args) {
  SMLoc open = peek().loc;
  if (!expect(TokenKind::LeftParen, "before arguments"))
    return false;
  if (accept(TokenKind::RightParen))
    return true;
  do {
    Expr *arg = parseExpr();
    if (!arg)
      return false;
    args.push_back(arg);
  } while (accept(TokenKind::Comma));
  return expect(TokenKind::RightParen, "after arguments", open);
}

Expr *Parser::parseCall() {
  Token name = take();
  std::vector<Expr *> args;
  if (!parseArguments(args))
    return nullptr;
  auto *call =
      ast.make<CallExpr>(name.range(), rangeFrom(name.loc), name.text, ast.copy<Expr *>(args));
  for (Expr *arg : args)
    if (!grown(call, {arg}))
      return nullptr;
  return call;
}

/// (expr), or a triple or matrix of comma-separated values.
Expr *Parser::parseParenthesised() {
  SMLoc begin = take().loc;
  if (atTypeName() && peek(1).is(TokenKind::RightParen)) {
    diags
        .error(begin,
               "a conversion is written '" + peek().text + " x', without brackets around the type")
        .range({begin, peek(1).end});
    return nullptr;
  }
  std::vector<Expr *> elements;
  do {
    Expr *element = parseExpr();
    if (!element)
      return nullptr;
    elements.push_back(element);
  } while (accept(TokenKind::Comma));
  if (!expect(TokenKind::RightParen, "after an expression", begin))
    return nullptr;
  if (elements.size() == 1) {
    // A message about an operation underlines its brackets too.
    if (isa<BinaryExpr, ConditionalExpr, AssignExpr>(elements[0]))
      elements[0]->range = rangeFrom(begin);
    return elements[0];
  }
  auto *tuple = ast.make<TupleExpr>(rangeFrom(begin), ast.copy<Expr *>(elements));
  for (Expr *element : elements)
    if (!grown(tuple, {element}))
      return nullptr;
  return tuple;
}

/// {a, b, …}
Expr *Parser::parseInitialiser() {
  SMLoc begin = take().loc;
  std::vector<Expr *> elements;
  while (!at(TokenKind::RightBrace)) {
    Expr *element = parseExpr();
    if (!element)
      return nullptr;
    elements.push_back(element);
    if (!accept(TokenKind::Comma))
      break;
  }
  if (!expect(TokenKind::RightBrace, "after the elements of an array", begin))
    return nullptr;
  auto *list = ast.make<ListExpr>(rangeFrom(begin), ast.copy<Expr *>(elements));
  for (Expr *element : elements)
    if (!grown(list, {element}))
      return nullptr;
  return list;
}

} // namespace anysl::rsl
