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
  Message nothing;
  makeArrays(nothing, call.loc);
  SmallVector<Value *, 8> operands{b.context(), name, text("")};
  appendOperands(nothing, operands);
  branchIf(b.call(Op::call_method, operands), known, end);
  continueIn(known);
  copy(type, result, name);
  branchTo(end);
  continueIn(end);
  return result;
}

/// All shaders or lights of a category, as many as the array has room for.
Value *Lowering::getShaders(const CallExpr &call) {
  Value *category = call.args.size() == 2 ? lower(call.args[1]) : text("");
  at(call.loc);
  Value *result = temporary(call.type);
  Value *count = lengths.lookup(result);
  b.call(Op::const_float, {count, b.number(0)});
  if (!hasContext(call.loc))
    return result;
  bool isLights = call.coshaderOp == CoshaderOp::GetLights;
  BasicBlock *before = builder().GetInsertBlock(), *head = b.block("shaders"),
             *look = b.block("shader"), *found = b.block("shader.found"),
             *next = b.block("shader.next"), *end = b.block("shaders.end");
  Value *total = isLights ? b.call(Op::light_count, {b.context()}) : nullptr;
  branchTo(head);
  continueIn(head);
  PHINode *index = builder().CreatePHI(builder().getInt32Ty(), 2, "shader");
  index->addIncoming(b.index(0), before);
  Value *name = temporary({TypeKind::String, true});
  Value *goesOn = isLights ? builder().CreateICmpULT(index, total)
                           : b.call(Op::shader_name, {name, b.context(), category, index});
  branchIf(builder().CreateAnd(goesOn, b.call(Op::lt_float, {count, number(capacityOf(result))})),
           look, end);
  continueIn(look);
  if (isLights) {
    BasicBlock *belongs = b.block("light.belongs");
    branchIf(b.call(Op::light_in_category, {b.context(), index, category}), belongs, next);
    continueIn(belongs);
    branchIf(b.call(Op::light_handle, {name, b.context(), index}), found, next);
  } else {
    branchTo(found);
  }
  continueIn(found);
  copy({TypeKind::String}, b.element(result, b.call(Op::index, {count})), name);
  Value *grown = temporary({TypeKind::Float, true});
  b.call(Op::add_float, {grown, count, number(1)});
  copy({TypeKind::Float}, count, grown);
  branchTo(next);
  continueIn(next);
  index->addIncoming(builder().CreateAdd(index, b.index(1)), next);
  branchTo(head);
  continueIn(end);
  return result;
}

/// `.name:shape`, how a parameter is asked for.
Value *Lowering::parameterName(const Expr *name, const std::string &shape) {
  if (auto *constant = dyn_cast<StringExpr>(name))
    return text(("." + constant->value + ":" + shape).str());
  Value *value = lower(name), *begun = temporary({TypeKind::String, true}),
        *whole = temporary({TypeKind::String, true});
  at(name->loc);
  b.call(Op::append_string, {begun, b.context(), text("."), text("%s"), b.index(0), value});
  b.call(Op::append_rest, {whole, b.context(), begun, text(":" + shape), b.index(0)});
  return whole;
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
    for (const VarDecl *part : call.results)
      setZero(part->type, slotOf(*part));
    return call.type.is(TypeKind::Void) ? nullptr : zero(call.type);
  }
  Value *handle = lowerBefore(isVariable ? call.args[0] : call.object, true);
  SmallVector<Value *, 8> values;
  Message message;
  Value *what = nullptr;
  std::string shapes;
  if (isMethod)
    for (const Expr *arg : call.args) {
      values.push_back(lowerBefore(arg, true));
      shapes += addItem(message, arg->type, values.back());
    }
  at(call.loc);
  bool hasResult = !call.type.is(TypeKind::Void);
  Value *result = hasResult ? zero(call.type) : nullptr;
  if (!hasContext(call.loc))
    return result;
  Place variable;
  if (isVariable) {
    variable = place(call.args[2]);
    Type type = call.args[2]->type;
    what = parameterName(call.args[1], variable.component ? addItem(message, type, 0u)
                                                          : addItem(message, type, variable.slot));
  } else {
    std::string own = hasResult ? addItem(message, call.type, 0u) : call.results.empty() ? "v" : "";
    for (const VarDecl *part : call.results) {
      setZero(part->type, slotOf(*part));
      own += addItem(message, part->type, slotOf(*part));
    }
    what = text(isMethod ? (call.remoteName + "(" + shapes + ")" + own).str()
                         : ("." + call.remoteName + ":" + own).str());
  }
  at(call.loc);
  makeArrays(message, call.loc);
  for (unsigned i = 0; i < values.size(); ++i)
    pack(message, i, values[i]);
  BasicBlock *done = b.block("called"), *end = b.block("called.end");
  SmallVector<Value *, 8> operands{b.context(), handle, what};
  appendOperands(message, operands);
  branchIf(b.call(Op::call_method, operands), done, end);
  continueIn(done);
  if (message.items.empty()) {
    // Nothing comes back.
  } else if (isVariable) {
    store(variable, unpack(message, 0));
    b.call(Op::const_float, {result, b.number(1)});
  } else {
    if (isMethod)
      for (unsigned i = 0; i < call.args.size(); ++i)
        if (auto *name = dyn_cast<NameExpr>(call.args[i]); name && isRemoteOutput(*name->decl))
          store(place(name), unpack(message, i));
    if (result)
      copy(call.type, result, unpack(message, unsigned(message.items.size()) - 1));
    unsigned index = unsigned(message.items.size() - call.results.size());
    for (const VarDecl *part : call.results)
      copy(part->type, slotOf(*part), unpack(message, index++));
  }
  branchTo(end);
  continueIn(end);
  return result;
}

} // namespace anysl::rsl
