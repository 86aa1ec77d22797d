//===-- lib/Demand/Json.cpp - JSON text whose values know their places ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Demand/Json.h"

#include <algorithm>
#include <charconv>
#include <cmath>

using namespace anysl::render;

namespace anysl::demand {
namespace {

/// How deep values may lie in each other.
constexpr unsigned deepest = 64;

class Parser {
public:
  explicit Parser(const std::shared_ptr<const SourceFile> &file) : file(file), text(file->text) {}

  Json all() {
    Json result = value(0);
    skip();
    if (at < text.size())
      fail("there is something behind the end");
    return result;
  }

private:
  [[noreturn]] void fail(const std::string &message) const { throw UserError(here(), message); }
  Location here() const { return {file, at}; }

  void skip() {
    while (at < text.size() && std::string_view(" \t\r\n").find(text[at]) != std::string_view::npos)
      ++at;
  }
  bool take(char c) {
    skip();
    if (at >= text.size() || text[at] != c)
      return false;
    ++at;
    return true;
  }
  bool takeWord(std::string_view word) {
    if (text.substr(at, word.size()) != word)
      return false;
    at += word.size();
    return true;
  }

  Json value(unsigned depth) {
    skip();
    if (depth > deepest)
      fail("values lie too deep in each other");
    Json result;
    result.where = here();
    if (at >= text.size())
      fail("expected a value, and the text ends");
    if (text[at] == '{') {
      object(result, depth);
    } else if (text[at] == '[') {
      array(result, depth);
    } else if (text[at] == '"') {
      result.kind = Json::Text;
      result.text = string();
    } else if (takeWord("true") || takeWord("false")) {
      result.kind = Json::Bool;
      result.truth = text[at - 2] == 'u';
    } else if (takeWord("null")) {
      result.kind = Json::Null;
    } else {
      result.kind = Json::Number;
      result.number = number();
    }
    return result;
  }

  void object(Json &result, unsigned depth) {
    result.kind = Json::Object;
    ++at;
    if (take('}'))
      return;
    do {
      skip();
      Json::Member member;
      member.where = here();
      if (at >= text.size() || text[at] != '"')
        fail("expected a name in quotation marks");
      member.key = string();
      for (const Json::Member &other : result.members)
        if (other.key == member.key)
          throw UserError(member.where, "\"" + member.key + "\" is given twice");
      if (!take(':'))
        fail("expected ':' behind a name");
      member.value = value(depth + 1);
      result.members.push_back(std::move(member));
    } while (take(','));
    if (!take('}'))
      fail("expected ',' or '}'");
  }

  void array(Json &result, unsigned depth) {
    result.kind = Json::Array;
    ++at;
    if (take(']'))
      return;
    do
      result.items.push_back(value(depth + 1));
    while (take(','));
    if (!take(']'))
      fail("expected ',' or ']'");
  }

  double number() {
    double result = 0;
    const char *begin = text.data() + at, *end = text.data() + text.size();
    // What from_chars reads besides is no JSON.
    bool begins = *begin == '-' || (*begin >= '0' && *begin <= '9');
    auto [rest, error] = std::from_chars(begin, end, result);
    if (!begins || error != std::errc() || !std::isfinite(result))
      fail("expected a value");
    at += size_t(rest - begin);
    return result;
  }

  unsigned hex() {
    unsigned code = 0;
    const char *begin = text.data() + at;
    if (text.size() - at < 4 || std::from_chars(begin, begin + 4, code, 16).ptr != begin + 4)
      fail("expected four hexadecimal digits");
    at += 4;
    return code;
  }

  /// One character behind a backslash.
  void escape(std::string &result) {
    static constexpr std::string_view names = "\"\\/bfnrt", values = "\"\\/\b\f\n\r\t";
    char c = at < text.size() ? text[at] : '\0';
    if (size_t i = names.find(c); i != names.npos) {
      ++at;
      result += values[i];
      return;
    }
    if (c != 'u')
      fail("there is no such escape");
    ++at;
    unsigned code = hex();
    if (code >= 0xd800 && code < 0xdc00 && takeWord("\\u"))
      code = 0x10000 + ((code - 0xd800) << 10) + (hex() - 0xdc00);
    if (code < 0x80) {
      result += char(code);
    } else if (code < 0x800) {
      result += char(0xc0 | code >> 6);
      result += char(0x80 | (code & 63));
    } else {
      if (code < 0x10000) {
        result += char(0xe0 | code >> 12);
      } else {
        result += char(0xf0 | (code >> 18 & 7));
        result += char(0x80 | (code >> 12 & 63));
      }
      result += char(0x80 | (code >> 6 & 63));
      result += char(0x80 | (code & 63));
    }
  }

  std::string string() {
    std::string result;
    ++at;
    for (;;) {
      if (at >= text.size() || static_cast<unsigned char>(text[at]) < ' ')
        fail("the text in quotation marks does not end");
      char c = text[at++];
      if (c == '"')
        return result;
      if (c == '\\')
        escape(result);
      else
        result += c;
    }
  }

  const std::shared_ptr<const SourceFile> &file;
  std::string_view text;
  size_t at = 0;
};

} // namespace

const Json &member(const Json &object, std::string_view key) {
  static const Json none;
  auto found = std::find_if(object.members.begin(), object.members.end(),
                            [key](const Json::Member &each) { return each.key == key; });
  return found == object.members.end() ? none : found->value;
}

bool hasText(const Json &array, std::string_view text) {
  return std::any_of(array.items.begin(), array.items.end(),
                     [text](const Json &item) { return item.text == text; });
}

const char *describe(Json::Kind kind) {
  static const char *const names[] = {"null", "true or false", "a number",
                                      "text", "a list",        "an object"};
  return names[kind];
}

Json parseJson(const std::shared_ptr<const SourceFile> &file) { return Parser(file).all(); }

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (char c : text)
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < ' ') {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", unsigned(c));
      result += code;
    } else {
      result += c;
    }
  return result + "\"";
}

std::string shortest(double number) {
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
}

} // namespace anysl::demand
