//===-- lib/Link/MathChoice.h - which math tier computes what -----------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A shader's elementary functions come from one tier, or each function from one of its own, or each
// place in a shader. docs/numerics.md has both forms in which a choice is written.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_MATHCHOICE_H
#define ANYSL_LIB_LINK_MATHCHOICE_H

#include "lib/Support/Diagnostics.h"
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace anysl::link {

/// A place in a shader where a function is to come from a tier of its own.
struct MathSite {
  std::string file; ///< as debug information has it, or the end of that path
  unsigned line = 0;
  unsigned column = 0; ///< 0: all of the line
  std::string function;
  std::string tier;

  bool fits(const FilePosition &position) const;
};

struct MathChoice {
  std::string tier = "u10";                     ///< for all that is not named
  std::map<std::string, std::string> functions; ///< the tier of a function, where it is another one
  std::vector<MathSite> sites;                  ///< of two that fit, the later one counts

  /// The tier of a function, where no site says otherwise.
  const std::string &tierOf(llvm::StringRef function) const;
  /// The tier of a function that is computed at a place.
  const std::string &tierOf(llvm::StringRef function, const FilePosition &position) const;
  /// All tiers that are named, each once, the one for all first.
  std::vector<std::string> tiers() const;
  /// "u10,pow=fast,wood.sl:12:sin=u35": the tier, functions by name, sites as they come.
  std::string text() const;
};

/// The elementary functions: sin, cos and so on, in the order of <anysl/MathFunctions.def>.
llvm::ArrayRef<llvm::StringRef> mathFunctions();

/// Reads "u35", "sin=u35,pow=fast" or "u35,sin=fast" into a choice. False, with an error, where a
/// function or a tier is unknown. `where` stands before messages.
bool readMathChoice(DiagnosticEngine &diags, llvm::StringRef text, llvm::StringRef where,
                    llvm::ArrayRef<std::string> knownTiers, MathChoice &choice);

/// Reads a file of choices (JSON).
bool readMathChoiceFile(DiagnosticEngine &diags, llvm::StringRef path,
                        llvm::ArrayRef<std::string> knownTiers, MathChoice &choice);

} // namespace anysl::link

#endif
