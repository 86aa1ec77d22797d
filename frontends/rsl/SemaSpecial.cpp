//===-- frontends/rsl/SemaSpecial.cpp - built-ins with arguments of their own -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"

using namespace llvm;

namespace anysl::rsl {

Expr *Sema::checkSpecial(CallExpr &call, TypeKind hint) {
  if (call.name == "arraylength")
    return checkArrayLengthCall(call);
  if (isCoshaderCall(call.name))
    return checkCoshaderCall(call);
  if (isArrayCall(call.name))
    return checkArrayCall(call);
  if (call.name == "spline")
    return checkSpline(call, hint);
  if (call.name == "printf" || call.name == "format")
    return checkFormat(call);
  if (call.name == "concat")
    return checkConcat(call);
  if (call.name == "shadername")
    return checkShaderName(call);
  return stc::queryKindNamed(call.name) ? checkQuery(call) : nullptr;
}

/// arraylength(a) is a constant.
Expr *Sema::checkArrayLengthCall(CallExpr &call) {
  Expr *array = call.args.size() == 1 ? check(call.args[0]) : nullptr;
  if (array && array->type.isError())
    return array;
  if (!array || !array->type.isArray()) {
    diags.error(call.loc, "'arraylength' takes one array").range(call.range);
    call.type = {TypeKind::Error};
    return &call;
  }
  if (array->type.length == Type::AnyLength || array->type.isResizable) {
    // Known where the function is expanded; lowering looks at the argument.
    call.args[0] = array;
    call.form = CallForm::ArrayLength;
    call.type = {TypeKind::Float};
    return &call;
  }
  auto *number = ast.make<NumberExpr>(call.range, double(array->type.length));
  number->type = {TypeKind::Float};
  return number;
}

ArrayRef<std::pair<StringLiteral, SplineBasis>> splineBases() {
  static constexpr std::pair<StringLiteral, SplineBasis> bases[] = {
      {"catmull-rom", SplineBasis::CatmullRom},
      {"catmullrom", SplineBasis::CatmullRom},
      {"catmull-rom-spline", SplineBasis::CatmullRom},
      {"bezier", SplineBasis::Bezier},
      {"bspline", SplineBasis::BSpline},
      {"b-spline", SplineBasis::BSpline},
      {"hermite", SplineBasis::Hermite},
      {"power", SplineBasis::Power},
      {"linear", SplineBasis::Linear}};
  return bases;
}

/// spline([basis,] value, array) or spline([basis,] value, k0, k1, k2, k3, …). The type of the
/// knots is what the context wants, if they convert to it, else their own.
Expr *Sema::checkSpline(CallExpr &call, TypeKind hint) {
  call.form = CallForm::Spline;
  call.type = {TypeKind::Error};
  MutableArrayRef<Expr *> args = call.args;
  bool hasBasis = !args.empty() && probe(args[0]).is(TypeKind::String);
  if (hasBasis) {
    args[0] = check(args[0]);
    if (auto *name = dyn_cast<StringExpr>(args[0])) {
      const auto *known = llvm::find_if(
          splineBases(), [&](const auto &basis) { return basis.first == name->value; });
      if (known == splineBases().end()) {
        SmallVector<StringRef, 9> names;
        for (const auto &basis : splineBases())
          names.push_back(basis.first);
        diags
            .error(args[0]->loc,
                   "unknown basis '" + name->value.str() + "'" + didYouMean(name->value, names))
            .range(args[0]->range);
        return &call;
      }
      call.basis = known->second;
    } else {
      call.basisName = args[0];
    }
    args = args.drop_front();
    // What remains are the value and the knots.
    call.args = args;
  }
  bool isArray = args.size() == 2 && probe(args[1]).isArray();
  if (args.size() < (isArray ? 2 : 5)) {
    diags.error(call.loc, "'spline' takes a value and at least four knots, or an array of them")
        .range(call.nameRange);
    return &call;
  }
  args[0] = checkAs(args[0], {TypeKind::Float, true}, "the value for 'spline'");
  bool varying = args[0]->type.varying, bad = args[0]->type.isError();
  call.hasEffects = args[0]->hasEffects;
  if (call.basisName) {
    varying |= call.basisName->type.varying;
    bad |= call.basisName->type.isError();
    call.hasEffects |= call.basisName->hasEffects;
  }
  TypeKind kind = probe(args[1]).kind;
  if (isArray) {
    args[1] = check(args[1]);
    varying |= args[1]->type.varying;
    if (!args[1]->type.isResizable && args[1]->type.length != Type::AnyLength &&
        args[1]->type.length < 4) {
      diags.error(args[1]->loc, "a spline needs at least four knots").range(args[1]->range);
      bad = true;
    }
  } else {
    bool fits = Type{hint}.isTriple() || hint == TypeKind::Float;
    for (Expr *knot : args.drop_front()) {
      Type type = probe(knot);
      fits &= type.isError() || conversionCost(type, {hint}) >= 0;
      // Among knots of several types the triple wins.
      if (!Type{kind}.isTriple() && !type.isError())
        kind = type.kind;
    }
    if (fits)
      kind = hint;
    else if (kind == TypeKind::Error)
      kind = TypeKind::Float;
    for (Expr *&knot : args.drop_front()) {
      knot = checkAs(knot, {kind, true}, "a knot of 'spline'");
      varying |= knot->type.varying;
      bad |= knot->type.isError();
      call.hasEffects |= knot->hasEffects;
    }
  }
  if (!bad && kind != TypeKind::Float && !Type{kind}.isTriple()) {
    diags.error(args[1]->loc, "the knots of a spline cannot be of type '" + nameOf(kind) + "'")
        .range(args[1]->range);
    bad = true;
  }
  call.type = {bad ? TypeKind::Error : kind, varying};
  return &call;
}

} // namespace anysl::rsl
