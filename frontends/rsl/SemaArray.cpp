//===-- frontends/rsl/SemaArray.cpp - arrays whose length changes -----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A resizable array has room for a fixed number of elements, its capacity (`Type::length`), and a
// variable that says how many of them there are. Whatever shows that more room is needed raises the
// capacity of the variable's declaration, which counts only when the tree is lowered.
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"

#include "lib/STC/Shader.h"
#include "llvm/ADT/StringSwitch.h"

using namespace llvm;

namespace anysl::rsl {

static std::optional<ArrayOp> arrayOp(StringRef name) {
  return StringSwitch<std::optional<ArrayOp>>(name)
      .Case("resize", ArrayOp::Resize)
      .Case("reserve", ArrayOp::Reserve)
      .Case("push", ArrayOp::Push)
      .Case("pop", ArrayOp::Pop)
      .Case("capacity", ArrayOp::Capacity)
      .Default(std::nullopt);
}

bool isArrayCall(StringRef name) { return arrayOp(name).has_value(); }

/// The variable that an array expression names; null if it names none.
static VarDecl *arrayVariable(Expr *array) {
  auto *name = dyn_cast<NameExpr>(array);
  return name ? name->decl : nullptr;
}

/// Sees to it that a resizable array has room for so many elements.
void Sema::raiseCapacity(Expr *array, int capacity) {
  VarDecl *decl = arrayVariable(array);
  if (!decl)
    return;
  // A function's parameter has the room of its argument, which a call sees to.
  int &room = decl->type.length == Type::AnyLength ? decl->wantedCapacity : decl->type.length;
  if (decl->type.isResizable || decl->type.length == Type::AnyLength)
    room = std::max(room, std::min<int>(capacity, stc::maxArrayLength));
}

/// An array is assigned, or handed to a function's parameter that may grow.
void Sema::raiseCapacityFor(Expr *array, Type from) {
  if (from.length > 0)
    raiseCapacity(array, from.length);
  else if (from.isArray()) // a parameter, as long as the argument that it will get
    raiseCapacity(array, options.arrayCapacity);
}

/// What stands behind the type of a function's result: `float[3] f()`, `float[] f()`.
void Sema::checkArrayResult(FunctionDecl &decl) {
  if (!decl.result.isArray())
    return;
  decl.result.isResizable = !decl.resultLength;
  if (decl.resultLength) {
    decl.resultLength = check(decl.resultLength, TypeKind::Float);
    decl.result.length = arrayLength(decl.resultLength);
  } else if (decl.result.structure) {
    diags.error(decl.range.Start, "an array of structures needs a length").range(decl.range);
    decl.result.length = 1;
    decl.result.isResizable = false;
  }
}

/// What a function returns becomes the value of a variable of its own.
Expr *Sema::checkArrayReturn(Expr *value, SMLoc loc) {
  const Type result = function->result;
  value = checkWhole(value, result, "returning from '" + function->name + "'");
  if (value->type.isError())
    return value;
  NameExpr *variable = reference(*function->resultVariable, value->range);
  raiseCapacityFor(variable, value->type);
  if (!checkStorage(value, variable->type.varying,
                    "returning from uniform function '" + function->name + "'"))
    return failed(value);
  return assignment(variable, value, loc);
}

/// Arguments for parameters whose length the function changes.
void Sema::checkResizedArguments(const CallExpr &call) {
  for (size_t i = 0; i < call.args.size(); ++i) {
    const VarDecl *param = call.function->leaves[i];
    Expr *arg = call.args[i];
    if (!param->wantedCapacity || !param->isOutput)
      continue;
    if (!arg->type.isResizable && arg->type.length != Type::AnyLength)
      diags
          .error(arg->loc, "'" + call.name + "' changes the length of its parameter '" +
                               param->name + "', and that of this array is fixed")
          .range(arg->range)
          .note(param->range.Start, "declared here", param->range);
    raiseCapacity(arg, param->wantedCapacity);
  }
}

/// resize(a, n), reserve(a, n), push(a, x), pop(a), capacity(a)
Expr *Sema::checkArrayCall(CallExpr &call) {
  ArrayOp op = *arrayOp(call.name);
  bool hasValue = op == ArrayOp::Resize || op == ArrayOp::Reserve || op == ArrayOp::Push;
  call.form = CallForm::Array;
  call.arrayOp = op;
  call.type = {TypeKind::Error};
  if (call.args.size() != (hasValue ? 2 : 1)) {
    diags
        .error(call.loc, "'" + call.name + "' takes an array" +
                             (op == ArrayOp::Push ? " and a value"
                              : hasValue          ? " and a number"
                                                  : ""))
        .range(call.nameRange);
    return &call;
  }
  Expr *array = call.args[0] = check(call.args[0]);
  Type type = array->type;
  if (type.isError())
    return &call;
  VarDecl *decl = type.isArray() ? arrayVariable(array) : nullptr;
  if (!decl) {
    diags.error(array->loc, "'" + call.name + "' needs an array, not a '" + toString(type) + "'")
        .range(array->range);
    return &call;
  }
  bool isOwn = type.isResizable || type.length == Type::AnyLength;
  if (!isOwn && op != ArrayOp::Capacity) {
    auto error = diags.error(array->loc, "the length of array '" + decl->name +
                                             "' is fixed; one declared with [] can change its");
    error.range(array->range);
    if (decl->range.isValid())
      error.note(decl->range.Start, "declared here", decl->range);
    return &call;
  }
  bool valueVaries = false;
  if (hasValue) {
    Type wanted = op == ArrayOp::Push ? type.element() : Type{TypeKind::Float, true};
    call.args[1] = checkAs(call.args[1], wanted, "argument 2 of '" + call.name + "'");
    if (call.args[1]->type.isError())
      return &call;
    valueVaries = call.args[1]->type.varying;
    std::optional<double> number = op == ArrayOp::Push ? std::nullopt : constant(call.args[1]);
    if (number && *number > stc::maxArrayLength)
      diags
          .error(call.args[1]->loc,
                 "an array has at most " + Twine(stc::maxArrayLength) + " elements")
          .range(call.args[1]->range);
    raiseCapacity(array, number ? std::max(1, int(std::min(*number, 1e6))) : options.arrayCapacity);
  }
  call.hasEffects = op != ArrayOp::Capacity;
  if (op == ArrayOp::Resize || op == ArrayOp::Push || op == ArrayOp::Pop)
    checkTarget(array, valueVaries, call.loc, ("argument 1 of '" + call.name + "'").str());
  call.type = op == ArrayOp::Pop        ? type.element()
              : op == ArrayOp::Capacity ? Type{TypeKind::Float}
                                        : Type{TypeKind::Void};
  return &call;
}

/// A shader's parameters. Where the host says how many elements there are, a parameter of its own
/// behind all others has that number.
void Sema::checkParams(ArrayRef<VarDecl *> &params) {
  std::vector<VarDecl *> all(params.begin(), params.end());
  for (VarDecl *param : params) {
    checkParam(*param);
    if (!param->type.isResizable)
      continue;
    auto *length = ast.make<VarDecl>();
    length->kind = VarKind::ShaderParam;
    length->name = ast.save(param->name + ".length");
    length->range = param->range;
    length->type = {TypeKind::Float};
    length->init = zeroOf(length->type, param->range);
    length->id = unsigned(all.size());
    param->lengthVariable = length;
    all.push_back(length);
  }
  params = ast.copy<VarDecl *>(all);
}

} // namespace anysl::rsl
