//===-- lib/Host/Text.cpp - text made while shading -------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Shaders hold texts as pointers that nobody frees. What format() makes is therefore kept for good,
// once for all shaders: commonly it is a handful of file names. What printf() makes is not kept: it
// grows, piece by piece, in a line of the printing point, and goes when it is printed.
//
// Nothing here lets an exception out: shaders have no unwind tables.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/Text.h"

#include <algorithm>
#include <anysl/anysl.h>
#include <anysl/format.h>
#include <cstdio>
#include <locale.h>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <regex.h>
#include <unordered_set>
#include <vector>

namespace anysl::host {
namespace {

//===-- Formats -------------------------------------------------------------------------------===//

/// Numbers look the same whatever locale the renderer's process has.
class CLocale {
public:
  CLocale() : before(uselocale(neutral())) {}
  CLocale(const CLocale &) = delete;
  CLocale &operator=(const CLocale &) = delete;
  ~CLocale() { uselocale(before); }

private:
  static locale_t neutral() {
    static const locale_t locale = newlocale(LC_ALL_MASK, "C", nullptr);
    return locale;
  }
  locale_t before;
};

/// A directive's flags, width and precision: what stands between % and the letter. A width that is
/// longer than any text should be is no reason to make one.
std::string styleOf(std::string_view directive) {
  constexpr size_t maxDigits = 3;
  std::string style;
  size_t digits = 0;
  bool inFlags = true;
  for (char c : directive.substr(1, directive.size() - 2)) {
    bool isDigit = c >= '0' && c <= '9';
    inFlags &= !isDigit || c == '0';
    digits = isDigit && !inFlags ? digits + 1 : 0;
    if (digits <= maxDigits)
      style += c;
  }
  return style;
}

template <typename T>
void print(std::string &text, const std::string &format, T value) {
  char buffer[64];
  int length = std::snprintf(buffer, sizeof buffer, format.c_str(), value);
  if (length < 0)
    return;
  if (size_t(length) < sizeof buffer) {
    text.append(buffer, size_t(length));
    return;
  }
  size_t begin = text.size();
  text.resize(begin + size_t(length) + 1);
  std::snprintf(&text[begin], size_t(length) + 1, format.c_str(), value);
  text.pop_back();
}

void appendNumber(std::string &text, const std::string &style, char letter, double value) {
  constexpr double limit = 9.2e18; // of long long
  if (letter == 'd' || letter == 'i')
    return print(text, "%" + style + "lld",
                 value == value ? static_cast<long long>(std::clamp(value, -limit, limit)) : 0);
  bool isNumberForm = letter == 'e' || letter == 'g';
  print(text, "%" + style + (isNumberForm ? letter : 'f'), value);
}

void appendValue(std::string &text, std::string_view directive, uint32_t type,
                 const AnyslCell *value) {
  CLocale locale;
  std::string style = styleOf(directive);
  if (type == ANYSL_STRING)
    return print(text, "%" + style + "s", value->string ? value->string : "");
  for (uint32_t i = 0; i < anysl_type_components(type); ++i) {
    if (i)
      text += ' ';
    appendNumber(text, style, directive.back(), value[i].number);
  }
}

//===-- The line that a point prints ----------------------------------------------------------===//

/// Widened code makes the lines of its points at the same time, so there are as many as it has
/// lanes.
struct Line {
  const AnyslShadeArgs *args;
  uint32_t point;
  std::string text;
};
thread_local std::vector<Line> lines;

std::vector<Line>::iterator lineOf(const AnyslShadeArgs *args, uint32_t point) {
  auto found = std::find_if(lines.begin(), lines.end(), [&](const Line &line) {
    return line.args == args && line.point == point;
  });
  return found == lines.end() ? lines.insert(found, {args, point, {}}) : found;
}

//===-- Services ------------------------------------------------------------------------------===//

const char *append(void *, const char *text, const char *format, uint32_t index, uint32_t type,
                   const AnyslCell *value) noexcept {
  try {
    std::string made = text;
    appendFormatted(made, format, index, type, value);
    return intern(made);
  } catch (const std::bad_alloc &) {
    return text;
  }
}

void printText(void *, const AnyslShadeArgs *, uint32_t, const char *text) noexcept {
  std::fputs(text, stdout);
}

void printValue(void *renderer, const AnyslShadeArgs *args, uint32_t point, const char *format,
                uint32_t index, uint32_t type, const AnyslCell *value) noexcept {
  try {
    auto line = lineOf(args, point);
    appendFormatted(line->text, format, index, type, value);
    if (type)
      return;
    std::string text = std::move(line->text);
    lines.erase(line);
    auto print = args->services->print;
    (print ? print : printText)(renderer, args, point, text.c_str());
  } catch (const std::bad_alloc &) {
  }
}

void warnOnce(void *, const AnyslShadeArgs *, const char *text) noexcept {
  static std::mutex mutex;
  static auto &said = *new std::unordered_set<std::string>;
  try {
    std::lock_guard<std::mutex> lock(mutex);
    if (said.emplace(text).second)
      std::fprintf(stderr, "%s\n", text);
  } catch (const std::bad_alloc &) {
  }
}

int match(void *, const char *pattern, const char *text) noexcept {
  try {
    return matches(pattern, text);
  } catch (const std::bad_alloc &) {
    return 0;
  }
}

} // namespace

void appendFormatted(std::string &text, std::string_view format, uint32_t index, uint32_t type,
                     const AnyslCell *value) {
  uint32_t seen = 0;
  for (size_t at = 0;;) {
    FormatDirective next = nextPercent(format, at);
    bool isDirective = next.letter && next.letter != '%';
    if (seen >= index)
      text += format.substr(at, next.begin - at);
    if (next.begin == std::string_view::npos)
      return;
    std::string_view directive = format.substr(next.begin, next.end - next.begin);
    if (seen == index && isDirective && type)
      return appendValue(text, directive, type, value);
    if (seen >= index)
      text += next.letter == '%' ? "%" : directive;
    seen += isDirective;
    at = next.end;
  }
}

const char *intern(std::string_view text) {
  static std::mutex mutex;
  // Never destroyed: a shader may still run when the process ends.
  static auto &texts = *new std::unordered_set<std::string>;
  std::lock_guard<std::mutex> lock(mutex);
  return texts.emplace(text).first->c_str();
}

bool matches(const char *pattern, const char *text) {
  // Compiled ones are kept for each thread: a shader has a few, and asks again for every point.
  struct Free {
    void operator()(regex_t *regex) const {
      regfree(regex);
      delete regex;
    }
  };
  constexpr size_t maxKept = 64;
  thread_local std::map<std::string, std::unique_ptr<regex_t, Free>, std::less<>> kept;
  auto found = kept.find(std::string_view(pattern));
  if (found == kept.end()) {
    if (kept.size() >= maxKept)
      kept.clear();
    // In basic expressions the C libraries of Linux know \| \+ \? besides what POSIX says.
    auto raw = std::make_unique<regex_t>();
    std::unique_ptr<regex_t, Free> compiled;
    if (regcomp(raw.get(), pattern, REG_NOSUB) == 0)
      compiled.reset(raw.release());
    found = kept.emplace(pattern, std::move(compiled)).first;
  }
  return found->second && regexec(found->second.get(), text, 0, nullptr, 0) == 0;
}

void completeTextServices(AnyslServices &services) {
  if (!services.append)
    services.append = append;
  if (!services.print_value)
    services.print_value = printValue;
  if (!services.match)
    services.match = match;
  if (!services.print)
    services.print = printText;
  if (!services.warn)
    services.warn = warnOnce;
}

} // namespace anysl::host
