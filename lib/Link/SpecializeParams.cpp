//===-- lib/Link/SpecializeParams.cpp - makes parameters constants ------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// `--param glass.Kr=0` works on the threaded code, by operators alone: every load of the parameter
// becomes the construction of the constant, a varying parameter is never bound, and what the
// defaults store is the constant as well, so that a host which reads the cell sees the truth.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/OperatorWriter.h"
#include "lib/Link/Prune.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/InstIterator.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// Splits at commas; within a string parameter a backslash makes the next character ordinary.
SmallVector<StringRef> splitValues(StringRef text) {
  SmallVector<StringRef> values;
  text.split(values, ',');
  for (StringRef &value : values)
    value = value.trim();
  return values;
}

std::string describeType(const stc::ParamInfo &param) {
  std::string type = info(param.type).name.str();
  return param.arrayLength ? type + "[" + std::to_string(param.arrayLength) + "]" : type;
}

/// Where an array may have fewer elements than it has room for, the number of the parameter that
/// says how many.
std::optional<unsigned> lengthParam(const Shader &shader, unsigned number) {
  std::string name = shader.info.params[number].name + ".length";
  for (unsigned i = 0; i < shader.info.params.size(); ++i)
    if (shader.info.params[number].arrayLength && shader.info.params[i].name == name)
      return i;
  return std::nullopt;
}

/// Parses the values for one parameter. An element that is not a single number may be given by one
/// number, as the shading language converts it: a triple of equal components, a multiple of the
/// identity matrix.
std::optional<FixedValue> parseValue(Session &session, Shader &shader, unsigned number,
                                     StringRef text) {
  const stc::ParamInfo &param = shader.info.params[number];
  auto refuse = [&](const Twine &reason) {
    session.diags.error("--param " + shader.info.name + "." + param.name + ": " + reason);
    return std::nullopt;
  };
  FixedValue value{&shader, number, splitValues(text), {}, {}};
  unsigned cells = param.cellCount();
  if (lengthParam(shader, number) && value.texts.size() < cells &&
      value.texts.size() % info(param.type).components == 0)
    value.texts.resize(cells, param.type == stc::Type::stringTy ? "" : "0");
  if (param.type == stc::Type::stringTy) {
    if (!param.arrayLength)
      value.texts = {text};
    if (value.texts.size() != cells)
      return refuse("expected " + Twine(cells) + " texts for a " + describeType(param) + ", got " +
                    Twine(value.texts.size()));
    return value;
  }

  for (StringRef word : value.texts) {
    double parsed = 0;
    if (word.getAsDouble(parsed))
      return refuse("'" + word + "' is no number");
    value.numbers.push_back(parsed);
  }
  unsigned components = info(param.type).components;
  if (value.numbers.size() == 1 && cells == components && components > 1) {
    double single = value.numbers[0];
    value.numbers.assign(components, param.type == stc::Type::matrixTy ? 0 : single);
    if (param.type == stc::Type::matrixTy)
      for (unsigned i = 0; i < 16; i += 5)
        value.numbers[i] = single;
  }
  if (value.numbers.size() != cells)
    return refuse("expected " + Twine(cells) + " numbers for a " + describeType(param) + ", got " +
                  Twine(value.numbers.size()));
  return value;
}

/// Finds what one `--param` names. Gives false with an error reported if that is nothing.
bool parseOption(Session &session, StringRef option, std::vector<FixedValue> &values) {
  auto [name, text] = option.split('=');
  if (name.size() == option.size()) {
    session.diags.error("--param " + option + ": expected NAME=value or SHADER.NAME=value");
    return false;
  }
  auto [shaderName, paramName] =
      name.contains('.') ? name.split('.') : std::pair(StringRef(), name);

  bool found = false, knownShader = shaderName.empty();
  std::vector<StringRef> shaderNames, paramNames;
  for (Shader &shader : session.shaders) {
    shaderNames.push_back(shader.info.name);
    if (!shaderName.empty() && shader.info.name != shaderName)
      continue;
    knownShader = true;
    for (unsigned i = 0; i < shader.info.params.size(); ++i) {
      paramNames.push_back(shader.info.params[i].name);
      if (shader.info.params[i].name != paramName)
        continue;
      found = true;
      auto value = parseValue(session, shader, i, text);
      if (!value)
        return false;
      if (shader.info.params[i].output) {
        session.diags.error("--param " + name + ": an output parameter cannot be a constant");
        return false;
      }
      if (shader.fixed[i]) {
        session.diags.error("--param " + shader.info.name + "." + paramName + " is given twice");
        return false;
      }
      shader.fixed[i] = true;
      values.push_back(std::move(*value));
      if (std::optional<unsigned> length = lengthParam(shader, i)) {
        unsigned components = info(shader.info.params[i].type).components;
        shader.fixed[*length] = true;
        values.push_back(
            {&shader, *length, {}, {double(splitValues(text).size() / components)}, {}});
      }
    }
  }
  if (!knownShader)
    session.diags.error("--param " + option + ": there is no shader '" + shaderName + "'" +
                        didYouMean(shaderName, shaderNames));
  else if (!found)
    session.diags.error("--param " + option + ": there is no parameter '" + paramName + "'" +
                        didYouMean(paramName, paramNames));
  return found;
}

/// Fills `slot` with element `element` of a parameter's constant, just before `before`.
void construct(OperatorWriter &writer, Value *slot, stc::Type type, const FixedValue &value,
               unsigned element, Instruction &before) {
  unsigned components = info(type).components;
  bool isText = type == stc::Type::stringTy;
  writer.before(before, value.cause);
  writer.construct(slot, type,
                   isText ? ArrayRef<double>()
                          : ArrayRef(value.numbers).slice(element * components, components),
                   isText ? value.texts[element] : "");
}

/// Replaces a call that concerns the fixed parameter, if it is one.
void specializeCall(CallInst &call, const stc::OpInfo &op, const FixedValue &value,
                    OperatorWriter &writer) {
  auto kind = idKind(op);
  if (kind != stc::IdKind::Param && kind != stc::IdKind::Cell)
    return;
  const stc::ParamInfo &param = value.shader->info.params[value.param];
  // The table puts the number behind the context.
  unsigned position = 0;
  while (op.params[position].kind != stc::ParamKind::Id)
    ++position;
  unsigned number = unsigned(cast<ConstantInt>(call.getArgOperand(position))->getZExtValue());
  if (*kind == stc::IdKind::Param) {
    if (op.op == stc::Op::param_is_bound && number == value.param)
      call.replaceAllUsesWith(ConstantInt::getFalse(call.getContext()));
    return;
  }
  if (number < param.firstCell || number - param.firstCell >= param.cellCount())
    return;
  unsigned element = (number - param.firstCell) / info(param.type).components;
  if (op.purity == stc::Purity::Reads) {
    construct(writer, call.getArgOperand(0), param.type, value, element, call);
    call.eraseFromParent();
    return;
  }
  // A store of the default: of the constant instead.
  unsigned operand = unsigned(op.params.size() - 1);
  writer.before(call);
  Value *slot = writer.alloc(param.type);
  construct(writer, slot, param.type, value, element, call);
  call.setArgOperand(operand, slot);
}

} // namespace

void specialize(ArrayRef<FixedValue> values) {
  for (const FixedValue &value : values)
    for (Function *function : {value.shader->info.body, value.shader->info.init}) {
      OperatorWriter writer(*function->getParent());
      for (Instruction &instruction : make_early_inc_range(instructions(function)))
        if (auto *call = dyn_cast<CallInst>(&instruction))
          if (const stc::OpInfo *op = stc::opOfSymbol(call->getCalledFunction()->getName()))
            specializeCall(*call, *op, value, writer);
    }
}

bool specializeParams(Session &session) {
  std::vector<FixedValue> values;
  bool good = true;
  for (const std::string &option : session.options.params)
    good &= parseOption(session, option, values);
  if (!good)
    return false;
  if (session.options.scene)
    findSceneConstants(session, values);
  specialize(values);
  for (const FixedValue &value : values)
    value.shader->report.fixedParams.push_back(value.shader->info.params[value.param].name);
  return true;
}

} // namespace anysl::link
