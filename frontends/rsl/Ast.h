//===-- frontends/rsl/Ast.h - a shader as a tree ------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The parser makes the tree; Sema gives names their declarations, expressions their types, and
// makes implicit conversions explicit; lowering reads it. Nodes live in an Ast's arena, are never
// freed one by one, and hold nothing that would need a destructor. llvm::isa, cast and dyn_cast
// work on them.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_AST_H
#define ANYSL_FRONTENDS_RSL_AST_H

#include "frontends/rsl/Type.h"
#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Allocator.h"
#include "llvm/Support/Casting.h"
#include "llvm/Support/SMLoc.h"
#include "llvm/Support/StringSaver.h"

namespace anysl::rsl {

struct Builtin;
struct FunctionDecl;
struct StructDecl;
struct VarDecl;
using llvm::ArrayRef;
using llvm::SMLoc;
using llvm::SMRange;
using llvm::StringRef;

//===-- Expressions -----------------------------------------------------------------------------//

enum class ExprKind : uint8_t {
  Number,
  String,
  Name,
  Index,
  Member,
  Negate,
  Not,
  Binary,
  Conditional,
  Assign,
  Tuple,
  Cast,
  Call,
  List,
  Comma,
  Opaque
};

struct Expr {
  const ExprKind kind;
  bool hasEffects = false; ///< assigns something, in itself or below
  bool isProbed = false;   ///< `probed` is valid
  SMLoc loc;               ///< what a message about it points at
  SMRange range;           ///< all of its text
  Type type;               ///< set by Sema
  Type probed;             ///< Sema's guess before the context is known; Error: depends on it
  unsigned depth = 1;      ///< of the tree below, itself included

protected:
  Expr(ExprKind kind, SMLoc loc, SMRange range) : kind(kind), loc(loc), range(range) {}
};

struct NumberExpr : Expr {
  double value;
  NumberExpr(SMRange range, double value)
      : Expr(ExprKind::Number, range.Start, range), value(value) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Number; }
};

struct StringExpr : Expr {
  StringRef value;
  StringExpr(SMRange range, StringRef value)
      : Expr(ExprKind::String, range.Start, range), value(value) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::String; }
};

struct NameExpr : Expr {
  StringRef name;
  VarDecl *decl = nullptr;
  NameExpr(SMRange range, StringRef name) : Expr(ExprKind::Name, range.Start, range), name(name) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Name; }
};

/// An array's element, or a component of a triple.
struct IndexExpr : Expr {
  Expr *base;
  Expr *index;
  IndexExpr(SMLoc loc, SMRange range, Expr *base, Expr *index)
      : Expr(ExprKind::Index, loc, range), base(base), index(index) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Index; }
};

/// A member of a structure, or of the class that a method belongs to: `a->b`, `a.b`. Sema replaces
/// it by the variable that the member is.
struct MemberExpr : Expr {
  Expr *base;
  StringRef name;
  SMRange nameRange;
  Type wanted; ///< the array that the context wants, if it does
  MemberExpr(SMRange range, Expr *base, StringRef name, SMRange nameRange)
      : Expr(ExprKind::Member, nameRange.Start, range), base(base), name(name),
        nameRange(nameRange) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Member; }
};

struct NegateExpr : Expr {
  Expr *operand;
  NegateExpr(SMLoc loc, SMRange range, Expr *operand)
      : Expr(ExprKind::Negate, loc, range), operand(operand) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Negate; }
};

struct NotExpr : Expr {
  Expr *operand;
  NotExpr(SMLoc loc, SMRange range, Expr *operand)
      : Expr(ExprKind::Not, loc, range), operand(operand) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Not; }
};

enum class BinaryOp : uint8_t {
  Add,
  Subtract,
  Multiply,
  Divide,
  Dot,
  Cross,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Equal,
  NotEqual,
  And,
  Or
};
StringRef spelling(BinaryOp op);
inline bool isComparison(BinaryOp op) { return op >= BinaryOp::Less && op <= BinaryOp::NotEqual; }
inline bool isLogical(BinaryOp op) { return op == BinaryOp::And || op == BinaryOp::Or; }

struct BinaryExpr : Expr {
  BinaryOp op;
  Expr *left;
  Expr *right;
  Expr *meaning = nullptr; ///< of a dot that takes a structure's member, once Sema has found out
  BinaryExpr(SMLoc loc, SMRange range, BinaryOp op, Expr *left, Expr *right)
      : Expr(ExprKind::Binary, loc, range), op(op), left(left), right(right) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Binary; }
};

struct ConditionalExpr : Expr {
  Expr *condition;
  Expr *whenTrue;
  Expr *whenFalse;
  ConditionalExpr(SMLoc loc, SMRange range, Expr *condition, Expr *whenTrue, Expr *whenFalse)
      : Expr(ExprKind::Conditional, loc, range), condition(condition), whenTrue(whenTrue),
        whenFalse(whenFalse) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Conditional; }
};

/// A value that is computed elsewhere: the old value of a compound assignment's target.
struct OpaqueExpr : Expr {
  explicit OpaqueExpr(const Expr *of) : Expr(ExprKind::Opaque, of->loc, of->range) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Opaque; }
};

struct AssignExpr : Expr {
  Expr *target;
  Expr *value; ///< for a compound assignment, from Sema on: the operation on `old`
  bool isCompound;
  BinaryOp op = BinaryOp::Add;
  OpaqueExpr *old = nullptr;
  AssignExpr(SMLoc loc, SMRange range, Expr *target, Expr *value)
      : Expr(ExprKind::Assign, loc, range), target(target), value(value), isCompound(false) {}
  AssignExpr(SMLoc loc, SMRange range, BinaryOp op, Expr *target, Expr *value)
      : Expr(ExprKind::Assign, loc, range), target(target), value(value), isCompound(true), op(op) {
  }
  static bool classof(const Expr *e) { return e->kind == ExprKind::Assign; }
};

/// (a, b, c) or 16 values.
struct TupleExpr : Expr {
  ArrayRef<Expr *> elements;
  TupleExpr(SMRange range, ArrayRef<Expr *> elements)
      : Expr(ExprKind::Tuple, range.Start, range), elements(elements) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Tuple; }
};

/// `type expr`, `type "space" expr`, or a conversion that Sema has put in.
struct CastExpr : Expr {
  TypeKind to;
  Expr *space; ///< null: none
  Expr *operand;
  bool isImplicit = false;
  CastExpr(SMLoc loc, SMRange range, TypeKind to, Expr *space, Expr *operand)
      : Expr(ExprKind::Cast, loc, range), to(to), space(space), operand(operand) {}
  CastExpr(Type type, Expr *operand)
      : Expr(ExprKind::Cast, operand->loc, operand->range), to(type.kind), space(nullptr),
        operand(operand), isImplicit(true) {
    this->type = type;
    hasEffects = operand->hasEffects;
  }
  static bool classof(const Expr *e) { return e->kind == ExprKind::Cast; }
};

/// What a call turned out to be; Sema says so.
enum class CallForm : uint8_t {
  Function,      ///< `function` is expanded
  Builtin,       ///< `builtin` is one operator
  ComponentWise, ///< `builtin` of floats, applied to each component of its arguments
  Coshader,      ///< of another shader; `coshaderOp` says what
  Array,         ///< resize, push … of an array; `arrayOp` says which
  ArrayLength,   ///< known where a function is expanded, or when the shader runs
  Spline,        ///< value, then an array or at least four knots; `basis` says which curve
  Query,         ///< name and variable
  Print,         ///< printf: a format and values
  Format,        ///< the same as text
  Concat,        ///< texts
  ShaderName     ///< of the shader that is lowered
};

/// The curves that spline() knows.
enum class SplineBasis : uint8_t { CatmullRom, Bezier, BSpline, Hermite, Power, Linear };

/// What a call does to an array whose length changes.
enum class ArrayOp : uint8_t { Resize, Reserve, Push, Pop, Capacity };

/// What is asked of another shader.
enum class CoshaderOp : uint8_t { Get, GetAll, GetLights, Variable, Member, Method };

struct CallExpr : Expr {
  StringRef name;
  SMRange nameRange;
  llvm::MutableArrayRef<Expr *> args; ///< from Sema on: structures as their members
  Expr *object = nullptr;             ///< what a method is called on, null if none is written
  ArrayRef<Expr *> self;              ///< from Sema on: the object's members, where it is another
  llvm::MutableArrayRef<Expr *> rest; ///< what follows `args`, once Sema has told them apart
  ArrayRef<Expr *> named;             ///< the value of each field of NamedArguments.def, or null
  FunctionDecl *function = nullptr;   ///< one of these, from Sema on
  const Builtin *builtin = nullptr;
  CallForm form = CallForm::Function;
  bool isSplit = false; ///< `rest` has been told from `args`
  SplineBasis basis = SplineBasis::CatmullRom;
  Expr *basisName = nullptr; ///< Spline: text that says which at run time
  ArrayOp arrayOp = ArrayOp::Resize;
  CoshaderOp coshaderOp = CoshaderOp::Get;
  StringRef remoteName; ///< Member, Method: its name; "" if the renderer is not asked
  Type wanted;          ///< the array or structure that the context wants, if it does
  /// Member, Method: the variables that get a result which is an array or structure.
  ArrayRef<VarDecl *> results;
  CallExpr(SMRange nameRange, SMRange range, StringRef name, llvm::MutableArrayRef<Expr *> args)
      : Expr(ExprKind::Call, nameRange.Start, range), name(name), nameRange(nameRange), args(args) {
  }
  static bool classof(const Expr *e) { return e->kind == ExprKind::Call; }
};

/// {a, b, …}, the value of an array.
struct ListExpr : Expr {
  llvm::MutableArrayRef<Expr *> elements;
  ListExpr(SMRange range, llvm::MutableArrayRef<Expr *> elements)
      : Expr(ExprKind::List, range.Start, range), elements(elements) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::List; }
};

/// a, b in the head of a for loop; also what Sema makes of an operation on a structure: the steps
/// before its value.
struct CommaExpr : Expr {
  llvm::MutableArrayRef<Expr *> elements;
  CommaExpr(SMRange range, llvm::MutableArrayRef<Expr *> elements)
      : Expr(ExprKind::Comma, range.Start, range), elements(elements) {}
  static bool classof(const Expr *e) { return e->kind == ExprKind::Comma; }
};

//===-- Statements ------------------------------------------------------------------------------//

enum class StmtKind : uint8_t {
  Empty,
  Block,
  Declaration,
  Expression,
  If,
  While,
  For,
  Break,
  Continue,
  Return,
  Illuminance,
  Illuminate,
  Solar,
  Gather,
  Function,
  Struct,
  Extern
};

struct Stmt {
  const StmtKind kind;
  SMLoc loc;
  Stmt(StmtKind kind, SMLoc loc) : kind(kind), loc(loc) {}
};

struct BlockStmt : Stmt {
  ArrayRef<Stmt *> body;
  SMLoc end;
  BlockStmt(SMLoc loc, SMLoc end, ArrayRef<Stmt *> body)
      : Stmt(StmtKind::Block, loc), body(body), end(end) {}
  static bool classof(const Stmt *s) { return s->kind == StmtKind::Block; }
};

struct DeclarationStmt : Stmt {
  ArrayRef<VarDecl *> variables;
  DeclarationStmt(SMLoc loc, ArrayRef<VarDecl *> variables)
      : Stmt(StmtKind::Declaration, loc), variables(variables) {}
  static bool classof(const Stmt *s) { return s->kind == StmtKind::Declaration; }
};

/// `extern type a, b;`: names of an enclosing scope; each VarDecl is what was written.
struct ExternStmt : Stmt {
  ArrayRef<VarDecl *> variables;
  ExternStmt(SMLoc loc, ArrayRef<VarDecl *> variables)
      : Stmt(StmtKind::Extern, loc), variables(variables) {}
  static bool classof(const Stmt *s) { return s->kind == StmtKind::Extern; }
};

struct ExpressionStmt : Stmt {
  Expr *expr;
  explicit ExpressionStmt(Expr *expr) : Stmt(StmtKind::Expression, expr->loc), expr(expr) {}
  static bool classof(const Stmt *s) { return s->kind == StmtKind::Expression; }
};

struct IfStmt : Stmt {
  Expr *condition;
  Stmt *thenBody;
  Stmt *elseBody; ///< null: none
  IfStmt(SMLoc loc, Expr *condition, Stmt *thenBody, Stmt *elseBody)
      : Stmt(StmtKind::If, loc), condition(condition), thenBody(thenBody), elseBody(elseBody) {}
  static bool classof(const Stmt *s) { return s->kind == StmtKind::If; }
};

/// while and for: `init` and `step` only in the last, `condition` null where left out.
struct LoopStmt : Stmt {
  Stmt *init = nullptr;
  Expr *condition = nullptr;
  Expr *step = nullptr;
  Stmt *body = nullptr;
  LoopStmt(StmtKind kind, SMLoc loc) : Stmt(kind, loc) {}
  static bool classof(const Stmt *s) {
    return s->kind == StmtKind::While || s->kind == StmtKind::For;
  }
};

/// break and continue, out of `levels` loops.
struct JumpStmt : Stmt {
  Expr *count; ///< null: 1
  unsigned levels = 1;
  JumpStmt(StmtKind kind, SMLoc loc, Expr *count) : Stmt(kind, loc), count(count) {}
  static bool classof(const Stmt *s) {
    return s->kind == StmtKind::Break || s->kind == StmtKind::Continue;
  }
};

struct ReturnStmt : Stmt {
  Expr *value; ///< null: none
  ReturnStmt(SMLoc loc, Expr *value) : Stmt(StmtKind::Return, loc), value(value) {}
  static bool classof(const Stmt *s) { return s->kind == StmtKind::Return; }
};

/// "light:NAME", variable or "send:light:NAME", value behind the other arguments of illuminance: a
/// parameter of each light.
struct LightMessage {
  llvm::StringRef name;
  Expr *value;
};

/// illuminance, illuminate and solar. Sema sorts the arguments into the named ones.
struct LightStmt : Stmt {
  llvm::MutableArrayRef<Expr *> args;
  Stmt *body;
  Expr *category = nullptr;
  Expr *position = nullptr;
  Expr *axis = nullptr;
  Expr *angle = nullptr;
  llvm::ArrayRef<LightMessage> asked; ///< "light:"
  llvm::ArrayRef<LightMessage> sent;  ///< "send:light:"
  LightStmt(StmtKind kind, SMLoc loc, llvm::MutableArrayRef<Expr *> args, Stmt *body)
      : Stmt(kind, loc), args(args), body(body) {}
  static bool classof(const Stmt *s) {
    return s->kind >= StmtKind::Illuminance && s->kind <= StmtKind::Solar;
  }
};

struct StructStmt : Stmt {
  StructDecl *structure;
  StructStmt(SMLoc loc, StructDecl *structure)
      : Stmt(StmtKind::Struct, loc), structure(structure) {}
  static bool classof(const Stmt *s) { return s->kind == StmtKind::Struct; }
};

/// What gather() tells its body.
enum class GatherValue : uint8_t {
#define RSL_GATHER_OUTPUT(id, name, type, onMiss, meaning) id,
#include "frontends/rsl/GatherOutputs.def"
};

/// Sema sorts the arguments into the named ones.
struct GatherStmt : Stmt {
  struct Output {
    GatherValue value;
    TypeKind type; ///< of the value
    Expr *target;
  };
  llvm::MutableArrayRef<Expr *> args;
  Stmt *body;
  Stmt *elseBody; ///< null: none
  Expr *category = nullptr;
  Expr *position = nullptr;
  Expr *direction = nullptr;
  Expr *angle = nullptr;
  Expr *samples = nullptr;
  ArrayRef<Expr *> named; ///< the value of each field of NamedArguments.def, or null
  ArrayRef<Output> outputs;
  ArrayRef<LightMessage> asked; ///< other values of what a ray meets: "surface:NAME", variable
  GatherStmt(SMLoc loc, llvm::MutableArrayRef<Expr *> args, Stmt *body, Stmt *elseBody)
      : Stmt(StmtKind::Gather, loc), args(args), body(body), elseBody(elseBody) {}
  static bool classof(const Stmt *s) { return s->kind == StmtKind::Gather; }
};

struct FunctionStmt : Stmt {
  FunctionDecl *function;
  FunctionStmt(SMLoc loc, FunctionDecl *function)
      : Stmt(StmtKind::Function, loc), function(function) {}
  static bool classof(const Stmt *s) { return s->kind == StmtKind::Function; }
};

/// Whether control never leaves a statement at its end.
bool alwaysReturns(const Stmt *stmt);

//===-- Declarations ----------------------------------------------------------------------------//

enum class VarKind : uint8_t { Global, ShaderParam, FunctionParam, Local };

struct VarDecl {
  VarKind kind;
  StringRef name;
  SMRange range;                 ///< of the name; invalid for a global
  Type type;                     ///< the length of an array: see `length`
  Expr *length = nullptr;        ///< the expression in [], null if none
  Expr *init = nullptr;          ///< a structure's: from Sema on an assignment
  ArrayRef<VarDecl *> members;   ///< of a structure, from Sema on: the variables it consists of
  FunctionDecl *owner = nullptr; ///< the function whose parameter or local it is
  unsigned id = 0;               ///< Global: as in Globals.def; ShaderParam: number from 0
  bool isOutput = false;
  bool isReadOnly = false; ///< Global: an assignment changes the shader's own copy
  bool hasStorage = false; ///< `uniform` or `varying` was written
  size_t branches = 0;     ///< varying conditions around its declaration
  bool isRead = false;
  bool isAssigned = false;
  bool isCopied = false;      ///< a function's parameter that its body assigns without `output`
  bool defaultVaries = false; ///< ShaderParam whose default differs from point to point
  int wantedCapacity = 0;     ///< FunctionParam [] whose length the body changes: the room it needs
  VarDecl *lengthVariable =
      nullptr;           ///< ShaderParam [] with the host's length: the parameter for it
  bool isHidden = false; ///< made by Sema, not declared by a statement
};

struct FunctionDecl {
  StringRef name;
  SMRange range; ///< of the name
  Type result;
  bool resultHasStorage = false;
  Expr *resultLength = nullptr; ///< of an array, as written; null: none, or `[]`
  ArrayRef<VarDecl *> params;
  ArrayRef<VarDecl *> leaves;        ///< the parameters, structures as their members; from Sema on
  VarDecl *resultVariable = nullptr; ///< of one that returns a structure or array; from Sema on
  BlockStmt *body = nullptr;
  FunctionDecl *outer = nullptr;    ///< the function that it is nested in
  StructDecl *parent = nullptr;     ///< whose method it is
  ArrayRef<FunctionDecl *> shorter; ///< forms without the last parameters, which have defaults
  const Builtin *defines = nullptr; ///< in a library: the built-in whose operator it is
  bool isBeingChecked = false;
  bool isChecked = false;
  bool isPublic = false;
  bool isVarying = false;      ///< gives varying values whatever its arguments are
  bool assignsMembers = false; ///< of a class, or calls what does
  bool usesOuter = false;      ///< names a variable that is not its own
  bool isUsed = false;
};

/// A structure or a class shader: its members and methods. The members are variables as the methods
/// see them; where a method is called, lowering puts the object's in their place.
struct StructDecl {
  StringRef name;
  SMRange range; ///< of the name
  ArrayRef<VarDecl *> members;
  ArrayRef<VarDecl *> leaves; ///< the members, structures as theirs; from Sema on
  ArrayRef<FunctionDecl *> methods;
  ArrayRef<StructDecl *> inner; ///< structures defined inside
  bool isClass = false;         ///< a class shader, whose entry methods are shaders
  ArrayRef<VarDecl *> params;   ///< of a class shader
};

enum class ShaderType : uint8_t { Surface = 1, Displacement, Light, Volume, Imager, Method };
StringRef nameOf(ShaderType type);

/// What a shader that is a method does behind its body: the arguments come, and go with the result,
/// in two output parameters, as lib/Host/Methods.cpp says.
struct MethodCall {
  CallExpr *call;
  ArrayRef<VarDecl *> arguments; ///< variables that the call's arguments name
  VarDecl *numbers = nullptr;    ///< null: none
  VarDecl *texts = nullptr;
};

struct ShaderDecl {
  ShaderType type;
  StringRef name;
  SMRange range;
  ArrayRef<VarDecl *> params;
  BlockStmt *body = nullptr;
  MethodCall *method = nullptr;
};

/// One file's declarations, and the memory of all its nodes.
class Ast {
public:
  template <typename T, typename... Args>
  T *make(Args &&...args) {
    static_assert(std::is_trivially_destructible_v<T>);
    return new (arena.Allocate<T>()) T{std::forward<Args>(args)...};
  }
  template <typename T>
  llvm::MutableArrayRef<T> copy(ArrayRef<T> values) {
    T *data = arena.Allocate<T>(values.size());
    std::uninitialized_copy(values.begin(), values.end(), data);
    return {data, values.size()};
  }
  StringRef save(const llvm::Twine &text) { return saver.save(text); }

  std::vector<FunctionDecl *> functions; ///< in order of their appearance
  std::vector<ShaderDecl *> shaders;
  /// Functions and shaders as they stand in the file, since a function sees only earlier ones.
  struct Item {
    FunctionDecl *function = nullptr;
    ShaderDecl *shader = nullptr;
    StructDecl *structure = nullptr;
  };
  std::vector<Item> items;
  size_t firstOwnItem = 0; ///< those before it are built-ins
  bool hasClasses() const {
    return llvm::any_of(items,
                        [](const Item &item) { return item.structure && item.structure->isClass; });
  }

private:
  llvm::BumpPtrAllocator arena;
  // LLVM's library fills this one; were it shared, AddressSanitizer, which knows only this
  // project's half of the allocations, would take the other half for mistakes.
  llvm::BumpPtrAllocator textArena;
  llvm::StringSaver saver{textArena};
};

} // namespace anysl::rsl

#endif
