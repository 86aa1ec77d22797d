//===-- frontends/rsl/Sema.h - names, types, conversions ----------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_SEMA_H
#define ANYSL_FRONTENDS_RSL_SEMA_H

#include "frontends/rsl/Ast.h"
#include "frontends/rsl/Builtins.h"
#include "lib/Support/Diagnostics.h"
#include "llvm/ADT/StringMap.h"
#include <set>

namespace anysl {
struct FormatDirective;
}

namespace anysl::rsl {

/// Holds a parsed file against the rules of RSL and completes the tree: every name gets its
/// declaration, every call its overload, every expression its type and storage class; implicit
/// conversions become CastExprs. A tree without errors is all that lowering needs.
///
/// An overload is chosen by its arguments and by the type that the context wants (the `hint`), so
/// that `color c = noise(P)` is color noise. Where an argument is itself of a kind that depends on
/// its context
/// ("flexible": noise(P), a bare triple), the other arguments decide.
class Sema {
public:
  struct Options {
    bool isLibrary = false; ///< functions define operators (rslc --library)
    int arrayCapacity = 64; ///< room in arrays that grow by numbers which are not constant
  };

  Sema(Ast &ast, DiagnosticEngine &diags, Options options);
  void check();

private:
  struct Scope {
    FunctionDecl *function = nullptr;
    llvm::StringMap<VarDecl *> variables;
    llvm::StringMap<llvm::SmallVector<FunctionDecl *, 2>> functions;
    llvm::StringMap<StructDecl *> structs;
  };
  /// An overload that a call may mean, a function's or a built-in's.
  struct Candidate {
    FunctionDecl *function = nullptr;
    const Builtin *builtin = nullptr;
    TypeKind result() const { return function ? function->result.kind : builtin->result; }
    Type resultType() const {
      return function ? function->result.withVarying(false) : Type{builtin->result};
    }
    size_t size() const { return function ? function->params.size() : builtin->arguments.size(); }
    Type type(size_t i) const;
    bool isIn(size_t i) const;
    bool isOut(size_t i) const;
  };

  // Scopes
  void pushScope();
  void popScope();
  void declare(VarDecl *decl);
  VarDecl *lookup(StringRef name, FunctionDecl **owner = nullptr);
  void declareGlobals();
  void warnUnused(const VarDecl &decl);
  void declareUnknown(StringRef name, SMRange range);
  std::vector<StringRef> visibleNames() const;

  // Declarations
  void checkShader(ShaderDecl &shader);
  void checkFunction(FunctionDecl &function);
  void declareFunction(FunctionDecl &function);
  void checkBody(FunctionDecl &function);
  void checkParam(VarDecl &param);
  void checkVariable(VarDecl &decl);
  void checkArrayLength(VarDecl &decl);
  int arrayLength(Expr *length);
  void checkInitialiser(VarDecl &decl);
  void checkExtern(ExternStmt &stmt);
  void matchLibraryFunction(FunctionDecl &function);

  // Structures (SemaStruct.cpp)
  void checkStruct(StructDecl &decl);
  void checkMembers(StructDecl &decl);
  void checkMethod(FunctionDecl &method);
  void expandStruct(VarDecl &decl);
  static void appendLeaves(llvm::ArrayRef<VarDecl *> decls,
                           llvm::SmallVectorImpl<VarDecl *> &leaves);
  NameExpr *hiddenVariable(Type type, SMRange range);
  NameExpr *reference(VarDecl &decl, SMRange range);
  Expr *sequence(llvm::ArrayRef<Expr *> steps, Expr *value, SMRange range);
  Expr *splitSteps(Expr *expr, llvm::SmallVectorImpl<Expr *> &steps);
  Expr *memberOf(Expr *base, size_t i);
  void appendMembers(Expr *base, llvm::SmallVectorImpl<Expr *> &members);
  bool isThis(const Expr *expr);
  VarDecl *lookupOwn(StringRef name);
  Type probeMember(const MemberExpr &member);
  Expr *checkMember(MemberExpr &member, TypeKind hint);
  Expr *dotAsMember(BinaryExpr &dot);
  bool dotAsMemberInner(BinaryExpr &dot);
  void assignMembers(Expr *target, Expr *value, SMLoc loc, llvm::SmallVectorImpl<Expr *> &steps);
  Expr *assignment(Expr *target, Expr *value, SMLoc loc);
  Expr *assignStruct(Expr *target, Expr *value, SMLoc loc, SMRange range);
  void initialiseStruct(VarDecl &decl);
  Expr *checkConstructor(CallExpr &call, StructDecl &decl);
  void assignDefaults(VarDecl &member, llvm::SmallVectorImpl<Expr *> &steps);
  Expr *zeroOf(Type type, SMRange range);
  void flattenArguments(CallExpr &call, llvm::SmallVectorImpl<Expr *> &steps);
  void bindObject(CallExpr &call, llvm::SmallVectorImpl<Expr *> &steps);
  Expr *copyResult(CallExpr &call, llvm::SmallVectorImpl<Expr *> &steps);

  // Arrays whose length changes (SemaArray.cpp)
  static void raiseCapacity(Expr *array, int capacity);
  void raiseCapacityFor(Expr *array, Type from);
  void checkArrayResult(FunctionDecl &decl);
  Expr *checkArrayReturn(Expr *value, SMLoc loc);
  void checkResizedArguments(const CallExpr &call);
  Expr *checkArrayCall(CallExpr &call);
  void checkParams(llvm::ArrayRef<VarDecl *> &params);

  // Other shaders (SemaCoshader.cpp)
  Expr *checkCoshaderCall(CallExpr &call);
  Expr *checkRemoteMember(MemberExpr &member, TypeKind hint);
  Expr *checkRemoteCall(CallExpr &call, TypeKind hint);
  Expr *setRemoteResult(CallExpr &call, llvm::SmallVectorImpl<Expr *> &steps, Type other);
  static llvm::SmallVector<VarDecl *, 8> resultLeaves(const FunctionDecl &method);
  std::string shapeOf(Type &type, int wantedCapacity) const;
  void warnDeclined(const NamedGroup::Argument &argument, StringRef function, const Expr &name);
  void makeMethods(StructDecl &decl, llvm::ArrayRef<Stmt *> begin);
  ShaderDecl *makeMethod(StructDecl &decl, FunctionDecl &method, StringRef name,
                         llvm::ArrayRef<Type> types, llvm::ArrayRef<Stmt *> begin);

  // Class shaders (SemaClass.cpp)
  void checkClass(StructDecl &decl);
  void checkShaderName(const ShaderDecl &shader);
  bool checkEntry(const FunctionDecl &method, llvm::ArrayRef<llvm::StringLiteral> globals);
  Stmt *callOf(FunctionDecl &method, llvm::ArrayRef<Expr *> args);
  void makeEntries(StructDecl &decl);
  Stmt *displacementForMembers(FunctionDecl &method);

  // Statements
  void checkStmt(Stmt *stmt);
  void checkBlock(BlockStmt &block);
  void checkLoop(LoopStmt &loop);
  void enterBranch(const Expr *condition);
  void leaveBranch(const Expr *condition);
  void checkJump(JumpStmt &jump);
  void checkReturn(ReturnStmt &stmt);
  void checkGather(GatherStmt &stmt); // SemaGather.cpp
  void checkGatherPairs(GatherStmt &stmt, llvm::MutableArrayRef<Expr *> pairs);
  void checkLight(LightStmt &stmt); // SemaLight.cpp
  void checkLightMessages(LightStmt &stmt, llvm::ArrayRef<Expr *> args);
  bool checkSentValue(Expr *value);
  bool checkAskedLight(Expr *variable, const llvm::Twine &what);
  Expr *checkLightSource(CallExpr &call);

  // Expressions. check() returns the expression or what replaces it, never null; after an error its
  // type is Error.
  Expr *check(Expr *expr, TypeKind hint = TypeKind::Error);
  Expr *checkName(NameExpr &name);
  Expr *checkIndex(IndexExpr &index);
  Expr *checkNegate(NegateExpr &negate, TypeKind hint);
  Expr *checkBinary(BinaryExpr &binary, TypeKind hint);
  bool reportMember(BinaryExpr &dot);
  Expr *checkComparison(BinaryExpr &binary);
  Expr *checkConditional(ConditionalExpr &conditional, TypeKind hint);
  Expr *chooseWhole(ConditionalExpr &conditional);
  Expr *checkAssign(AssignExpr &assign);
  Expr *checkTuple(TupleExpr &tuple, TypeKind hint);
  Expr *checkCast(CastExpr &cast);
  void checkColorSpace(const Expr &space);
  Expr *checkCall(CallExpr &call, TypeKind hint);
  Expr *checkList(ListExpr &list, Type wanted);
  Expr *checkCondition(Expr *expr);
  void checkTarget(Expr *target, bool valueVaries, SMLoc loc, StringRef how);
  Type arithmeticType(BinaryExpr &binary);
  Expr *convert(Expr *expr, Type to, const llvm::Twine &what);
  Expr *checkAs(Expr *expr, Type to, const llvm::Twine &what);
  Expr *checkWhole(Expr *expr, Type to, const llvm::Twine &what);
  bool checkStorage(const Expr *value, bool targetVaries, const llvm::Twine &what);
  std::optional<double> constant(const Expr *expr);

  // Calls
  Type probe(Expr *expr);
  Type probeInner(Expr *expr);
  std::vector<Candidate> candidates(const CallExpr &call);
  StructDecl *lookupStruct(StringRef name);
  static int argumentCost(const Candidate &candidate, size_t i, Type arg);
  int cost(const Candidate &candidate, const CallExpr &call, llvm::ArrayRef<Type> args,
           TypeKind hint);
  std::optional<Candidate> choose(CallExpr &call, llvm::ArrayRef<Type> args, TypeKind hint);
  bool isFlexible(CallExpr &call, llvm::ArrayRef<Type> args);
  Expr *reportNoObject(CallExpr &call);
  void reportUnknown(const CallExpr &call);
  void reportNoMatch(const CallExpr &call, llvm::ArrayRef<Type> args,
                     llvm::ArrayRef<Candidate> candidates);
  CallExpr *foldExtremes(CallExpr &call);
  bool chooseComponentWise(CallExpr &call, llvm::ArrayRef<Type> args);
  // Arguments by name (SemaNamed.cpp)
  void splitNamed(CallExpr &call);
  void checkNamed(CallExpr &call, const NamedGroup &group, bool &varying, bool &bad);
  // Built-ins without a fixed list of arguments (SemaSpecial.cpp); null if the name is none of
  // them.
  Expr *checkSpecial(CallExpr &call, TypeKind hint);
  Expr *checkArrayLengthCall(CallExpr &call);
  Expr *checkSpline(CallExpr &call, TypeKind hint);
  // Queries (SemaQuery.cpp)
  Expr *checkQuery(CallExpr &call);
  Expr *checkShaderName(CallExpr &call);
  void checkIsInLight(const CallExpr &call);
  // Text (SemaText.cpp)
  Expr *checkFormat(CallExpr &call);
  std::vector<FormatDirective> directivesOf(const StringExpr &format);
  Expr *checkConcat(CallExpr &call);
  // Forms of built-ins that are calls of another (SemaDerivatives.cpp); null if the call has none.
  Expr *rewriteCall(CallExpr &call, TypeKind hint);
  Expr *rewriteFilterstep(CallExpr &call, size_t positional, TypeKind hint);
  std::string signature(const Candidate &candidate);
  void useVarying();

  Ast &ast;
  DiagnosticEngine &diags;
  Options options;
  std::vector<Scope> scopes;
  ShaderDecl *shader = nullptr;
  FunctionDecl *function = nullptr;
  StructDecl *structure = nullptr; ///< whose methods are being checked
  size_t structureScope = 0;       ///< how many scopes those see
  unsigned loops = 0;
  unsigned illuminances = 0;
  /// Those that decide whether what is being checked runs at all.
  llvm::SmallVector<const Expr *> varyingConditions;
};

/// An expression that was reported.
inline Expr *failed(Expr *expr) {
  expr->type = {TypeKind::Error};
  return expr;
}

/// How many numbers a value is; 0 for one that is no number.
unsigned componentsOf(Type type);
/// The names of the curves that spline() knows; some have several.
llvm::ArrayRef<std::pair<llvm::StringLiteral, SplineBasis>> splineBases();
/// Whether values are text: strings and handles.
bool isTextual(TypeKind kind);
/// The letter of a value that is no array in AnyslMessage: f, t, m, s; v for void, 0 for others.
char shapeLetter(Type type);
/// Whether a variable gets a value back where it is an argument of another shader's method.
bool isRemoteOutput(const VarDecl &decl);
/// Whether a name asks for another shader: getshader, getvar, …
bool isCoshaderCall(StringRef name);
/// Whether a name is an operation on an array: resize, push, …
bool isArrayCall(StringRef name);

/// The common type of two operands of arithmetic; Error if there is none.
TypeKind combinedKind(BinaryOp op, Type left, Type right);

} // namespace anysl::rsl

#endif
