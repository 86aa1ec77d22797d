//===-- lib/Rib/RibArguments.h - what stands behind a request ---------------------*- C++ -*---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_RIB_RIBARGUMENTS_H
#define ANYSL_LIB_RIB_RIBARGUMENTS_H

#include "lib/Rib/SceneDescription.h"

namespace anysl::render {

/// A number, a string, or an array of one of them.
struct RibArgument {
  Location where;
  bool isArray = false;
  std::vector<double> numbers;
  std::vector<std::string> strings;
};

struct RibRequest {
  std::string name;
  Location where;
  std::vector<RibArgument> arguments;
};

/// Hands out a request's arguments in order, or throws UserError saying what is missing.
class RibArguments {
public:
  RibArguments(const RibRequest &request,
               const std::map<std::string, Declaration, std::less<>> &declarations)
      : request(request), declarations(declarations) {}

  const Location &where() const { return request.where; }
  bool empty() const { return next == request.arguments.size(); }

  /// Whether a string comes next; whether an array does.
  bool nextIsText() const;
  bool nextIsArray() const;

  double number(const char *what);
  /// A whole number of at least 0.
  uint32_t count(const char *what);
  std::string string(const char *what);
  /// `count` numbers, one by one or as an array.
  std::vector<double> numbers(size_t count, const char *what);
  Vec3d triple(const char *what);
  Matrix4 matrix();
  /// All that is left as numbers, one by one or as an array.
  std::vector<double> rest(const char *what);
  /// One argument of any kind.
  const RibArgument &any(const char *what) { return take(what); }
  /// An array of any length.
  std::vector<double> array(const char *what);
  /// An array of indices or counts, none of them negative.
  std::vector<uint32_t> indices(const char *what);
  /// An array of strings of any length.
  std::vector<std::string> strings(const char *what);
  /// A light's or object's name: a number or a string.
  std::string handle(const char *what);
  /// All that is left, as pairs of a name and its values.
  ParameterList parameters();

private:
  const RibArgument &take(const char *what);

  const RibRequest &request;
  const std::map<std::string, Declaration, std::less<>> &declarations;
  size_t next = 0;
};

/// Reads "uniform color[2] name"; the name is left out where `name` is null.
/// Throws UserError at `where` if the text is no declaration.
Declaration parseDeclaration(std::string_view text, std::string *name, const Location &where);

} // namespace anysl::render

#endif
