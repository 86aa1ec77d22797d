//===-- tools/anysl-shade/Options.h - the command line --------------------------------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_ANYSL_SHADE_OPTIONS_H
#define ANYSL_TOOLS_ANYSL_SHADE_OPTIONS_H

#include "tools/anysl-shade/Environment.h"
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace anysl::shade {

/// What the user did wrong: one message, exit status 1.
struct UserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// --set NAME=v[,v…]: one value for all points.
struct Constant {
  std::string name;
  std::vector<double> value;
};

/// --ramp NAME=from:to:axis: from at one side of the grid, to at the other.
struct Ramp {
  std::string name;
  std::vector<double> from, to;
  bool alongHeight; ///< axis y, v or t
};

/// --param NAME=VALUE, whose meaning depends on the parameter's type.
struct ParamText {
  std::string name, value;
};

/// --coshader HANDLE=FILE.so[:NAME=VALUE]…
struct CoshaderText {
  std::string handle, library;
  std::vector<ParamText> params;
};

struct Options {
  std::string library;
  std::optional<std::string> shader; ///< the library's first if not given
  unsigned gridWidth = 0, gridHeight = 0;
  unsigned width = 0; ///< points at once; 0: the widest
  std::vector<Constant> constants;
  std::vector<Ramp> ramps;
  std::vector<ParamText> params;
  std::vector<std::string> print;
  std::vector<std::string> lights; ///< as --light has them
  std::string image;               ///< empty: none
  bool json = false;
  bool bench = false;
  Environment environment;
  std::vector<CoshaderText> coshaders;
};

/// Reads the arguments; nothing is returned where only help or the version was asked for and
/// printed. Throws UserError.
std::optional<Options> parseOptions(int argc, char **argv);

std::vector<std::string> split(const std::string &text, char separator);
/// NAME=VALUE, both sides of it. Throws UserError that names \p option.
std::pair<std::string, std::string> parseAssignment(const std::string &text,
                                                    const std::string &option);
/// "0.5,1,2" as numbers. Throws UserError that names \p option.
std::vector<double> parseNumbers(const std::string &text, const std::string &option);
/// 16 of them, a matrix that has an inverse.
Matrix parseMatrix(const std::string &text, const std::string &option);

} // namespace anysl::shade

#endif
