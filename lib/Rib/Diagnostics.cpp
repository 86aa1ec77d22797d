//===-- lib/Rib/Diagnostics.cpp - positions and messages --------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Rib/Diagnostics.h"

#include <algorithm>
#include <cstdio>

using namespace anysl::render;

void Location::lineAndColumn(size_t &line, size_t &column) const {
  std::string_view before = std::string_view(file->text).substr(0, offset);
  line = 1 + size_t(std::count(before.begin(), before.end(), '\n'));
  column = before.size() - (before.rfind('\n') + 1) + 1; // npos + 1 is 0
}

std::string anysl::render::formatMessage(const Location &where, std::string_view kind,
                                         std::string_view message) {
  std::string text;
  if (!where.file)
    return text.append("anysl-render: ").append(kind).append(": ").append(message).append("\n");
  size_t line, column;
  where.lineAndColumn(line, column);
  text.append(where.file->name).append(":").append(std::to_string(line)).append(":");
  text.append(std::to_string(column)).append(": ").append(kind).append(": ").append(message);
  text.append("\n");

  // A mesh may stand on one line of megabytes: show what lies around the position.
  const std::string &source = where.file->text;
  size_t offset = std::min(where.offset, source.size());
  size_t begin = offset - (column - 1);
  size_t end = std::min(source.find('\n', offset), source.size());
  if (column > 100)
    begin = offset - 60;
  end = std::min(end, begin + 120);
  std::string caret;
  for (size_t i = begin; i < offset; ++i)
    caret += source[i] == '\t' ? '\t' : ' ';
  std::string shown = source.substr(begin, end - begin);
  while (!shown.empty() && shown.back() == '\r')
    shown.pop_back();
  for (char &c : shown)
    if (static_cast<unsigned char>(c) < ' ' && c != '\t')
      c = '?';
  return text.append("  ").append(shown).append("\n  ").append(caret).append("^\n");
}

UserError::UserError(const Location &where, const std::string &message)
    : std::runtime_error(message), where(where), message(message),
      text(formatMessage(where, "error", message)) {}

UserError UserError::withNote(const Location &place, const std::string &note) const {
  UserError result = *this;
  result.text += formatMessage(place, "note", note);
  return result;
}

void Warnings::warn(const Location &where, const std::string &message) {
  warnOnce(formatMessage(where, "warning", message), where, message);
}

void Warnings::warnOnce(const std::string &key, const Location &where, const std::string &message) {
  if (!shown.insert(key).second)
    return;
  texts.push_back(formatMessage(where, "warning", message));
  if (stream)
    std::fputs(texts.back().c_str(), stream);
}

void Warnings::fail(const Location &where, const std::string &message) {
  if (!keepGoing)
    throw UserError(where, message);
  warn(where, message);
}

bool Warnings::contains(std::string_view text) const {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string &each) { return each.find(text) != each.npos; });
}
