//===-- lib/Demand/Json.h - JSON text whose values know their places ----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_DEMAND_JSON_H
#define ANYSL_LIB_DEMAND_JSON_H

#include "lib/Rib/Diagnostics.h"

#include <string_view>
#include <utility>

namespace anysl::demand {

/// A value of a JSON text, with the place where it begins, so that what is wrong with it can be
/// shown.
struct Json {
  enum Kind { Null, Bool, Number, Text, Array, Object } kind = Null;
  bool truth = false;
  double number = 0;
  std::string text;
  std::vector<Json> items;
  struct Member;
  std::vector<Member> members; ///< in the order of the text; no key comes twice
  render::Location where;
};

struct Json::Member {
  std::string key;
  render::Location where; ///< of the key
  Json value;
};

/// The value of an object's member; null where there is no such member.
const Json &member(const Json &object, std::string_view key);
/// Whether an array has a text among its items.
bool hasText(const Json &array, std::string_view text);

/// "a number", "text" and so on.
const char *describe(Json::Kind kind);

/// Reads a whole text. Throws UserError with the place of what is wrong.
Json parseJson(const std::shared_ptr<const render::SourceFile> &file);

/// The text in quotation marks, with escapes.
std::string quoted(std::string_view text);
/// The shortest number that reads back as the same.
std::string shortest(double number);

} // namespace anysl::demand

#endif
