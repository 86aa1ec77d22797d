//===-- tools/anysl-info/Description.h - what is known of a file of shaders -----------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// One form for both kinds of file: what a kind does not know is absent.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_ANYSL_INFO_DESCRIPTION_H
#define ANYSL_TOOLS_ANYSL_INFO_DESCRIPTION_H

#include "lib/Support/Diagnostics.h"
#include "llvm/Support/raw_ostream.h"
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace anysl::info {

/// A default: all numbers, or all texts, of a parameter.
using Default = std::variant<std::vector<double>, std::vector<std::string>>;

struct Param {
  std::string name;
  std::string type;
  unsigned components = 1; ///< of one element
  unsigned arrayLength = 0;
  bool varying = false, output = false;
  bool fixed = false; ///< given to anysl-link, no longer the host's to choose
  std::optional<Default> defaultValue;
};

struct Shader {
  std::string name;
  std::string kind;
  std::vector<unsigned> widths; ///< compiled libraries only
  std::vector<std::string> globalsRead, globalsWritten;
  std::vector<std::string> services, effects;
  std::vector<Param> params;
};

/// What linking adds.
struct Target {
  std::string runtime, real, math, layout, cpu;
  std::vector<std::string> cpuFeatures;
  std::string refusal; ///< why this machine does not run it; empty if it does
};

/// What shaders ask of each other.
struct Asking {
  std::optional<std::vector<std::string>> names; ///< of parameters; nothing: any
  bool tracesForOthers = false;
};

struct Description {
  std::string path;
  std::string producer;
  std::optional<Target> target; ///< compiled libraries only
  std::optional<Asking> asking; ///< threaded code only
  std::vector<Shader> shaders;
};

/// Opens a compiled library. Defaults are those that the library computes, where this processor
/// can.
std::optional<Description> describeLibrary(DiagnosticEngine &diags, const std::string &path);
/// Reads an STC file.
std::optional<Description> describeStc(DiagnosticEngine &diags, const std::string &path);

void printText(const Description &description, llvm::raw_ostream &out);
void printJson(const Description &description, llvm::raw_ostream &out);

} // namespace anysl::info

#endif
