//===-- lib/Rib/Diagnostics.h - positions and messages ----------------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_RIB_DIAGNOSTICS_H
#define ANYSL_LIB_RIB_DIAGNOSTICS_H

#include <cstddef>
#include <cstdio>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace anysl::render {

/// A text that positions point into.
struct SourceFile {
  std::string name;
  std::string text;
};

/// A place in a source file. It keeps the file alive, since messages about a scene may come long
/// after it was read.
struct Location {
  std::shared_ptr<const SourceFile> file;
  size_t offset = 0;

  /// Line and column, counted from 1; a tabulator is one column.
  void lineAndColumn(size_t &line, size_t &column) const;
};

/// "file:line:column: kind: message", the source line and a caret below it. Without a file only
/// "anysl-render: kind: message".
std::string formatMessage(const Location &where, std::string_view kind, std::string_view message);

/// Something the user has to put right: the program reports it and exits with status 1.
class UserError : public std::runtime_error {
public:
  explicit UserError(const std::string &message) : UserError(Location(), message) {}
  UserError(const Location &where, const std::string &message);

  /// The same error with one more place to look at below it.
  UserError withNote(const Location &place, const std::string &note) const;
  const char *what() const noexcept override { return text.c_str(); }

  Location where;
  std::string message; ///< what() without the place

private:
  std::string text;
};

/// A shape that cannot be made. It is left out with a warning, and the rest goes on.
class ShapeError : public UserError {
public:
  using UserError::UserError;
};

/// Prints warnings to standard error, each text at most once.
class Warnings {
public:
  /// Null prints nothing.
  explicit Warnings(std::FILE *stream = stderr) : stream(stream) {}

  void warn(const Location &where, const std::string &message);
  /// As warn(), but only the first message with this key is printed.
  void warnOnce(const std::string &key, const Location &where, const std::string &message);
  /// Something without which the picture is not what was asked for: throws UserError, or warns if
  /// the user wants to see the rest.
  void fail(const Location &where, const std::string &message);
  size_t count() const { return shown.size(); }
  /// Whether a warning with this in it has been given.
  bool contains(std::string_view text) const;

  bool keepGoing = false; ///< fail() warns

private:
  std::FILE *stream;
  std::set<std::string> shown;
  std::vector<std::string> texts;
};

} // namespace anysl::render

#endif
