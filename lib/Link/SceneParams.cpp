//===-- lib/Link/SceneParams.cpp - the constants that a scene makes of parameters ---*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

//
// Shaders read and set each other's parameters by name, so a name that any shader of the scene may
// ask for stays what it is. A value that cannot be told from the threaded code alone (an array, a
// matrix, a point that depends on spaces) is left to the renderer.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Prune.h"
#include "lib/STC/Asking.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/InstIterator.h"

using namespace llvm;

namespace anysl::link {

using stc::Op;
using stc::ParamKind;

namespace {

/// A value in the words of the language: "0.5", "(1, 0, 0)", "\"grid.tex\"".
std::string wordsOf(const SlotValue &value) {
  if (value.numbers.empty())
    return "\"" + value.text + "\"";
  std::string result;
  raw_string_ostream stream(result);
  for (double number : value.numbers)
    stream << (result.empty() ? "" : ", ") << format("%g", number);
  return value.numbers.size() == 1 ? result : "(" + result + ")";
}

class SceneConstants {
public:
  SceneConstants(Session &session, std::vector<FixedValue> &values)
      : session(session), values(values), asked(askedNames(session)) {}

  void find(Shader &shader, const demand::ShaderDemand &given) {
    if (!asked)
      return;
    std::vector<bool> keepsDefault(shader.info.params.size());
    for (unsigned i = 0; i < shader.info.params.size(); ++i) {
      if (!mayFold(shader, i))
        continue;
      auto value = given.parameters.find(shader.info.params[i].name);
      if (value == given.parameters.end())
        keepsDefault[i] = given.complete;
      else if (value->second)
        fold(shader, i, {value->second->numbers, value->second->text, {}}, value->second->from);
    }
    foldDefaults(shader, keepsDefault, given);
  }

private:
  bool mayFold(const Shader &shader, unsigned number) const {
    const stc::ParamInfo &param = shader.info.params[number];
    bool isSimple = param.type == stc::Type::floatTy || param.type == stc::Type::colorTy ||
                    param.type == stc::Type::stringTy;
    // Of a resizable array the renderer sets the length with the array.
    return isSimple && !param.arrayLength && !param.output && !shader.fixed[number] &&
           !StringRef(param.name).contains('.') && !asked->contains(param.name);
  }

  void fold(Shader &shader, unsigned number, SlotValue value, StringRef from) {
    const stc::ParamInfo &param = shader.info.params[number];
    bool isText = param.type == stc::Type::stringTy;
    unsigned components = info(param.type).components;
    if (!isText && value.numbers.size() == 1)
      value.numbers.assign(components, value.numbers[0]);
    // The renderer is told of a value that does not fit when it sets it.
    if (isText != value.numbers.empty() || (!isText && value.numbers.size() != components))
      return;
    shader.fixed[number] = true;
    FixedValue fixed{&shader, number, {}, {}, param.name + " = " + wordsOf(value)};
    if (!from.empty())
      fixed.cause += (" (" + from + ")").str();
    if (isText)
      fixed.texts = {session.keep(value.text)};
    else
      fixed.numbers.assign(value.numbers.begin(), value.numbers.end());
    values.push_back(std::move(fixed));
  }

  /// Runs the code that computes the defaults, as far as it is constant.
  void foldDefaults(Shader &shader, const std::vector<bool> &keepsDefault,
                    const demand::ShaderDemand &given) {
    auto oracle = [&](const CallInst &call,
                      const stc::OpInfo &op) -> std::optional<SlotConstants::Known> {
      if (op.op != Op::param_is_set)
        return std::nullopt;
      uint64_t number = cast<ConstantInt>(call.getArgOperand(1))->getZExtValue();
      if (number < keepsDefault.size() && keepsDefault[number])
        return SlotConstants::Known{0, std::nullopt, ""};
      return std::nullopt;
    };
    SlotConstants constants(*shader.info.init, session.real, oracle);
    std::map<unsigned, std::optional<SlotValue>> stored;
    for (Instruction &instruction : instructions(shader.info.init)) {
      auto *call = dyn_cast<CallInst>(&instruction);
      const stc::OpInfo *op =
          call ? stc::opOfSymbol(call->getCalledFunction()->getName()) : nullptr;
      if (!op || op->purity != stc::Purity::Writes || idKind(*op) != stc::IdKind::Cell ||
          !constants.isReached(call->getParent()))
        continue;
      unsigned cell = unsigned(cast<ConstantInt>(call->getArgOperand(1))->getZExtValue());
      const stc::ParamInfo *param = shader.info.paramOfCell(cell);
      unsigned number = unsigned(param - shader.info.params.data());
      auto value = constants.before(*call, call->getArgOperand(2));
      auto [entry, isFirst] = stored.try_emplace(number, value);
      if (!isFirst)
        entry->second.reset();
    }
    for (auto &[number, value] : stored)
      if (keepsDefault[number] && value)
        fold(shader, number, *value, "the default");
  }

  Session &session;
  std::vector<FixedValue> &values;
  std::optional<std::set<std::string>> asked;
};

} // namespace

void findSceneConstants(Session &session, Shader &shader, const demand::ShaderDemand &given,
                        std::vector<FixedValue> &values) {
  SceneConstants(session, values).find(shader, given);
}

std::optional<std::set<std::string>> askedNames(const Session &session) {
  const auto &others = session.options.scene->asked;
  if (!others)
    return std::nullopt;
  std::set<std::string> result(others->begin(), others->end());
  for (const stc::StcModule &file : session.files) {
    auto names = stc::askedNames(*file.module);
    if (!names)
      return std::nullopt;
    result.insert(names->begin(), names->end());
  }
  return result;
}

void findSceneConstants(Session &session, std::vector<FixedValue> &values) {
  // Methods find the parameters of their shader where other shaders have changed them.
  if (any_of(session.shaders,
             [](const Shader &shader) { return shader.info.kind == stc::ShaderKind::Method; }))
    return;
  const auto &known = session.options.scene->shaders;
  for (Shader &shader : session.shaders)
    if (auto given = known.find(shader.info.name); given != known.end())
      findSceneConstants(session, shader, given->second, values);
}

} // namespace anysl::link
