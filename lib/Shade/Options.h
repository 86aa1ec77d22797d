//===-- lib/Shade/Options.h - what to shade, and in which world
//--------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SHADE_OPTIONS_H
#define ANYSL_LIB_SHADE_OPTIONS_H

#include "lib/Shade/Environment.h"
#include "lib/Shade/Recording.h"
#include <optional>
#include <span>
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

struct GridOptions {
  std::string library;
  std::optional<std::string> shader; ///< the library's first if not given
  unsigned gridWidth = 0, gridHeight = 0;
  unsigned width = 0; ///< points at once; 0: the widest
  std::vector<Constant> constants;
  std::vector<Ramp> ramps;
  std::vector<ParamText> params;
  std::vector<std::string> print; ///< the results; empty: the globals that the shader writes
  /// Inputs are rounded to float whatever the library's real is, so that all reals see the same.
  bool floatInputs = false;
  bool needsColor = false;         ///< Ci is among the results, whatever else is
  std::vector<std::string> lights; ///< as --light has them
  Environment environment;
  std::vector<CoshaderText> coshaders;
  /// Points that stand for the grid, with their parameters, lights and spaces: the first part that
  /// is of the shader. Empty: the grid.
  std::vector<std::shared_ptr<const RecordedShader>> recorded;
};

/// An option that says what to shade, or in which world: of every program that shades a grid.
struct GridOption {
  const char *name; ///< with its dashes
  /// Throws UserError.
  void (*read)(GridOptions &options, const std::string &value);
};
std::span<const GridOption> gridOptions();
/// What --help says of them.
extern const char *const gridHelp, *const pointsHelp, *const worldHelp;

/// A positive whole number. Throws UserError that names \p option.
unsigned parseCount(const std::string &text, const std::string &option);
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
