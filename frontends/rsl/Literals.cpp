//===-- frontends/rsl/Literals.cpp - numbers and strings as values ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Literals.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace anysl::rsl {

std::string unquote(StringRef quoted) {
  StringRef text = quoted.drop_front();
  if (text.ends_with("\""))
    text = text.drop_back();
  std::string value;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      value += text[i];
      continue;
    }
    char c = text[++i];
    if (c >= '0' && c <= '7') {
      unsigned code = 0;
      for (unsigned digits = 0; digits < 3 && i < text.size() && text[i] >= '0' && text[i] <= '7';
           ++digits)
        code = code * 8 + static_cast<unsigned>(text[i++] - '0');
      --i;
      value += static_cast<char>(code);
      continue;
    }
    // Where C has no escape, the backslash stays for regular expressions: "\(a\|b\)".
    static constexpr StringLiteral names = "ntrbfva", values = "\n\t\r\b\f\v\a";
    static constexpr StringLiteral special = "|+?(){}[].*^$";
    if (special.contains(c))
      value += '\\';
    size_t known = names.find(c);
    value += known == StringRef::npos ? c : values[known];
  }
  value.resize(std::min(value.size(), value.find('\0')));
  return value;
}

bool parseNumber(StringRef text, double &value) {
  if (text.starts_with_insensitive("0x")) {
    uint64_t integer = 0;
    if (text.drop_front(2).getAsInteger(16, integer))
      return false;
    value = static_cast<double>(integer);
    return true;
  }
  if (text.ends_with_insensitive("f"))
    text = text.drop_back();
  // getAsDouble takes overflow for an error only on request; an infinite constant is not what is
  // meant.
  return !text.getAsDouble(value, /*AllowInexact=*/true);
}

} // namespace anysl::rsl
