//===-- anysl/format.h - the directives of printf() and format() ------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The compiler, which checks formats, and libanysl, which follows them, find directives with the
// one function here. A directive is
//
//     % [flags - + space # 0]... [width] [.precision] letter
//
// where the letter says what the value is: f e g a float, d i a float shown as an integer, p a
// point, vector or normal, c a color, m a matrix, s a string. %% is a percent sign. Anything else
// that begins with % is text.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FORMAT_H
#define ANYSL_FORMAT_H

#include <cstddef>
#include <string_view>

namespace anysl {

inline constexpr std::string_view formatLetters = "fegdipcms";

/// A part of a format that begins with %.
struct FormatDirective {
  size_t begin; ///< where its % stands
  size_t end;   ///< behind it
  char letter;  ///< of formatLetters; % for %%; 0: none of these, so it is text
};

/// The first % of a format from a place on, as a directive or not; begin is npos if there is none.
inline FormatDirective nextPercent(std::string_view format, size_t from) {
  size_t begin = format.find('%', from);
  if (begin == std::string_view::npos)
    return {begin, begin, 0};
  auto skip = [&](size_t at, std::string_view characters) {
    size_t end = format.find_first_not_of(characters, at);
    return end == std::string_view::npos ? format.size() : end;
  };
  constexpr std::string_view digits = "0123456789";
  size_t at = skip(begin + 1, "-+ #0");
  at = skip(at, digits);
  if (at < format.size() && format[at] == '.')
    at = skip(at + 1, digits);
  if (at == format.size())
    return {begin, at, 0};
  char letter = format[at];
  bool known = formatLetters.find(letter) != std::string_view::npos;
  bool isPercent = letter == '%' && at == begin + 1;
  return {begin, at + 1, known || isPercent ? letter : char(0)};
}

} // namespace anysl

#endif // ANYSL_FORMAT_H
