//===-- frontends/rsl/LowerQuery.cpp - questions to the renderer ------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"

#include <anysl/abi.h>

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

static Op queryOf(TypeKind kind) {
  switch (kind) {
  case TypeKind::Float:
    return Op::query_float;
  case TypeKind::Color:
    return Op::query_color;
  case TypeKind::Matrix:
    return Op::query_matrix;
  case TypeKind::String:
    return Op::query_string;
  default:
    return Op::query_vector;
  }
}

/// Asks for a value, element by element, and puts it into a variable's slot; gives whether there is
/// one, an i1.
Value *Lowering::query(const stc::QueryKind &kind, Value *subject, Value *name, Type type,
                       Value *variable) {
  Value *light = kind.name == "lightsource" ? currentLight.index : b.index(0);
  auto ask = [&](Value *slot, unsigned length, unsigned element) {
    return b.call(queryOf(type.kind), {b.context(), b.id(kind.id), light, subject, name,
                                       b.length(length), b.length(element), slot});
  };
  auto slot = stc::slotInfo(variable);
  if (!slot || !slot->arrayLength)
    return ask(variable, 0, 0);
  if (lengths.count(variable))
    return queryArray(kind, subject, name, type, variable);
  Value *known = nullptr;
  for (unsigned i = 0; i < slot->arrayLength; ++i) {
    Value *answered = ask(elementOf(variable, i), slot->arrayLength, i);
    known = known ? builder().CreateAnd(known, answered) : answered;
  }
  return known;
}

/// An array whose length the answer sets.
Value *Lowering::queryArray(const stc::QueryKind &kind, Value *subject, Value *name, Type type,
                            Value *array) {
  Message message;
  Value *shape = text(addItem(message, type, array));
  makeArrays(message, lastLocation);
  SmallVector<Value *, 10> operands{b.context(), b.id(kind.id), subject, name, shape};
  appendOperands(message, operands);
  Value *known = b.call(Op::query_array, operands);
  BasicBlock *answered = b.block("answered"), *end = b.block("answered.end");
  branchIf(known, answered, end);
  continueIn(answered);
  if (!message.items.empty())
    copy(type, array, unpack(message, 0));
  branchTo(end);
  continueIn(end);
  return known;
}

Value *Lowering::callQuery(const CallExpr &call) {
  if (call.name == "lightsource")
    return callLightSource(call);
  const stc::QueryKind &kind = *stc::queryKindNamed(call.name);
  const Expr *last = call.args.back();
  // A string may be asked for by its own value.
  bool mayBeSame = last->type.kind == TypeKind::String;
  SmallVector<Value *, 2> texts;
  for (size_t i = 0; i + 1 < call.args.size(); ++i)
    texts.push_back(lowerBefore(call.args[i], mayBeSame || effectsAfter(call, i)));
  Place target = place(last);
  at(call.loc);
  if (!hasContext(call.loc))
    return number(0);
  // An element or component is changed in a copy.
  Value *variable = load(target, last->type);
  Value *known =
      query(kind, texts.size() == 2 ? texts[0] : text(""), texts.back(), last->type, variable);
  if (target.component)
    store(target, variable);
  Value *result = temporary({TypeKind::Float, call.type.varying});
  b.call(Op::float_from_test, {result, known});
  return result;
}

Value *Lowering::callShaderName(const CallExpr &call) {
  at(call.loc);
  if (call.args.empty())
    return text(shaderName);
  const stc::QueryKind &kind = *stc::queryKindNamed(cast<StringExpr>(call.args[0])->value);
  Value *result = text("");
  if (hasContext(call.loc) && (kind.name != "lightsource" || currentLight.index))
    query(kind, text(""), text(ANYSL_QUERY_SHADER_NAME), {TypeKind::String}, result);
  return result;
}

} // namespace anysl::rsl
