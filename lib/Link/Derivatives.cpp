//===-- lib/Link/Derivatives.cpp - arithmetic of derivatives ------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Most derivatives are 0, and what they are multiplied by and added to should cost nothing. For
// IEEE numbers 0 x may be NaN and 0 + x is not x for x = -0; a derivative is not that particular.
// <anysl/dual.h> marks such arithmetic by letting it reassociate, which nothing else in a runtime
// does.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/Operator.h"

using namespace llvm;

namespace anysl::link {
namespace {

void addInput(Shader &shader, const stc::GlobalVariableInfo &global) {
  auto known = find_if(shader.info.globals,
                       [&](const stc::GlobalInfo &entry) { return entry.id == global.id; });
  if (known == shader.info.globals.end())
    shader.info.globals.push_back({global.id, /*read=*/true, /*written=*/false});
  else if (known->read)
    return;
  else
    known->read = true;
  shader.report.globalsRead.push_back(global.name.str());
}

/// Marks the parameters of which a derivative is still looked up.
void resolveDerivativeParams(Session &session) {
  for (Shader &shader : session.shaders)
    shader.differentiated.resize(shader.info.params.size());
  Function *lookup = session.module->getFunction(derivativeParam);
  if (!lookup)
    return;
  for (User *user : make_early_inc_range(lookup->users())) {
    auto *call = cast<CallInst>(user);
    Value *number = call->getArgOperand(0);
    for (Shader &shader : session.shaders)
      if (auto *constant = dyn_cast<ConstantInt>(number);
          constant && call->getFunction() == shader.point)
        shader.differentiated.set(unsigned(constant->getZExtValue()));
    call->replaceAllUsesWith(number);
    call->eraseFromParent();
  }
  lookup->eraseFromParent();
}

/// Whether anybody reads what calls put to an address. Something else than a variable may be read.
bool isRead(const Value *address) {
  return !isa<AllocaInst>(address) || !all_of(address->users(), [&](const User *user) {
    auto *store = dyn_cast<StoreInst>(user);
    return isa<CallInst>(user) || (store && store->getPointerOperand() == address);
  });
}

void resolveDerivativeTextures(Module &module) {
  Function *asks = module.getFunction(derivativeTexture);
  if (!asks)
    return;
  for (User *user : make_early_inc_range(asks->users())) {
    auto *call = cast<CallInst>(user);
    Value *query = call->getArgOperand(0);
    bool isWanted = any_of(drop_begin(call->args()), [](const Use &use) { return isRead(use); });
    call->replaceAllUsesWith(isWanted ? query : Constant::getNullValue(query->getType()));
    call->eraseFromParent();
  }
  asks->eraseFromParent();
}

} // namespace

bool carriesDerivatives(const Module &module) {
  return constantOf(module, "anysl_real_has_derivatives").value_or(0);
}

void resolveDerivativeInputs(Session &session) {
  resolveDerivativeParams(session);
  resolveDerivativeTextures(*session.module);
  uint32_t component = 0;
  for (const stc::GlobalVariableInfo &global : stc::allGlobals()) {
    uint32_t first = component;
    component += global.components;
    GlobalVariable *place =
        session.module->getNamedGlobal((derivativeInputPrefix + global.name).str());
    if (!place)
      continue;
    for (Shader &shader : session.shaders)
      if (any_of(place->users(), [&](const User *user) {
            auto *instruction = dyn_cast<Instruction>(user);
            return instruction && instruction->getFunction() == shader.point;
          }))
        addInput(shader, global);
    place->setInitializer(ConstantInt::get(place->getValueType(), first));
    place->setLinkage(GlobalValue::InternalLinkage);
    place->setConstant(true);
  }
}

bool resolveUnknownDerivatives(Session &session) {
  static constexpr WarningGroup HigherOrder{"higher-order", true};
  Function *unknown = session.module->getFunction(unknownDerivative);
  if (!unknown)
    return true;
  SmallVector<CallInst *> calls;
  for (User *user : unknown->users())
    calls.push_back(cast<CallInst>(user));
  if (!calls.empty()) {
    StringRef next = realOfHigherOrder(session);
    bool isChosen = session.real != session.options.real;
    if (isChosen && !next.empty()) {
      session.nextReal = next.str();
      return false;
    }
    auto known = find_if(calls, [](CallInst *call) { return bool(call->getDebugLoc()); });
    std::string message = "the derivative of a derivative is read, which real '" + session.real +
                          "' does not carry; it is 0";
    if (!next.empty())
      message += "; '--real " + next.str() + "' has it";
    session.diags.warning(known == calls.end() ? FilePosition() : stc::shaderPositionOf(**known),
                          HigherOrder, message);
  }
  for (CallInst *call : calls) {
    call->replaceAllUsesWith(Constant::getNullValue(call->getType()));
    call->eraseFromParent();
  }
  unknown->eraseFromParent();
  return true;
}

void relaxDerivatives(Module &module) {
  for (Function &function : module)
    for (Instruction &instruction : instructions(function)) {
      if (!isa<FPMathOperator>(instruction) || !instruction.hasAllowReassoc())
        continue;
      FastMathFlags flags;
      flags.setNoSignedZeros();
      // A product alone: a sum that is not a number still shows where a derivative is read.
      flags.setNoNaNs(instruction.getOpcode() == Instruction::FMul);
      instruction.copyFastMathFlags(flags);
    }
}

void keepArithmetic(Module &module) {
  for (Function &function : module)
    for (Instruction &instruction : instructions(function))
      if (isa<FPMathOperator>(instruction))
        instruction.copyFastMathFlags(FastMathFlags());
}

} // namespace anysl::link
