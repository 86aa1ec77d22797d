//===-- lib/Rib/RibConditions.cpp - requests that depend on options and attributes ------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/RibState.h"

#include <charconv>
#include <functional>

using namespace anysl::render;

namespace {

/// A number or a text.
struct Value {
  double number = 0;
  std::string text;
  bool isText = false;

  bool holds() const { return isText ? !text.empty() : number != 0; }
  static Value of(double number) { return {number, "", false}; }
};

/// Evaluates "$user:pass == 'beauty' && $user:size > 2" by recursive descent.
class Expression {
public:
  using Lookup = std::function<const Parameter *(std::string_view)>;
  Expression(std::string_view text, Lookup lookup, const Location &where)
      : text(text), lookup(std::move(lookup)), where(where) {}

  bool evaluate() {
    Value result = either();
    skipSpace();
    if (!text.empty())
      fail("'" + std::string(text) + "' is not understood");
    return result.holds();
  }

private:
  [[noreturn]] void fail(const std::string &reason) {
    throw UserError(where, "condition: " + reason);
  }
  void skipSpace() { text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size())); }
  bool take(std::string_view word) {
    skipSpace();
    if (!text.starts_with(word))
      return false;
    text.remove_prefix(word.size());
    return true;
  }
  Value either() {
    Value left = both();
    while (take("||")) {
      Value right = both();
      left = Value::of(left.holds() || right.holds());
    }
    return left;
  }
  Value both() {
    Value left = comparison();
    while (take("&&")) {
      Value right = comparison();
      left = Value::of(left.holds() && right.holds());
    }
    return left;
  }
  Value comparison() {
    Value left = sum();
    for (const char *sign : {"==", "!=", "<=", ">=", "<", ">"}) {
      if (!take(sign))
        continue;
      Value right = sum();
      // Only two numbers compare as such.
      int order = left.isText || right.isText
                      ? left.text.compare(right.text)
                      : (left.number > right.number) - (left.number < right.number);
      if (left.isText != right.isText)
        order = 1;
      std::string_view is = sign;
      return Value::of(is == "=="   ? order == 0
                       : is == "!=" ? order != 0
                       : is == "<=" ? order <= 0
                       : is == ">=" ? order >= 0
                       : is == "<"  ? order < 0
                                    : order > 0);
    }
    return left;
  }
  Value sum() {
    Value left = product();
    for (;;) {
      if (take("+")) {
        Value right = product();
        left.number += right.number;
        left.text += right.text;
      } else if (take("-")) {
        left.number -= product().number;
      } else {
        return left;
      }
    }
  }
  Value product() {
    Value left = unary();
    for (;;) {
      if (take("*"))
        left.number *= unary().number;
      else if (take("/"))
        left.number /= unary().number;
      else
        return left;
    }
  }
  Value unary() {
    constexpr unsigned deepest = 100;
    if (++depth > deepest)
      fail("it is nested too deeply");
    Value result;
    skipSpace();
    if (take("!"))
      result = Value::of(!unary().holds());
    else if (take("-"))
      result = Value::of(-unary().number);
    else
      result = primary();
    --depth;
    return result;
  }
  Value primary() {
    if (take("(")) {
      Value inner = either();
      if (!take(")"))
        fail("a ')' is missing");
      return inner;
    }
    if (take("defined")) {
      if (!take("("))
        fail("defined needs a '('");
      take("$");
      bool known = lookup(name()) != nullptr;
      if (!take(")"))
        fail("a ')' is missing");
      return Value::of(known);
    }
    for (const char *quote : {"'", "\""})
      if (take(quote)) {
        size_t end = text.find(*quote);
        if (end == text.npos)
          fail("a text without its closing quote");
        Value result{0, std::string(text.substr(0, end)), true};
        text.remove_prefix(end + 1);
        return result;
      }
    if (take("$"))
      return variable();
    double number;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc())
      fail(text.empty() ? "something is missing at its end"
                        : "'" + std::string(text) + "' is no value");
    text.remove_prefix(size_t(end - text.data()));
    return Value::of(number);
  }
  Value variable() {
    const Parameter *parameter = lookup(name());
    if (!parameter)
      return {};
    if (!parameter->strings.empty())
      return {0, parameter->strings[0], true};
    return Value::of(parameter->numbers.empty() ? 0 : parameter->numbers[0]);
  }
  std::string name() {
    bool braces = take("{");
    size_t end = 0;
    auto belongs = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             c == '_' || c == ':' || c == '.';
    };
    while (end < text.size() && belongs(text[end]))
      ++end;
    std::string result(text.substr(0, end));
    text.remove_prefix(end);
    if (result.empty() || (braces && !take("}")))
      fail("a variable's name is missing");
    return result;
  }

  std::string_view text;
  Lookup lookup;
  const Location &where;
  unsigned depth = 0;
};

} // namespace

const Parameter *RibState::findSetting(std::string_view name) const {
  for (std::string_view prefix : {"Attribute:", "Option:"})
    if (name.starts_with(prefix))
      name.remove_prefix(prefix.size());
  if (const auto &attributes = state.appearance.attributes)
    if (auto found = attributes->find(name); found != attributes->end())
      return &found->second;
  auto found = scene.options.find(name);
  return found == scene.options.end() ? nullptr : &found->second;
}

bool RibState::evaluate(const std::string &expression, const Location &where) const {
  Parameter number;
  number.numbers = {frame};
  auto lookup = [&](std::string_view name) -> const Parameter * {
    if (name == "Frame")
      return &number;
    bool hasGroup = name.find(':') != name.npos;
    return findSetting(hasGroup ? std::string(name) : "user:" + std::string(name));
  };
  return Expression(expression, lookup, where).evaluate();
}

void RibState::ifBegin(RibArguments &arguments) {
  std::string expression = arguments.string("a condition");
  arguments.parameters();
  // Inside of what is passed over nothing is looked at.
  bool outer = !isPassedOver();
  bool holds = outer && evaluate(expression, arguments.where());
  conditions.push_back({arguments.where(), !outer || holds, holds});
}

void RibState::elseIf(RibArguments &arguments) {
  std::string expression = arguments.string("a condition");
  arguments.parameters();
  if (conditions.empty())
    throw UserError(arguments.where(), "ElseIf without IfBegin");
  Condition &condition = conditions.back();
  condition.active = !condition.taken && evaluate(expression, arguments.where());
  condition.taken |= condition.active;
}

void RibState::elseBegin(RibArguments &arguments) {
  if (conditions.empty())
    throw UserError(arguments.where(), "Else without IfBegin");
  conditions.back().active = !conditions.back().taken;
  conditions.back().taken = true;
}

void RibState::ifEnd(RibArguments &arguments) {
  if (conditions.empty())
    throw UserError(arguments.where(), "IfEnd without IfBegin");
  conditions.pop_back();
}
