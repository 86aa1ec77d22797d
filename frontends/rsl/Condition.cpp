//===-- frontends/rsl/Condition.cpp - the conditions of #if -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Condition.h"

using namespace llvm;

namespace anysl::rsl {
namespace {

/// The integer expressions of #if, by precedence climbing.
class ConditionParser {
public:
  ConditionParser(ArrayRef<Token> tokens, SMLoc loc, DiagnosticEngine &diags)
      : tokens(tokens), loc(loc), diags(diags) {}

  bool parse() {
    if (tokens.empty()) {
      fail(loc, "#if without a condition");
      return false;
    }
    int64_t value = conditional();
    if (!failed && position < tokens.size())
      fail(tokens[position].loc, "unexpected '" + tokens[position].text + "' in a condition");
    return !failed && value != 0;
  }

private:
  TokenKind kind() const {
    return position < tokens.size() ? tokens[position].kind : TokenKind::End;
  }
  void fail(SMLoc where, const Twine &message) {
    if (!failed)
      diags.error(where, message);
    failed = true;
  }

  int64_t conditional() {
    int64_t condition = binary(1);
    if (kind() != TokenKind::Question)
      return condition;
    ++position;
    if (++depth > MaxDepth)
      return tooDeep();
    int64_t first = conditional();
    if (kind() != TokenKind::Colon) {
      fail(loc, "'?' without ':' in a condition");
      return 0;
    }
    ++position;
    int64_t second = conditional();
    --depth;
    return condition ? first : second;
  }

  static int precedence(TokenKind kind) {
    switch (kind) {
    case TokenKind::OrOr:
      return 1;
    case TokenKind::AndAnd:
      return 2;
    case TokenKind::Or:
      return 3;
    case TokenKind::Caret:
      return 4;
    case TokenKind::And:
      return 5;
    case TokenKind::EqualEqual:
    case TokenKind::NotEqual:
      return 6;
    case TokenKind::Less:
    case TokenKind::Greater:
    case TokenKind::LessEqual:
    case TokenKind::GreaterEqual:
      return 7;
    case TokenKind::LessLess:
    case TokenKind::GreaterGreater:
      return 8;
    case TokenKind::Plus:
    case TokenKind::Minus:
      return 9;
    case TokenKind::Star:
    case TokenKind::Slash:
    case TokenKind::Percent:
      return 10;
    default:
      return 0;
    }
  }

  int64_t binary(int least) {
    int64_t left = unary();
    while (int level = precedence(kind())) {
      if (level < least)
        break;
      TokenKind op = kind();
      SMLoc where = tokens[position++].loc;
      left = apply(op, left, binary(level + 1), where);
    }
    return left;
  }

  int64_t apply(TokenKind op, int64_t a, int64_t b, SMLoc where) {
    // Unsigned arithmetic wraps where signed overflow would be undefined.
    auto ua = static_cast<uint64_t>(a), ub = static_cast<uint64_t>(b);
    switch (op) {
    case TokenKind::OrOr:
      return a || b;
    case TokenKind::AndAnd:
      return a && b;
    case TokenKind::Or:
      return a | b;
    case TokenKind::Caret:
      return a ^ b;
    case TokenKind::And:
      return a & b;
    case TokenKind::EqualEqual:
      return a == b;
    case TokenKind::NotEqual:
      return a != b;
    case TokenKind::Less:
      return a < b;
    case TokenKind::Greater:
      return a > b;
    case TokenKind::LessEqual:
      return a <= b;
    case TokenKind::GreaterEqual:
      return a >= b;
    case TokenKind::LessLess:
      return ub < 64 ? static_cast<int64_t>(ua << ub) : 0;
    case TokenKind::GreaterGreater:
      return ub < 64 ? a >> b : 0;
    case TokenKind::Plus:
      return static_cast<int64_t>(ua + ub);
    case TokenKind::Minus:
      return static_cast<int64_t>(ua - ub);
    case TokenKind::Star:
      return static_cast<int64_t>(ua * ub);
    default:
      break;
    }
    if (b == 0) {
      fail(where, "division by zero in a condition");
      return 0;
    }
    if (b == -1)
      return op == TokenKind::Slash ? static_cast<int64_t>(0 - ua) : 0;
    return op == TokenKind::Slash ? a / b : a % b;
  }

  int64_t tooDeep() {
    fail(loc, "condition nested too deeply");
    position = tokens.size();
    return 0;
  }

  int64_t unary() {
    if (++depth > MaxDepth)
      return tooDeep();
    int64_t value = primary();
    --depth;
    return value;
  }

  int64_t primary() {
    if (position == tokens.size()) {
      fail(loc, "a condition ends too early");
      return 0;
    }
    const Token &token = tokens[position++];
    switch (token.kind) {
    case TokenKind::Not:
      return !unary();
    case TokenKind::Tilde:
      return ~unary();
    case TokenKind::Minus:
      return static_cast<int64_t>(0 - static_cast<uint64_t>(unary()));
    case TokenKind::Plus:
      return unary();
    case TokenKind::Identifier:
      return 0; // no macro: as in C
    case TokenKind::Number: {
      uint64_t value = 0;
      StringRef digits = token.text;
      if (!digits.getAsInteger(0, value))
        return static_cast<int64_t>(value);
      double real = 0; // versions are sometimes written 3.5
      if (digits.getAsDouble(real) || real > 9e15) {
        fail(token.loc, "'" + token.text + "' is no integer");
        return 0;
      }
      return static_cast<int64_t>(real);
    }
    case TokenKind::LeftParen: {
      int64_t value = conditional();
      if (kind() != TokenKind::RightParen)
        fail(token.loc, "'(' without ')' in a condition");
      else
        ++position;
      return value;
    }
    default:
      fail(token.loc, "unexpected '" + token.text + "' in a condition");
      return 0;
    }
  }

  static constexpr unsigned MaxDepth = 200;
  ArrayRef<Token> tokens;
  SMLoc loc;
  DiagnosticEngine &diags;
  size_t position = 0;
  unsigned depth = 0;
  bool failed = false;
};

} // namespace

bool conditionHolds(ArrayRef<Token> tokens, SMLoc loc, DiagnosticEngine &diags) {
  return ConditionParser(tokens, loc, diags).parse();
}

} // namespace anysl::rsl
