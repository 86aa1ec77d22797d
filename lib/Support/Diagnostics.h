//===-- lib/Support/Diagnostics.h - messages that point at sources --------------------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Errors, warnings, remarks and notes in the form that clang made familiar:
//
//     shader.sl:3:8: error: unknown function 'noramlize'; did you mean 'normalize'?
//       N = noramlize(N);
//           ^~~~~~~~~
//           normalize
//
// A message is built by chaining and printed when the builder goes out of scope:
//
//     diags.error(loc, "redefinition of '" + name + "'").range(begin, end).note(old, "declared
//     here");
//
// It points either at text that this engine has loaded (SMLoc) or at a file, line and column known
// from elsewhere, such as a debug location; the file is read for its source line if that is
// possible.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_SUPPORT_DIAGNOSTICS_H
#define ANYSL_LIB_SUPPORT_DIAGNOSTICS_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/ADT/Twine.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/SourceMgr.h"
#include "llvm/Support/raw_ostream.h"
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace anysl {

enum class Severity { Note, Remark, Warning, Error };

/// A place named from outside: a path as the compiler was given it, and a line and column from 1.
/// Line 0 means the whole file, column 0 the whole line, an empty path no place at all.
struct FilePosition {
  std::string file;
  unsigned line = 0;
  unsigned column = 0;

  explicit operator bool() const { return !file.empty(); }
};

/// A kind of warning, named as in -Wunused-variable.
struct WarningGroup {
  llvm::StringRef name;
  bool onByDefault = false;
};

/// One message with everything that belongs to it.
struct Diagnostic {
  Severity severity = Severity::Error;
  llvm::SMLoc loc;       ///< in a loaded buffer, or invalid
  FilePosition position; ///< presumed place (after #line), also where `loc` is invalid
  std::string message;
  bool showsLine = true; ///< the source line, where there is one
  std::vector<llvm::SMRange> ranges;
  std::vector<llvm::SMFixIt> fixits;
  std::vector<Diagnostic> notes;
};

class DiagnosticEngine;

/// A message under construction; it is reported at the end of the full expression.
class DiagnosticBuilder {
public:
  DiagnosticBuilder(DiagnosticEngine &engine, std::optional<Diagnostic> diagnostic)
      : engine(engine), diagnostic(std::move(diagnostic)) {}
  DiagnosticBuilder(const DiagnosticBuilder &) = delete;
  DiagnosticBuilder &operator=(const DiagnosticBuilder &) = delete;
  ~DiagnosticBuilder();

  /// Underlines [begin, end).
  DiagnosticBuilder &range(llvm::SMLoc begin, llvm::SMLoc end);
  DiagnosticBuilder &range(llvm::SMRange range) { return this->range(range.Start, range.End); }
  /// Shows the text that should stand in place of a range.
  DiagnosticBuilder &fixit(llvm::SMRange replaced, const llvm::Twine &text);
  /// Adds a note; later calls of range() and fixit() still concern the message itself. Without
  /// \p showsLine the source line, which was shown already, is left out.
  DiagnosticBuilder &note(llvm::SMLoc loc, const llvm::Twine &message, llvm::SMRange range = {},
                          bool showsLine = true);
  DiagnosticBuilder &note(FilePosition position, const llvm::Twine &message);

private:
  DiagnosticEngine &engine;
  std::optional<Diagnostic> diagnostic; ///< none: a warning that is switched off
};

/// Owns the source text of one run and reports on it.
class DiagnosticEngine {
public:
  /// \p tool prefixes messages that have no place: "rslc: error: no input file".
  explicit DiagnosticEngine(llvm::StringRef tool, llvm::raw_ostream &out = llvm::errs());

  // Sources ------------------------------------------------------------------------------------

  llvm::SourceMgr &sources() { return sourceManager; }
  /// Loads a file ("-" is standard input); CR and CR-LF line ends become LF, so that lines count as
  /// people see them. Returns the buffer's number.
  llvm::Expected<unsigned> addFile(llvm::StringRef path, llvm::SMLoc includedFrom = {});
  /// The same for text that is at hand.
  unsigned addText(llvm::StringRef name, llvm::StringRef text, llvm::SMLoc includedFrom = {});
  llvm::StringRef text(unsigned buffer) const;
  /// From the line after the one of \p loc on, lines count from \p line, in \p file unless that is
  /// empty (a #line directive).
  void setPresumed(llvm::SMLoc loc, unsigned line, llvm::StringRef file);
  /// What is reported at \p use comes out of a macro defined at \p definition; a note will say so.
  void setExpansion(llvm::SMLoc use, llvm::StringRef macro, llvm::SMLoc definition);
  /// File, line and column as they are to be shown.
  FilePosition presumed(llvm::SMLoc loc) const;

  // Reports ------------------------------------------------------------------------------------

  DiagnosticBuilder error(llvm::SMLoc loc, const llvm::Twine &message);
  DiagnosticBuilder error(FilePosition position, const llvm::Twine &message);
  DiagnosticBuilder error(const llvm::Twine &message) { return error(llvm::SMLoc(), message); }
  DiagnosticBuilder warning(llvm::SMLoc loc, WarningGroup group, const llvm::Twine &message);
  DiagnosticBuilder warning(FilePosition position, WarningGroup group, const llvm::Twine &message);
  DiagnosticBuilder remark(FilePosition position, const llvm::Twine &message);
  /// Reports a finished message.
  void report(Diagnostic diagnostic);

  bool hasErrors() const { return errors != 0; }
  unsigned errorCount() const { return errors; }
  unsigned warningCount() const { return warnings; }
  /// True once the error limit is reached; the caller should come to an end.
  bool reachedLimit() const { return errorLimit && errors >= errorLimit; }
  /// "2 errors and 1 warning generated.", nothing if there were none.
  void printSummary();

  // Settings -----------------------------------------------------------------------------------

  void setWarningsAsErrors(bool on) { warningsAsErrors = on; }
  /// Switches every group on (-Wall).
  void setAllWarnings(bool on) { allWarnings = on; }
  /// Silences all warnings (-w).
  void setNoWarnings(bool on) { noWarnings = on; }
  /// -W<name> or -Wno-<name>.
  void setWarning(llvm::StringRef name, bool on) { chosenWarnings[name] = on; }
  /// Errors beyond this number are not printed; 0 means no limit. The default is 20.
  void setErrorLimit(unsigned limit) { errorLimit = limit; }
  /// Hands messages over instead of printing them.
  void setConsumer(std::function<void(const Diagnostic &)> function) {
    consumer = std::move(function);
  }

private:
  struct Expansion {
    std::string macro;
    llvm::SMLoc definition;
  };

  struct LineMark {
    const char *from; ///< first character of the first line that it concerns
    unsigned line;
    std::string file;
  };

  bool isEnabled(WarningGroup group) const;
  DiagnosticBuilder start(Severity severity, llvm::SMLoc loc, FilePosition position,
                          const llvm::Twine &message);
  llvm::SMLoc locate(const FilePosition &position);
  void print(const Diagnostic &diagnostic);
  void printIncludeStack(llvm::SMLoc loc);
  /// Whether a place's line is too long to be worth showing, as those of generated files are.
  bool isOnLongLine(llvm::SMLoc loc) const;

  std::string tool;
  llvm::raw_ostream &out;
  llvm::SourceMgr sourceManager;
  std::vector<std::vector<LineMark>> lineMarks; ///< by buffer, in order of text
  llvm::DenseMap<const char *, Expansion> expansions;
  llvm::StringMap<unsigned> readFiles; ///< buffers opened for a FilePosition; 0: unreadable
  llvm::StringMap<bool> chosenWarnings;
  llvm::StringSet<> reported; ///< a message is given once per place
  std::function<void(const Diagnostic &)> consumer;
  const void *lastIncludedFrom = nullptr;
  unsigned errors = 0;
  unsigned warnings = 0;
  unsigned errorLimit = 20;
  bool limitReported = false;
  bool warningsAsErrors = false;
  bool allWarnings = false;
  bool noWarnings = false;
};

/// The candidate that \p name is most likely a misspelling of, or nothing: at most a third of the
/// letters may differ. Of equally near candidates the first wins.
std::optional<llvm::StringRef> suggest(llvm::StringRef name,
                                       llvm::ArrayRef<llvm::StringRef> candidates);

/// "; did you mean 'x'?" or nothing, to be put behind a message about \p name.
std::string didYouMean(llvm::StringRef name, llvm::ArrayRef<llvm::StringRef> candidates);

} // namespace anysl

#endif
