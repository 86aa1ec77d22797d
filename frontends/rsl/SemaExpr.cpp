//===-- frontends/rsl/SemaExpr.cpp - types of expressions -------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

#include "llvm/ADT/StringExtras.h"
#include <cmath>

using namespace llvm;

namespace anysl::rsl {

/// Something that differs from point to point is named: what the function gives differs too.
void Sema::useVarying() {
  if (function)
    function->isVarying = true;
}

Expr *Sema::check(Expr *expr, TypeKind hint) {
  switch (expr->kind) {
  case ExprKind::Number:
    expr->type = {TypeKind::Float};
    return expr;
  case ExprKind::String:
    if (!expr->type.is(TypeKind::Shader)) // null
      expr->type = {TypeKind::String};
    return expr;
  case ExprKind::Name:
    return checkName(*cast<NameExpr>(expr));
  case ExprKind::Index:
    return checkIndex(*cast<IndexExpr>(expr));
  case ExprKind::Member:
    return checkMember(*cast<MemberExpr>(expr), hint);
  case ExprKind::Negate:
    return checkNegate(*cast<NegateExpr>(expr), hint);
  case ExprKind::Not: {
    auto *inversion = cast<NotExpr>(expr);
    inversion->operand = checkCondition(inversion->operand);
    inversion->type = {TypeKind::Bool, inversion->operand->type.varying};
    inversion->hasEffects = inversion->operand->hasEffects;
    return inversion;
  }
  case ExprKind::Binary: {
    auto *binary = cast<BinaryExpr>(expr);
    if (binary->op == BinaryOp::Dot)
      if (Expr *member = dotAsMember(*binary))
        return check(member, hint);
    return isComparison(binary->op) ? checkComparison(*binary) : checkBinary(*binary, hint);
  }
  case ExprKind::Conditional:
    return checkConditional(*cast<ConditionalExpr>(expr), hint);
  case ExprKind::Assign:
    return checkAssign(*cast<AssignExpr>(expr));
  case ExprKind::Tuple:
    return checkTuple(*cast<TupleExpr>(expr), hint);
  case ExprKind::Cast:
    return checkCast(*cast<CastExpr>(expr));
  case ExprKind::Call:
    return checkCall(*cast<CallExpr>(expr), hint);
  case ExprKind::List:
    diags.error(expr->loc, "{…} is only the value of an array that is being declared")
        .range(expr->range);
    for (Expr *element : cast<ListExpr>(expr)->elements)
      check(element);
    return failed(expr);
  case ExprKind::Comma: {
    auto *list = cast<CommaExpr>(expr);
    for (Expr *&element : list->elements) {
      element = check(element);
      list->hasEffects |= element->hasEffects;
    }
    list->type = list->elements.back()->type;
    return list;
  }
  case ExprKind::Opaque:
    return expr;
  }
  llvm_unreachable("unknown expression");
}

Expr *Sema::checkName(NameExpr &name) {
  FunctionDecl *owner = nullptr;
  VarDecl *decl = lookup(name.name, &owner);
  if (!decl) {
    if (name.name == "PI") {
      auto *number = ast.make<NumberExpr>(name.range, M_PI);
      number->type = {TypeKind::Float};
      return number;
    }
    if (name.name == "null") {
      auto *none = ast.make<StringExpr>(name.range, "");
      none->type = {TypeKind::Shader};
      return none;
    }
    bool isTruth = name.name == "true" || name.name == "false";
    auto error = diags.error(
        name.loc,
        isTruth ? "RSL has no '" + name.name + "'; write " + (name.name == "true" ? "1" : "0")
                : ("unknown variable '" + name.name + "'" + didYouMean(name.name, visibleNames()))
                      .str());
    error.range(name.range);
    if (isTruth) {
      error.fixit(name.range, name.name == "true" ? "1" : "0");
    } else if (std::optional<StringRef> likely = suggest(name.name, visibleNames())) {
      error.fixit(name.range, *likely);
      if (VarDecl *meant = lookup(*likely); meant && meant->range.isValid())
        error.note(meant->range.Start, "'" + *likely + "' is declared here", meant->range);
    }
    declareUnknown(name.name, name.range);
    return failed(&name);
  }
  decl->isRead = true;
  name.decl = decl;
  name.type = decl->type;
  if (function && decl->owner != function) {
    function->usesOuter = true;
    if (decl->type.varying)
      useVarying();
  }
  if (decl->kind == VarKind::Global && shader && !function && !illuminances &&
      (decl->name == "L" || decl->name == "Cl" || decl->name == "Ol") &&
      shader->type != ShaderType::Light)
    diags.error(name.loc, "'" + name.name + "' exists only inside of 'illuminance'")
        .range(name.range);
  return &name;
}

Expr *Sema::checkIndex(IndexExpr &index) {
  index.base = check(index.base);
  index.index = checkAs(index.index, {TypeKind::Float, true}, "an index");
  // What a function gives stands in a variable, behind the call.
  SmallVector<Expr *, 2> steps;
  if (index.base->type.isArray())
    index.base = splitSteps(index.base, steps);
  index.hasEffects = index.base->hasEffects || index.index->hasEffects;
  Type base = index.base->type;
  if (base.isError() || index.index->type.isError())
    return failed(&index);
  index.type = base.element();
  if (base.isArray()) {
    if (std::optional<double> value = constant(index.index);
        value && base.length > 0 && (*value < 0 || *value >= base.length)) {
      diags
          .error(index.index->loc,
                 base.isResizable
                     ? "index outside of the array's capacity, which is so far " +
                           Twine(base.length) + "; reserve(…) raises it"
                     : "index outside of the array, which has " + Twine(base.length) + " elements")
          .range(index.index->range);
      return failed(&index);
    }
  } else if (base.isTriple()) {
    index.type.kind = TypeKind::Float;
    if (std::optional<double> value = constant(index.index); value && (*value < 0 || *value >= 3)) {
      diags.error(index.index->loc, "a '" + toString(base) + "' has the components 0, 1 and 2")
          .range(index.index->range);
      return failed(&index);
    }
  } else {
    diags.error(index.loc, "a value of type '" + toString(base) + "' has no elements")
        .range(index.base->range);
    return failed(&index);
  }
  index.type.varying |= index.index->type.varying;
  return sequence(steps, &index, index.range);
}

Expr *Sema::checkNegate(NegateExpr &negate, TypeKind hint) {
  negate.operand = check(negate.operand, hint);
  if (negate.operand->type.is(TypeKind::Bool))
    negate.operand = convert(negate.operand, {TypeKind::Float}, "negating");
  negate.hasEffects = negate.operand->hasEffects;
  negate.type = negate.operand->type;
  if (negate.type.isError())
    return &negate;
  if (!negate.type.isNumeric()) {
    diags.error(negate.loc, "a value of type '" + toString(negate.type) + "' cannot be negated")
        .range(negate.operand->range);
    return failed(&negate);
  }
  return &negate;
}

TypeKind combinedKind(BinaryOp op, Type left, Type right) {
  if (left.is(TypeKind::Bool))
    left.kind = TypeKind::Float;
  if (right.is(TypeKind::Bool))
    right.kind = TypeKind::Float;
  if (left.isArray() || right.isArray() || !left.isNumeric() || !right.isNumeric())
    return TypeKind::Error;
  if (left.kind == right.kind) {
    // The difference of two positions is a direction.
    bool isDifference = op == BinaryOp::Subtract && left.is(TypeKind::Point);
    return isDifference ? TypeKind::Vector : left.kind;
  }
  if (left.is(TypeKind::Float))
    return right.kind;
  if (right.is(TypeKind::Float))
    return left.kind;
  if (left.is(TypeKind::Matrix) || right.is(TypeKind::Matrix))
    return TypeKind::Error;
  if (left.is(TypeKind::Color) || right.is(TypeKind::Color))
    return TypeKind::Color;
  if (left.is(TypeKind::Point) || right.is(TypeKind::Point))
    return TypeKind::Point;
  return TypeKind::Vector;
}

/// Cs.r and P.x of other languages.
bool Sema::reportMember(BinaryExpr &dot) {
  auto *name = dyn_cast<NameExpr>(dot.right);
  if (dot.op != BinaryOp::Dot || !name || !dot.left->type.isTriple() || lookup(name->name))
    return false;
  size_t component = StringRef("xyzrgb").find(name->name);
  if (component == StringRef::npos)
    return false;
  std::string index = "[" + std::to_string(component % 3) + "]";
  diags.error(name->loc, "RSL has no '." + name->name + "'; write " + index)
      .range(name->range)
      .fixit({dot.loc, name->range.End}, index);
  return true;
}

Expr *Sema::checkBinary(BinaryExpr &binary, TypeKind hint) {
  if (isLogical(binary.op)) {
    binary.left = checkCondition(binary.left);
    binary.right = checkCondition(binary.right);
    binary.type = {TypeKind::Bool, binary.left->type.varying || binary.right->type.varying};
    binary.hasEffects = binary.left->hasEffects || binary.right->hasEffects;
    return &binary;
  }
  std::string what = ("the operand of '" + spelling(binary.op) + "'").str();
  if (binary.op == BinaryOp::Dot || binary.op == BinaryOp::Cross) {
    // Colors have no directions, but shaders multiply them so.
    auto vectorOperand = [&](Expr *operand) {
      operand = check(operand, TypeKind::Vector);
      if (operand->type.is(TypeKind::Float)) {
        diags.error(operand->loc, what + " must be a vector, not 'float'").range(operand->range);
        return failed(operand);
      }
      return operand->type.isGeometric() ? operand
                                         : convert(operand, {TypeKind::Vector, true}, what);
    };
    binary.left = vectorOperand(binary.left);
    if (reportMember(binary))
      return failed(&binary);
    binary.right = vectorOperand(binary.right);
    binary.type = {binary.op == BinaryOp::Dot ? TypeKind::Float : TypeKind::Vector,
                   binary.left->type.varying || binary.right->type.varying};
    binary.hasEffects = binary.left->hasEffects || binary.right->hasEffects;
    if (binary.left->type.isError() || binary.right->type.isError())
      return failed(&binary);
    return &binary;
  }
  // An operand that depends on its context takes the other's type, or that of the whole.
  Type left = probe(binary.left), right = probe(binary.right);
  auto hintFor = [&](Type other) {
    return other.isTriple() || other.is(TypeKind::Matrix) ? other.kind : hint;
  };
  bool rightFirst = left.isError() && !right.isError();
  if (rightFirst) {
    binary.right = check(binary.right, hint);
    binary.left = check(binary.left, hintFor(binary.right->type));
  } else {
    binary.left = check(binary.left, hint);
    binary.right = check(binary.right, hintFor(binary.left->type));
  }
  binary.hasEffects = binary.left->hasEffects || binary.right->hasEffects;
  if (binary.left->type.isError() || binary.right->type.isError())
    return failed(&binary);
  TypeKind kind = combinedKind(binary.op, binary.left->type, binary.right->type);
  if (kind == TypeKind::Error) {
    diags
        .error(binary.loc, "'" + spelling(binary.op) + "' does not take '" +
                               toString(binary.left->type) + "' and '" +
                               toString(binary.right->type) + "'")
        .range(binary.left->range)
        .range(binary.right->range);
    return failed(&binary);
  }
  bool varying = binary.left->type.varying || binary.right->type.varying;
  // Multiplication by a number stays one operator; everything else has two operands of one type.
  TypeKind operand = kind == TypeKind::Vector && binary.op == BinaryOp::Subtract &&
                             binary.left->type.is(TypeKind::Point)
                         ? TypeKind::Point
                         : kind;
  auto convertOperand = [&](Expr *side, bool isRight) {
    if (side->type.is(TypeKind::Bool))
      side = convert(side, {TypeKind::Float, side->type.varying}, what);
    bool isScale = kind != TypeKind::Float && side->type.is(TypeKind::Float) &&
                   (binary.op == BinaryOp::Multiply ||
                    (binary.op == BinaryOp::Divide && kind == TypeKind::Matrix && isRight));
    return isScale ? side : convert(side, {operand, side->type.varying}, what);
  };
  binary.left = convertOperand(binary.left, false);
  binary.right = convertOperand(binary.right, true);
  binary.type = {kind, varying};
  return &binary;
}

/// Arrays of the same elements are equal or not as a whole, if they can be of one length.
static bool canCompareArrays(Type a, Type b) {
  if (!a.isArray() || !b.isArray() || a.structure || b.structure)
    return false;
  bool same = a.kind == b.kind || (a.element().isGeometric() && b.element().isGeometric());
  return same && (a.length == b.length || a.isResizable || b.isResizable);
}

Expr *Sema::checkComparison(BinaryExpr &binary) {
  Type left = probe(binary.left), right = probe(binary.right);
  auto hintFor = [](Type other) { return other.isArray() ? TypeKind::Error : other.kind; };
  if (left.isError() && !right.isError()) {
    binary.right = check(binary.right);
    binary.left = check(binary.left, hintFor(binary.right->type));
  } else {
    binary.left = check(binary.left);
    binary.right = check(binary.right, hintFor(binary.left->type));
  }
  binary.hasEffects = binary.left->hasEffects || binary.right->hasEffects;
  Type a = binary.left->type, b = binary.right->type;
  if (a.isError() || b.isError())
    return failed(&binary);
  bool isEquality = binary.op == BinaryOp::Equal || binary.op == BinaryOp::NotEqual;
  bool isText = a.is(TypeKind::String) || a.is(TypeKind::Shader);
  if (isEquality && canCompareArrays(a, b)) {
    binary.type = {TypeKind::Bool, a.varying || b.varying};
    return &binary;
  }
  TypeKind kind = isText && b.is(a.kind) ? a.kind : combinedKind(BinaryOp::Add, a, b);
  if (kind == TypeKind::Error || (!isEquality && kind != TypeKind::Float)) {
    auto error = diags.error(binary.loc, "'" + spelling(binary.op) + "' does not compare '" +
                                             toString(a) + "' and '" + toString(b) + "'");
    error.range(binary.left->range).range(binary.right->range);
    return failed(&binary);
  }
  binary.left = convert(binary.left, {kind, a.varying}, "a comparison");
  binary.right = convert(binary.right, {kind, b.varying}, "a comparison");
  binary.type = {TypeKind::Bool, a.varying || b.varying};
  return &binary;
}

/// A condition: a comparison, or a number that is not 0.
Expr *Sema::checkCondition(Expr *expr) {
  auto *assign = dyn_cast<AssignExpr>(expr);
  expr = check(expr, TypeKind::Float);
  if (assign && !assign->isCompound)
    diags
        .warning(assign->loc, warn::Parentheses, "an assignment as a condition; did you mean '=='?")
        .range(assign->range)
        .fixit({assign->loc, SMLoc::getFromPointer(assign->loc.getPointer() + 1)}, "==");
  if (expr->type.isError() || expr->type.is(TypeKind::Bool))
    return expr;
  if (!expr->type.is(TypeKind::Float)) {
    diags
        .error(expr->loc,
               "a condition must be a comparison or a float, not '" + toString(expr->type) + "'")
        .range(expr->range);
    return failed(expr);
  }
  auto *truth = ast.make<CastExpr>(Type{TypeKind::Bool, expr->type.varying}, expr);
  truth->depth = expr->depth + 1;
  return truth;
}

Expr *Sema::checkConditional(ConditionalExpr &conditional, TypeKind hint) {
  Type whenTrue = probe(conditional.whenTrue), whenFalse = probe(conditional.whenFalse);
  conditional.condition = checkCondition(conditional.condition);
  auto hintFor = [&](Type other) {
    return other.isError() || other.isArray() || other.is(TypeKind::Float) ? hint : other.kind;
  };
  conditional.whenTrue = check(conditional.whenTrue, hintFor(whenFalse));
  conditional.whenFalse = check(conditional.whenFalse, hintFor(whenTrue));
  Type a = conditional.whenTrue->type, b = conditional.whenFalse->type;
  conditional.hasEffects = conditional.condition->hasEffects || conditional.whenTrue->hasEffects ||
                           conditional.whenFalse->hasEffects;
  if (a.isError() || b.isError() || conditional.condition->type.isError())
    return failed(&conditional);
  bool isWhole = a.structure || a.isArray();
  if (isWhole && conversionCost(a, b) == 0 && a.length == b.length && !a.isResizable)
    return chooseWhole(conditional);
  bool isText = a.is(TypeKind::String) || a.is(TypeKind::Shader);
  TypeKind kind = isText && b.is(a.kind) ? a.kind
                  : a.is(TypeKind::Bool) && b.is(TypeKind::Bool)
                      ? TypeKind::Float
                      : combinedKind(BinaryOp::Add, a, b);
  if (kind == TypeKind::Error) {
    diags
        .error(conditional.loc, "the two values of '?:' are of types '" + toString(a) + "' and '" +
                                    toString(b) + "'")
        .range(conditional.whenTrue->range)
        .range(conditional.whenFalse->range);
    return failed(&conditional);
  }
  conditional.whenTrue = convert(conditional.whenTrue, {kind, a.varying}, "a value of '?:'");
  conditional.whenFalse = convert(conditional.whenFalse, {kind, b.varying}, "a value of '?:'");
  conditional.type = {kind, a.varying || b.varying || conditional.condition->type.varying};
  return &conditional;
}

/// Of structures and arrays each side assigns to the variable that is the result.
Expr *Sema::chooseWhole(ConditionalExpr &conditional) {
  Type type = conditional.whenTrue->type.withVarying(true);
  SMLoc loc = conditional.loc;
  NameExpr *result = hiddenVariable(type, conditional.range);
  for (Expr **side : {&conditional.whenTrue, &conditional.whenFalse}) {
    SMRange range = (*side)->range;
    SmallVector<Expr *, 2> steps;
    Expr *value = splitSteps(*side, steps);
    steps.push_back(type.structure ? assignStruct(result, value, loc, range)
                                   : assignment(result, value, loc));
    auto *none = ast.make<NumberExpr>(range, 0.0);
    none->type = {TypeKind::Float};
    *side = sequence(steps, none, range);
  }
  conditional.type = {TypeKind::Float, true};
  conditional.hasEffects = true;
  return sequence(&conditional, result, conditional.range);
}

Expr *Sema::checkTuple(TupleExpr &tuple, TypeKind hint) {
  size_t size = tuple.elements.size();
  bool varying = false, bad = false;
  auto elements = ast.copy<Expr *>(tuple.elements);
  for (Expr *&element : elements) {
    element = checkAs(element, {TypeKind::Float, true}, "a component");
    varying |= element->type.varying;
    tuple.hasEffects |= element->hasEffects;
    bad |= element->type.isError();
  }
  tuple.elements = elements;
  if (size != 3 && size != 16) {
    diags.error(tuple.loc, "a triple has 3 values and a matrix 16, not " + Twine(size))
        .range(tuple.range);
    return failed(&tuple);
  }
  TypeKind kind = size == 16 ? TypeKind::Matrix : Type{hint}.isTriple() ? hint : TypeKind::Point;
  tuple.type = {kind, varying};
  return bad ? failed(&tuple) : &tuple;
}

/// Warns of constant text that names no colour space of the shading library.
void Sema::checkColorSpace(const Expr &space) {
  static constexpr StringLiteral known[] = {"rgb", "hsv", "hsl", "yiq", "YIQ", "xyz", "XYZ", "xyY"};
  auto *name = dyn_cast<StringExpr>(&space);
  if (name && !is_contained(known, name->value))
    diags
        .warning(space.loc, warn::ColorSpace,
                 "unknown colour space \"" + name->value + "\"; it counts as \"rgb\"" +
                     didYouMean(name->value, {std::begin(known), std::end(known)}))
        .range(space.range);
}

Expr *Sema::checkCast(CastExpr &cast) {
  cast.operand = check(cast.operand, cast.to);
  cast.hasEffects = cast.operand->hasEffects;
  Type from = cast.operand->type;
  if (from.isError())
    return failed(&cast);
  cast.type = {cast.to, from.varying};
  if (cast.space) {
    cast.space = check(cast.space);
    if (!cast.type.isTriple() && cast.to != TypeKind::Matrix) {
      diags.error(cast.loc, "a '" + nameOf(cast.to) + "' is in no coordinate system")
          .range(cast.space->range);
      return failed(&cast);
    }
    if (cast.to == TypeKind::Color)
      checkColorSpace(*cast.space);
  }
  if (conversionCost(from, cast.type) < 0) {
    diags
        .error(cast.loc, "a value of type '" + toString(from) + "' cannot be converted to '" +
                             nameOf(cast.to) + "'")
        .range(cast.operand->range);
    return failed(&cast);
  }
  cast.operand = convert(cast.operand, {cast.to, from.varying}, "a conversion");
  return &cast;
}

Expr *Sema::checkList(ListExpr &list, Type wanted) {
  for (Expr *&element : list.elements) {
    element = checkAs(element, wanted.element(), "an element");
    list.hasEffects |= element->hasEffects;
    list.type.varying |= element->type.varying;
  }
  if (static_cast<int>(list.elements.size()) > wanted.length)
    diags
        .error(list.loc,
               Twine(list.elements.size()) + " values for an array of " + Twine(wanted.length))
        .range(list.range);
  list.type.kind = wanted.kind;
  list.type.length = wanted.length;
  return &list;
}

//===-- Assignment ------------------------------------------------------------------------------//

/// Checks that `target` may be assigned, and notes that it is. `how` begins a message.
void Sema::checkTarget(Expr *target, bool valueVaries, SMLoc loc, StringRef how) {
  Expr *base = target;
  bool indexVaries = false;
  while (auto *index = dyn_cast<IndexExpr>(base)) {
    indexVaries |= index->index->type.varying;
    base = index->base;
  }
  auto *name = dyn_cast<NameExpr>(base);
  if (!name || !name->decl) {
    if (!base->type.isError())
      diags
          .error(loc, how + (how.starts_with("'=") || how.starts_with("a compound")
                                 ? " needs a variable to its left"
                                 : " must be a variable"))
          .range(target->range);
    return;
  }
  VarDecl &decl = *name->decl;
  decl.isAssigned = true;
  if (function && structure && structure->isClass && decl.owner != function)
    function->assignsMembers = true;
  if (function && decl.owner != function && decl.type.varying)
    useVarying();
  if (decl.kind == VarKind::FunctionParam && !decl.isOutput && decl.owner == function) {
    decl.isCopied = true;
    diags
        .warning(loc, warn::ParamAssigned,
                 "parameter '" + decl.name +
                     "' is not 'output'; the assignment changes the function's own copy")
        .range(target->range)
        .note(decl.range.Start, "declared here", decl.range);
  }
  if (decl.kind == VarKind::Global && (shader || structure)) {
    static constexpr StringLiteral results[] = {"Ci", "Oi"};
    bool writesLight =
        shader && (shader->type == ShaderType::Displacement || shader->type == ShaderType::Light);
    if (llvm::is_contained(results, decl.name) && writesLight) {
      diags.error(loc, "a " + nameOf(shader->type) + " shader has no '" + decl.name + "'")
          .range(target->range);
      return;
    }
    if (decl.isReadOnly && !illuminances)
      diags
          .warning(loc, warn::ReadOnlyGlobal,
                   "'" + decl.name + "' is read-only; the assignment changes the shader's own copy")
          .range(target->range);
  }
  if (!decl.type.varying && decl.kind == VarKind::Local && !decl.isHidden &&
      varyingConditions.size() > decl.branches) {
    const Expr *condition = varyingConditions.back();
    diags
        .warning(loc, warn::VaryingBranch,
                 "uniform '" + decl.name + "' is assigned where a varying condition decides")
        .range(target->range)
        .note(condition->loc, "the condition", condition->range);
  }
  if (!decl.type.varying && (valueVaries || indexVaries)) {
    auto error =
        diags.error(loc, "a varying value cannot be assigned to uniform '" + decl.name + "'");
    error.range(target->range);
    if (decl.range.isValid())
      error.note(decl.range.Start,
                 decl.kind == VarKind::ShaderParam && !decl.hasStorage
                     ? "parameters of shaders are uniform unless declared 'varying'"
                     : "declared here",
                 decl.range);
  }
}

Expr *Sema::checkAssign(AssignExpr &assign) {
  // A variable that is only assigned has not been read.
  VarDecl *assigned = nullptr;
  if (auto *name = dyn_cast<NameExpr>(assign.target))
    assigned = lookup(name->name);
  else if (auto *index = dyn_cast<IndexExpr>(assign.target))
    if (auto *base = dyn_cast<NameExpr>(index->base))
      assigned = lookup(base->name);
  bool wasRead = assigned && assigned->isRead;
  assign.target = check(assign.target);
  if (assigned && !assign.isCompound)
    assigned->isRead = wasRead;
  Type target = assign.target->type;
  assign.hasEffects = true;
  std::string what = assigned ? ("assigning to '" + assigned->name + "'").str() : "assigning";
  if (target.isError()) {
    check(assign.value);
    return failed(&assign);
  }
  if (assign.isCompound) {
    assign.old = ast.make<OpaqueExpr>(assign.target);
    assign.old->type = target;
    assign.old->probed = target;
    assign.old->isProbed = true;
    auto *operation =
        ast.make<BinaryExpr>(assign.loc, assign.range, assign.op, assign.old, assign.value);
    operation->depth = assign.depth;
    assign.value = operation;
  }
  if (target.structure && !assign.isCompound) {
    assign.value = checkWhole(assign.value, target, what);
    if (assign.value->type.isError())
      return failed(&assign);
    return assignStruct(assign.target, assign.value, assign.loc, assign.range);
  }
  if (target.isArray()) {
    assign.value = checkWhole(assign.value, target, what);
    raiseCapacityFor(assign.target, assign.value->type);
  } else {
    assign.value = checkAs(assign.value, target, what);
  }
  checkTarget(assign.target, assign.value->type.varying, assign.loc,
              assign.isCompound ? "a compound assignment" : "'='");
  assign.type = target;
  return assign.value->type.isError() ? failed(&assign) : &assign;
}

//===-- Conversions -----------------------------------------------------------------------------//

Expr *Sema::checkAs(Expr *expr, Type to, const Twine &what) {
  std::string text = what.str();
  if (to.isArray() || to.structure)
    return checkWhole(expr, to, text);
  return convert(check(expr, to.kind), to, text);
}

/// The same for an array or a structure: {…} is one too, and what another shader gives is what is
/// wanted of it.
Expr *Sema::checkWhole(Expr *expr, Type to, const Twine &what) {
  std::string text = what.str();
  if (auto *list = dyn_cast<ListExpr>(expr); list && to.isArray() && !to.structure) {
    if (to.isResizable || to.length == Type::AnyLength)
      to.length = std::max<int>(1, int(list->elements.size()));
    return checkList(*list, to);
  }
  if (auto *call = dyn_cast<CallExpr>(expr))
    call->wanted = to;
  else if (auto *member = dyn_cast<MemberExpr>(expr))
    member->wanted = to;
  return convert(check(expr), to, text);
}

/// The value as one of another type, with the storage class that it has.
Expr *Sema::convert(Expr *expr, Type to, const Twine &what) {
  Type from = expr->type;
  if (from.isError() || to.isError())
    return expr;
  if (conversionCost(from, to) < 0) {
    auto error = diags.error(expr->loc, what + ": a value of type '" + toString(from) +
                                            "' is no '" + toString(to) + "'");
    error.range(expr->range);
    if (from.isTriple() && to.is(TypeKind::Float))
      error.note(expr->loc, "comp(…, 0) takes one component");
    return failed(expr);
  }
  if (from.kind == to.kind)
    return expr;
  auto *cast = ast.make<CastExpr>(to.withVarying(from.varying), expr);
  cast->depth = expr->depth + 1;
  return cast;
}

/// Reports a varying value that is to become uniform; true if all is well.
bool Sema::checkStorage(const Expr *value, bool targetVaries, const Twine &what) {
  if (targetVaries || !value->type.varying || value->type.isError())
    return true;
  diags.error(value->loc, what + ": the value is varying").range(value->range);
  return false;
}

std::optional<double> Sema::constant(const Expr *expr) {
  if (auto *number = dyn_cast<NumberExpr>(expr))
    return number->value;
  if (auto *negate = dyn_cast<NegateExpr>(expr)) {
    std::optional<double> value = constant(negate->operand);
    return value ? std::optional(-*value) : std::nullopt;
  }
  if (auto *cast = dyn_cast<CastExpr>(expr))
    return cast->to == TypeKind::Float && !cast->space ? constant(cast->operand) : std::nullopt;
  auto *binary = dyn_cast<BinaryExpr>(expr);
  if (!binary || !binary->type.is(TypeKind::Float))
    return std::nullopt;
  std::optional<double> left = constant(binary->left), right = constant(binary->right);
  if (!left || !right)
    return std::nullopt;
  switch (binary->op) {
  case BinaryOp::Add:
    return *left + *right;
  case BinaryOp::Subtract:
    return *left - *right;
  case BinaryOp::Multiply:
    return *left * *right;
  case BinaryOp::Divide:
    return *left / *right;
  default:
    return std::nullopt;
  }
}

} // namespace anysl::rsl
