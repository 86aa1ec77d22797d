//===-- lib/STC/Asking.cpp - what shaders ask of each other
//---------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Asking.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"

using namespace llvm;

namespace anysl::stc {
namespace {

/// Whether an operator names parameters of other shaders in its texts.
bool asksByName(const OpInfo &op, const CallInst &call) {
  // Kinds of QueryKinds.def from 7 on are no shader's.
  if (idKind(op) == IdKind::Query)
    for (auto [param, operand] : zip_equal(op.params, call.args()))
      if (param.kind == ParamKind::Id && cast<ConstantInt>(operand)->getZExtValue() >= 7)
        return false;
  return op.effect == Effect::Queries || op.effect == Effect::Shaders ||
         op.effect == Effect::LightValues || op.effect == Effect::Lights ||
         op.op == Op::trace_values;
}

void addWords(StringRef text, std::set<std::string> &words) {
  while (!text.empty()) {
    text = text.drop_until([](char c) { return isAlpha(c) || c == '_'; });
    StringRef word = text.take_while([](char c) { return isAlnum(c) || c == '_'; });
    if (!word.empty())
      words.insert(word.str());
    text = text.drop_front(word.size());
  }
}

/// Adds the words of all texts that a variable may hold; false if that cannot be told.
bool addTexts(const Value &slot, std::set<std::string> &words) {
  auto *alloc = dyn_cast<CallInst>(&slot);
  const OpInfo *made = alloc ? opOfSymbol(alloc->getCalledFunction()->getName()) : nullptr;
  if (!made || made->op != Op::alloc)
    return false;
  for (const User *user : slot.users()) {
    auto *call = dyn_cast<CallInst>(user);
    const OpInfo *op = call ? opOfSymbol(call->getCalledFunction()->getName()) : nullptr;
    if (!op)
      return false;
    for (auto [param, operand] : zip_equal(op->params, call->args())) {
      if (operand != &slot || param.kind == ParamKind::In)
        continue;
      if (op->op == Op::copy_string) {
        if (!addTexts(*call->getArgOperand(1), words))
          return false;
        continue;
      }
      if (op->op != Op::const_string)
        return false;
      auto *text = cast<GlobalVariable>(call->getArgOperand(1));
      if (auto *data = dyn_cast<ConstantDataArray>(text->getInitializer()))
        addWords(data->getAsCString(), words);
    }
  }
  return true;
}

} // namespace

std::optional<std::set<std::string>> askedNames(const Module &module) {
  std::set<std::string> result;
  for (const Function &function : module)
    for (const Instruction &instruction : instructions(function)) {
      auto *call = dyn_cast<CallInst>(&instruction);
      const Function *callee = call ? call->getCalledFunction() : nullptr;
      const OpInfo *op = callee ? opOfSymbol(callee->getName()) : nullptr;
      if (!op || !asksByName(*op, *call))
        continue;
      for (auto [param, operand] : zip_equal(op->params, call->args()))
        if (param.isValue() && param.type == Type::stringTy && param.kind == ParamKind::In &&
            !addTexts(*operand, result))
          return std::nullopt;
    }
  return result;
}

bool tracesForOthers(const StcModule &file) {
  bool runsForOthers = any_of(file.shaders, [](const ShaderInfo &shader) {
    return shader.kind == ShaderKind::Light || shader.kind == ShaderKind::Volume ||
           shader.kind == ShaderKind::Method;
  });
  return runsForOthers && any_of(*file.module, [](const Function &function) {
           const OpInfo *op = opOfSymbol(function.getName());
           return op && (tracesSurfaces(op->effect) || op->effect == Effect::Indirect);
         });
}

} // namespace anysl::stc
