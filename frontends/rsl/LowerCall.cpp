//===-- frontends/rsl/LowerCall.cpp - calls ---------------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

/// Whether the function being written has a context; an operator of the library may have none.
bool Lowering::hasContext(SMLoc loc) {
  if (b.context())
    return true;
  diags.error(loc, "this needs the shading context, which operator '" +
                       b.function()->getName().drop_front(stc::opPrefix.size()) +
                       "' does not have");
  return false;
}

Value *Lowering::lowerCall(const CallExpr &call) {
  switch (call.form) {
  case CallForm::Function:
    return callFunction(call);
  case CallForm::Builtin:
    return callBuiltin(call);
  case CallForm::ComponentWise:
    return callComponentWise(call);
  case CallForm::Spline:
    return callSpline(call);
  case CallForm::Query:
    return callQuery(call);
  case CallForm::Coshader:
    return callCoshader(call);
  case CallForm::Array:
    return callArray(call);
  case CallForm::ArrayLength: {
    Value *array = lower(call.args[0]);
    at(call.loc);
    Value *length = lengthOf(array);
    return lengths.count(array) ? copied({TypeKind::Float, true}, length) : length;
  }
  case CallForm::Print:
  case CallForm::Format:
    return callFormat(call);
  case CallForm::Concat:
    return callConcat(call);
  case CallForm::ShaderName:
    return callShaderName(call);
  }
  llvm_unreachable("unknown form of call");
}

bool Lowering::effectsAfter(const CallExpr &call, size_t argument) {
  for (const Expr *later : ArrayRef<Expr *>(call.args).drop_front(argument + 1))
    if (later->hasEffects)
      return true;
  return false;
}

/// The value of a field of NamedArguments.def: the call's own, or the default.
Value *Lowering::lowerNamed(const CallExpr &call, const BuiltinOperand &operand) {
  const Expr *given = call.named[operand.field];
  if (!given) {
    at(call.loc);
    return operand.type == TypeKind::String ? text("") : number(operand.number);
  }
  // One argument may set several fields, and has its effects once.
  if (Value *known = namedValues.lookup(given))
    return known;
  Value *value = lowerBefore(given, true);
  namedValues[given] = value;
  return value;
}

Value *Lowering::callBuiltin(const CallExpr &call) {
  const Builtin &builtin = *call.builtin;
  const stc::OpInfo &op = stc::info(builtin.op);
  struct Output {
    Place target;
    Value *value;
    Type from, to;
  };
  SmallVector<Output, 4> outputs;
  SmallVector<Value *, 8> values; ///< one for each of the built-in's operands
  size_t nextArg = 0;
  for (const BuiltinOperand &operand : builtin.operands) {
    Type type{operand.type, call.type.varying};
    switch (operand.source) {
    case BuiltinOperand::In: {
      const Expr *arg = call.args[nextArg];
      values.push_back(lowerBefore(arg, effectsAfter(call, nextArg)));
      ++nextArg;
      break;
    }
    case BuiltinOperand::Out:
    case BuiltinOperand::InOut: {
      const Expr *arg = call.args[nextArg++];
      Place target = place(arg);
      at(call.loc);
      type.varying = arg->type.varying;
      Value *fresh = temporary(type);
      if (operand.source == BuiltinOperand::InOut)
        copy(type, fresh, convert(load(target, arg->type), arg->type, type));
      values.push_back(fresh);
      outputs.push_back({target, fresh, type, arg->type});
      break;
    }
    case BuiltinOperand::Global:
      values.push_back(globalSlot(unsigned(operand.global)));
      break;
    case BuiltinOperand::Number:
      values.push_back(number(operand.number));
      break;
    case BuiltinOperand::Text:
      values.push_back(text(operand.text));
      break;
    case BuiltinOperand::Discard:
      values.push_back(nullptr); // its type is the operator's
      break;
    case BuiltinOperand::Light:
      if (!currentLight.index) {
        diags.error(call.loc, "'" + call.name + "' exists only inside of 'illuminance'");
        return b.ir().getFalse();
      }
      llvm::append_range(values, ArrayRef<Value *>{currentLight.index, currentLight.position,
                                                   currentLight.normal});
      break;
    case BuiltinOperand::Named:
      values.push_back(lowerNamed(call, operand));
      break;
    case BuiltinOperand::SpaceTo: {
      Value *to = lower(call.args[nextArg++]);
      values.push_back(spaceMatrix(text("current"), to, call.loc));
      break;
    }
    case BuiltinOperand::SpaceFromTo: {
      Value *from = lower(call.args[nextArg++]);
      Value *to = lower(call.args[nextArg++]);
      values.push_back(spaceMatrix(from, to, call.loc));
      break;
    }
    case BuiltinOperand::SpaceThenMatrix: {
      Value *from = lower(call.args[nextArg++]);
      Value *last = lower(call.args[nextArg++]);
      Value *first = spaceMatrix(from, text("current"), call.loc);
      Value *both = temporary({TypeKind::Matrix, true});
      b.call(Op::mul_matrix, {both, first, last});
      values.push_back(both);
      break;
    }
    }
  }
  for (const Expr *named : call.named)
    namedValues.erase(named);
  // What no operand takes may still assign something.
  for (const Expr *arg : call.rest)
    if (arg->hasEffects && !is_contained(call.named, arg))
      lower(arg);
  at(call.loc);
  if (op.takesContext() && !hasContext(call.loc))
    return call.type.is(TypeKind::Bool)   ? b.ir().getFalse()
           : call.type.is(TypeKind::Void) ? nullptr
                                          : temporary(call.type);
  bool hasResult = builtin.result != TypeKind::Void && builtin.result != TypeKind::Bool;
  Value *result = hasResult ? temporary(call.type) : nullptr;
  SmallVector<Value *, 10> operands;
  size_t next = 0;
  bool resultGiven = !hasResult;
  for (const stc::OpParam &param : op.params) {
    if (param.kind == stc::ParamKind::Ctx) {
      operands.push_back(b.context());
    } else if (!resultGiven) {
      operands.push_back(result);
      resultGiven = true;
    } else if (Value *value = values[next++]) {
      operands.push_back(value);
    } else {
      operands.push_back(temporary({typeKindOf(param.type), call.type.varying}));
    }
  }
  Value *returned =
      mayBeTraced(call) ? lowerTraced(call, operands, builtin.op) : b.call(builtin.op, operands);
  for (const Output &output : outputs)
    store(output.target, convert(output.value, output.from, output.to));
  return builtin.result == TypeKind::Bool ? returned : result;
}

Value *Lowering::callComponentWise(const CallExpr &call) {
  SmallVector<Value *, 4> values;
  for (size_t i = 0; i < call.args.size(); ++i)
    values.push_back(lowerBefore(call.args[i], effectsAfter(call, i)));
  at(call.loc);
  Type scalar{TypeKind::Float, call.type.varying};
  SmallVector<Value *, 4> components{temporary(call.type)};
  for (int c = 0; c < 3; ++c) {
    SmallVector<Value *, 4> operands{temporary(scalar)};
    for (size_t i = 0; i < values.size(); ++i) {
      Type type = call.args[i]->type;
      operands.push_back(type.is(TypeKind::Float) ? values[i]
                                                  : load({values[i], type, number(c)}, scalar));
    }
    b.call(call.builtin->op, operands);
    components.push_back(operands[0]);
  }
  b.call(opFor(call.type.kind, Op::make_color, Op::make_color, Op::make_vector), components);
  return components[0];
}

/// Expands a function in place.
Value *Lowering::callFunction(const CallExpr &call) {
  const FunctionDecl &function = *call.function;
  static constexpr unsigned MaxExpansions = 10000;
  if (++expansions > MaxExpansions) {
    if (expansions == MaxExpansions + 1)
      diags.error(call.loc, "functions calling functions expand to more than " +
                                Twine(MaxExpansions) + " calls");
    return call.type.is(TypeKind::Void) ? nullptr : temporary(call.type);
  }
  struct Output {
    Place target;
    const VarDecl *param;
    Value *slot;
    Type to;
  };
  SmallVector<Output, 4> outputs;
  SmallVector<Value *, 8> arguments;
  for (size_t i = 0; i < call.args.size(); ++i) {
    const Expr *arg = call.args[i];
    const VarDecl *param = function.leaves[i];
    Type type = param->type.withVarying(arg->type.varying);
    if (arg->type.isArray())
      type.length = arg->type.length;
    if (param->isOutput) {
      Place target = place(arg);
      Value *given = load(target, arg->type);
      if (type.isArray()) {
        type.length = int(capacityOf(given));
        type.isResizable = lengths.count(given);
      }
      at(call.loc);
      // The body may give its parameter values that vary although the argument's old one does not.
      type.varying |= param->type.varying && arg->type.varying;
      Value *fresh = temporary(type, param->name);
      copy(type, fresh, convert(given, arg->type, type));
      arguments.push_back(fresh);
      outputs.push_back({target, param, fresh, arg->type});
      continue;
    }
    Value *value;
    if (auto *list = dyn_cast<ListExpr>(arg)) {
      value = temporary(type, param->name);
      lowerListInto(*list, value);
    } else {
      value = lowerBefore(arg, effectsAfter(call, i));
    }
    at(call.loc);
    if (param->isCopied) {
      if (type.isArray()) {
        type.length = int(capacityOf(value));
        type.isResizable = lengths.count(value);
      }
      type.varying = true;
      Value *fresh = temporary(type, param->name);
      copy(type, fresh, value);
      value = fresh;
    } else if (function.usesOuter && mayBeVariable(arg)) {
      value = copied(arg->type, value);
    }
    arguments.push_back(value);
  }
  // The members that a method sees are those of the object that it is called on.
  SmallVector<Value *, 16> outerMembers;
  for (const Expr *member : call.self)
    outerMembers.push_back(place(member).slot);
  for (size_t i = 0; i < call.self.size(); ++i)
    std::swap(outerMembers[i], slots[function.parent->leaves[i]]);
  for (size_t i = 0; i < arguments.size(); ++i)
    slots[function.leaves[i]] = arguments[i];
  if (function.resultVariable)
    lowerVariable(*function.resultVariable);

  bool hasResult = function.result.kind != TypeKind::Void && !function.resultVariable;
  Type outerType = std::exchange(resultType, {function.result.kind, call.type.varying});
  Value *result = hasResult ? temporary(resultType, function.name) : nullptr;
  if (hasResult && !alwaysReturns(function.body))
    setZero(resultType, result);
  Value *outerResult = std::exchange(resultSlot, result);
  BasicBlock *outerReturn = std::exchange(returnBlock, b.block((function.name + ".end").str()));
  std::vector<Loop> outerLoops = std::exchange(loops, {});
  lowerBody(*function.body);
  loops = std::move(outerLoops);
  BasicBlock *end = std::exchange(returnBlock, outerReturn);
  resultSlot = outerResult;
  resultType = outerType;
  for (size_t i = 0; i < call.self.size(); ++i)
    slots[function.parent->leaves[i]] = outerMembers[i];
  at(call.loc);
  branchTo(end);
  continueIn(end);
  for (const Output &output : outputs)
    store(output.target,
          convert(output.slot,
                  output.param->type.isArray() ? output.param->type
                                               : output.param->type.withVarying(true),
                  output.to));
  return result;
}

} // namespace anysl::rsl
