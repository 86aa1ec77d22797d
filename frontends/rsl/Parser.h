//===-- frontends/rsl/Parser.h - words to a tree ------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_PARSER_H
#define ANYSL_FRONTENDS_RSL_PARSER_H

#include "frontends/rsl/Ast.h"
#include "frontends/rsl/Token.h"
#include "lib/Support/Diagnostics.h"
#include <initializer_list>
#include <vector>

namespace anysl::rsl {

/// A recursive-descent parser. After an error it skips to the end of the statement or declaration
/// and goes on, so that one run reports several. How tightly operators bind, tightest first:
///
///     ! unary-   cast     .     * /     ^     + -     < <= > >=     == !=     &&     ||     ?: =
///     += …
class Parser {
public:
  /// \p tokens end with End.
  Parser(std::vector<Token> tokens, Ast &ast, DiagnosticEngine &diags)
      : tokens(std::move(tokens)), ast(ast), diags(diags) {}

  /// Parses the whole file into the tree.
  void parseFile();

private:
  /// What stands before a declared name.
  struct Specifiers {
    bool isOutput = false;
    bool isExtern = false;
    bool hasStorage = false;
    bool varying = false;
    bool hasType = false;
    TypeKind type = TypeKind::Error;
    const StructDecl *structure = nullptr;
    bool isArray = false; ///< of a function's result: `float[] f()`
    Expr *length = nullptr;
    SMLoc loc;
  };

  // Words
  const Token &peek(unsigned ahead = 0) const {
    return tokens[std::min(position + ahead, tokens.size() - 1)];
  }
  bool at(TokenKind kind) const { return peek().is(kind); }
  Token take();
  bool accept(TokenKind kind);
  bool expect(TokenKind kind, StringRef where, SMLoc open = {});
  void errorHere(const llvm::Twine &message);
  SMLoc lastEnd() const { return position ? tokens[position - 1].end : tokens[0].loc; }
  SMRange rangeFrom(SMLoc begin) const { return {begin, lastEnd()}; }
  void skipStatement();
  void skipToDeclaration();
  void skipBrackets();
  void skipBody();

  // Declarations
  void parseTopLevel();
  void parsePlugin();
  void parseShader(ShaderType type);
  FunctionDecl *parseFunction(const Specifiers &specifiers);
  Stmt *nestedFunction(llvm::SMLoc loc, FunctionDecl *decl);
  void makeShorterForms(FunctionDecl &decl);
  bool atArrayResult(unsigned ahead) const;
  bool parseArrayResult(Specifiers &specifiers);
  bool parseParams(VarKind kind, std::vector<VarDecl *> &params, FunctionDecl *owner);
  Specifiers parseSpecifiers();
  VarDecl *parseVariable(VarKind kind, const Specifiers &specifiers, FunctionDecl *owner);
  bool atTypeName() const;
  bool atSpecifier() const;
  bool atUntypedFunction() const;

  // Structures and class shaders (ParseStruct.cpp)
  StructDecl *structNamed(StringRef name) const;
  bool atNamedType() const;
  bool atConstant() const;
  bool atDefinition(StringRef word, TokenKind open) const;
  StructDecl *parseStruct();
  void parseClass();
  void parseMembers(StructDecl &decl);
  bool parseMember(StructDecl &decl, std::vector<VarDecl *> &members,
                   std::vector<FunctionDecl *> &methods);
  Expr *parseArrow(Expr *base, SMLoc begin);

  // Statements
  BlockStmt *parseBlock();
  Stmt *parseStatement();
  Stmt *parseStatementInner();
  Stmt *parseDeclaration();
  Stmt *parseUnknownType();
  Stmt *parseVariables(const Specifiers &specifiers);
  Stmt *parseIf();
  Stmt *parseWhile();
  Stmt *parseFor();
  Stmt *parseLight(StmtKind kind);
  Stmt *parseGather();
  bool enter(SMLoc loc);

  // Expressions; null after an error that has been reported
  Expr *parseExpr();
  Expr *parseList();
  Expr *parseAssignment();
  Expr *parseConditional();
  Expr *parseBinary(int least);
  void splitMinus(bool isPrefix);
  Expr *parseUnary();
  Expr *parsePostfix();
  Expr *parseIncrement(Expr *operand, SMLoc begin);
  Expr *parsePrimary();
  Expr *parseCast();
  Expr *parseCall();
  Expr *parseParenthesised();
  Expr *parseInitialiser();
  bool parseArguments(std::vector<Expr *> &args);
  template <typename T>
  T *grown(T *node, std::initializer_list<const Expr *> children);

  std::vector<Token> tokens;
  size_t position = 0;
  Ast &ast;
  DiagnosticEngine &diags;
  FunctionDecl *function = nullptr;  ///< the one whose body is being parsed
  std::vector<StructDecl *> structs; ///< those that are known here
  unsigned depth = 0;
};

} // namespace anysl::rsl

#endif
