//===-- frontends/rsl/LowerCoshader.cpp - shaders that call each other ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"
#include "frontends/rsl/Sema.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

namespace {
/// Where a number lies among those that are handed over.
struct Position {
  unsigned matrix, row, column;
  explicit Position(unsigned i) : matrix(i / 16), row(i % 16 / 4), column(i % 4) {}
};
} // namespace

/// Writes a value's components behind each other, from number `at` on; gives the next number.
unsigned Lowering::packNumbers(Value *value, Type type, ArrayRef<Value *> matrices, unsigned at) {
  for (unsigned i = 0, count = componentsOf(type); i < count; ++i, ++at) {
    Position to(at);
    Value *component = value;
    if (count > 1) {
      component = temporary({TypeKind::Float, true});
      if (type.is(TypeKind::Matrix))
        b.call(Op::get_matrix, {component, value, number(i / 4), number(i % 4)});
      else
        b.call(opFor(type.kind, Op::get_color, Op::get_color, Op::get_vector),
               {component, value, number(i)});
    }
    b.call(Op::set_matrix, {matrices[to.matrix], number(to.row), number(to.column), component});
  }
  return at;
}

/// The value of a type whose components lie from number `at` on.
Value *Lowering::unpackNumbers(Type type, ArrayRef<Value *> matrices, unsigned at) {
  SmallVector<Value *, 17> operands{nullptr};
  for (unsigned i = 0, count = componentsOf(type); i < count; ++i) {
    Position from(at + i);
    operands.push_back(temporary({TypeKind::Float, true}));
    b.call(Op::get_matrix,
           {operands.back(), matrices[from.matrix], number(from.row), number(from.column)});
  }
  if (type.is(TypeKind::Float))
    return operands[1];
  operands[0] = temporary(type);
  b.call(type.is(TypeKind::Matrix)
             ? Op::make_matrix
             : opFor(type.kind, Op::make_color, Op::make_color, Op::make_vector),
         operands);
  return operands[0];
}

Value *Lowering::callCoshader(const CallExpr &call) {
  switch (call.coshaderOp) {
  case CoshaderOp::Get:
    return getShader(call);
  case CoshaderOp::GetAll:
  case CoshaderOp::GetLights:
    return getShaders(call);
  case CoshaderOp::Variable:
  case CoshaderOp::Member:
  case CoshaderOp::Method:
    return callMethod(call);
  }
  llvm_unreachable("unknown use of another shader");
}

/// The name if there is such a shader, else "".
Value *Lowering::getShader(const CallExpr &call) {
  Value *name = lower(call.args[0]);
  at(call.loc);
  Type type{TypeKind::Shader, true};
  Value *result = zero(type);
  if (!hasContext(call.loc))
    return result;
  BasicBlock *known = b.block("shader.known"), *end = b.block("shader.end");
  Value *none = zero({TypeKind::Matrix, true}), *more = zero({TypeKind::Matrix, true});
  branchIf(b.call(Op::call_method, {b.context(), name, text(""), none, more}), known, end);
  continueIn(known);
  copy(type, result, name);
  branchTo(end);
  continueIn(end);
  return result;
}

/// All shaders of a category, as many as the array has room for.
Value *Lowering::getShaders(const CallExpr &call) {
  Value *category = call.args.size() == 2 ? lower(call.args[1]) : text("");
  at(call.loc);
  Value *result = temporary(call.type);
  Value *count = lengths.lookup(result);
  b.call(Op::const_float, {count, b.number(0)});
  if (call.coshaderOp == CoshaderOp::GetLights || !hasContext(call.loc))
    return result;
  BasicBlock *head = b.block("shaders"), *found = b.block("shader.found"),
             *end = b.block("shaders.end");
  branchTo(head);
  continueIn(head);
  Value *name = temporary({TypeKind::String, true});
  Value *index = b.call(Op::index, {count});
  Value *exists = b.call(Op::shader_name, {name, b.context(), category, index});
  Value *hasRoom = b.call(Op::lt_float, {count, number(capacityOf(result))});
  branchIf(builder().CreateAnd(exists, hasRoom), found, end);
  continueIn(found);
  copy({TypeKind::String}, b.element(result, b.call(Op::index, {count})), name);
  Value *grown = temporary({TypeKind::Float, true});
  b.call(Op::add_float, {grown, count, number(1)});
  copy({TypeKind::Float}, count, grown);
  branchTo(head);
  continueIn(end);
  return result;
}

/// A method or a parameter of another shader. Where there is none, results are 0 and variables stay
/// as they are.
Value *Lowering::callMethod(const CallExpr &call) {
  bool isVariable = call.coshaderOp == CoshaderOp::Variable;
  bool isMethod = call.coshaderOp == CoshaderOp::Method;
  if (!isVariable && call.remoteName.empty()) { // refused, with a warning
    for (const Expr *arg : call.args)
      if (arg->hasEffects)
        lower(arg);
    at(call.loc);
    return call.type.is(TypeKind::Void) ? nullptr : zero(call.type);
  }
  Value *handle = lowerBefore(isVariable ? call.args[0] : call.object, true);
  Value *method;
  if (isVariable) {
    // The dot makes it a parameter's name.
    auto *name = dyn_cast<StringExpr>(call.args[1]);
    method = name ? text(("." + name->value).str()) : lower(call.args[1]);
  } else {
    method = text(call.remoteName);
  }
  Value *matrices[] = {zero({TypeKind::Matrix, true}), zero({TypeKind::Matrix, true})};
  unsigned next = 0;
  SmallVector<std::pair<const Expr *, unsigned>, 8> outputs;
  if (isMethod)
    for (const Expr *arg : call.args) {
      Value *value = lower(arg);
      at(call.loc);
      if (auto *name = dyn_cast<NameExpr>(arg); name && isRemoteOutput(*name->decl))
        outputs.push_back({arg, next});
      next = packNumbers(value, arg->type, matrices, next);
    }
  if (isVariable)
    outputs.push_back({call.args[2], 0});
  at(call.loc);
  Value *result = componentsOf(call.type) ? zero(call.type) : nullptr;
  if (!hasContext(call.loc))
    return result;
  BasicBlock *done = b.block("called"), *end = b.block("called.end");
  branchIf(b.call(Op::call_method, {b.context(), handle, method, matrices[0], matrices[1]}), done,
           end);
  continueIn(done);
  for (auto [target, from] : outputs)
    store(place(target), unpackNumbers(target->type.withVarying(true), matrices, from));
  if (isVariable) {
    b.call(Op::const_float, {result, b.number(1)});
  } else if (result) {
    unsigned from = isMethod && next + componentsOf(call.type) <= 32 ? next : 0;
    copy(call.type, result, unpackNumbers(call.type, matrices, from));
  }
  branchTo(end);
  continueIn(end);
  return result;
}

} // namespace anysl::rsl
