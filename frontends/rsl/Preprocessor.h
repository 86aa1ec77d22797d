//===-- frontends/rsl/Preprocessor.h - includes, macros, conditionals ---------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_PREPROCESSOR_H
#define ANYSL_FRONTENDS_RSL_PREPROCESSOR_H

#include "frontends/rsl/Lexer.h"
#include "llvm/ADT/StringMap.h"
#include <memory>
#include <string>
#include <vector>

namespace anysl::rsl {

struct PreprocessorOptions {
  std::vector<std::string> includeDirs;
  /// NAME or NAME=VALUE, as after -D.
  std::vector<std::string> defines;
  /// More words than any shader has; macros that multiply are stopped here.
  size_t maxTokens = 4u << 20;
};

/// Turns a file into the words that the parser sees, as a C preprocessor does: #include, #define
/// with arguments, # and ##, #undef, #if and its family, #line, #error, #warning; #pragma is
/// ignored.
class Preprocessor {
public:
  Preprocessor(DiagnosticEngine &diags, PreprocessorOptions options);
  ~Preprocessor();

  /// Reads a file ("-": standard input) to its end. The last word is End. A file that cannot be
  /// read is reported and gives End alone. With \p text that is what the file is taken to contain.
  std::vector<Token> run(llvm::StringRef path, std::optional<llvm::StringRef> text = std::nullopt);
  /// Whether text is missing (a file, or what a run that gave up did not read), so that what
  /// follows from its absence is not worth reporting.
  bool isIncomplete() const { return incomplete; }
  /// Every file read so far, the main one first.
  llvm::ArrayRef<std::string> dependencies() const { return files; }

private:
  struct Macro {
    Token name;
    std::vector<llvm::StringRef> parameters;
    std::vector<Token> body;
    bool isFunction = false;
    bool isVariadic = false;
    bool disabled = false; ///< being expanded
  };

  /// Where words come from: a file, the words of an expansion, or (neither) a wall behind which the
  /// words of a macro's argument are expanded by themselves.
  struct Source {
    std::unique_ptr<Lexer> lexer;
    unsigned buffer = 0;
    size_t openConditions = 0;
    std::vector<Token> tokens;
    size_t position = 0;
    Macro *macro = nullptr;
    bool isWall = false;
  };

  struct Condition {
    llvm::SMLoc loc;
    bool taken = false; ///< some branch so far was chosen
    bool sawElse = false;
  };

  Token lex();
  Token lexRaw();
  bool expand(Token &name);
  bool expandFunction(const Token &name, Macro &macro);
  std::vector<Token> substitute(const Token &name, const Macro &macro,
                                const std::vector<std::vector<Token>> &arguments);
  std::vector<Token> expandAlone(llvm::ArrayRef<Token> tokens);
  Token stringize(const Token &hash, llvm::ArrayRef<Token> tokens);
  void paste(std::vector<Token> &out, const Token &right);
  Token number(const Token &like, unsigned value);
  void push(std::vector<Token> tokens, Macro *macro);
  void dropExpansions();

  bool enterFile(llvm::StringRef path, llvm::SMLoc from);
  void enterBuffer(unsigned buffer);
  Lexer &lexer();
  void directive();
  void endDirective();
  void defineDirective();
  void undefDirective();
  void includeDirective(llvm::SMLoc loc);
  void lineDirective(llvm::SMLoc loc, const Token *first);
  void ifDirective(llvm::SMLoc loc);
  void ifdefDirective(llvm::SMLoc loc, bool wanted);
  void elseDirective(const Token &name);
  void endifDirective(const Token &name);
  void skipBranch();
  bool evaluateCondition(llvm::SMLoc loc);

  DiagnosticEngine &diags;
  PreprocessorOptions options;
  llvm::BumpPtrAllocator allocator;
  llvm::StringSaver saver;
  std::vector<std::unique_ptr<Source>> stack;
  std::vector<Condition> conditions;
  llvm::StringMap<std::unique_ptr<Macro>> macros;
  std::vector<std::unique_ptr<Macro>> retired; ///< undefined, but perhaps still on the stack
  std::vector<std::string> files;
  size_t made = 0; ///< words so far, against macros that grow without bounds
  bool gaveUp = false;
  bool incomplete = false;
};

} // namespace anysl::rsl

#endif
