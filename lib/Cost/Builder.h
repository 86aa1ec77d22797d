//===-- lib/Cost/Builder.h - shaders linked in many ways --------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_COST_BUILDER_H
#define ANYSL_LIB_COST_BUILDER_H

#include "lib/Link/Linker.h"
#include "lib/Support/Diagnostics.h"
#include "llvm/Support/JSON.h"
#include "llvm/Target/TargetMachine.h"
#include <map>

namespace anysl::cost {

/// An error has been reported.
struct Failed {};

/// A call in a shader that computes an elementary function.
struct Site {
  FilePosition position;
  std::string function;

  /// "marble.sl:12:8 pow"
  std::string name() const;
};

/// A math tier for everything, or for each function as anysl-link --math takes it, and others for
/// single sites.
struct Choice {
  std::string math;
  std::vector<std::pair<Site, std::string>> sites{}; ///< each with its tier

  /// Equal for equal choices.
  std::string name() const;
  bool isMixture() const { return !sites.empty() || llvm::StringRef(math).contains(','); }
};

/// Writes a file that `anysl-link --math-choices` reads, with more keys that it passes over. False,
/// with an error, if that is not possible.
bool writeChoiceFile(DiagnosticEngine &diags, llvm::StringRef path, const Choice &choice,
                     llvm::json::Object more);

/// A shader library for one real and one choice of tiers, with all widths; of a mixture of tiers,
/// the widest only.
struct Build {
  std::string real;
  Choice choice;
  std::string runtime;
  std::string library; ///< its file
  link::Report report;
  /// Equal for libraries whose code is the same.
  std::string code;
};

/// Links the same files again and again, with other reals and math tiers, into a folder that is
/// removed at the end.
class Builder {
public:
  /// \p options says what stays the same; an empty runtime is "packet" for every real that it works
  /// with, and "scalar" for others. Throws Failed.
  Builder(DiagnosticEngine &diags, llvm::TargetMachine &target, std::vector<std::string> files,
          link::LinkOptions options);
  ~Builder();
  Builder(const Builder &) = delete;
  Builder &operator=(const Builder &) = delete;

  /// Links, unless that has been done before. Throws Failed.
  const Build &build(const std::string &real, const Choice &choice);

  /// Links the exact tier, out of a folder of resources of its own, for one point at a time, and
  /// lets the code be changed before it is written. Gives the library's file. Throws Failed.
  std::string
  buildSpecially(const std::string &real, const std::string &resourceDir,
                 llvm::function_ref<void(llvm::Module &module, const link::Report &report)> change);

  /// Links the exact tier for one point at a time into a library that says what each operator does
  /// (<anysl/notes.h>). Gives the library's file. Throws Failed.
  std::string buildTraced(const std::string &real);

  const std::string &resourceDir() const { return options.resourceDir; }
  const std::vector<std::string> &files() const { return inputs; }
  const std::string &folder() const { return temporary; }
  /// The real whose results count as the truth: `mp`, else `double`.
  std::string oracle() const;
  /// Whether there is a runtime for a real.
  bool works(const std::string &real) const;

private:
  /// Links and writes a library for one point at a time, of the exact tier.
  std::string
  buildOnce(link::LinkOptions wanted, const std::string &real,
            llvm::function_ref<void(llvm::Module &module, const link::Report &report)> change);
  std::string newLibrary();
  std::string runtimeFor(const std::string &real) const;

  DiagnosticEngine &diags;
  llvm::TargetMachine &target;
  std::vector<std::string> inputs;
  link::LinkOptions options;
  std::string temporary;
  unsigned libraries = 0;
  std::map<std::pair<std::string, std::string>, Build> builds;
};

} // namespace anysl::cost

#endif
