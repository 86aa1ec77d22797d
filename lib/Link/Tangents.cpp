//===-- lib/Link/Tangents.cpp - how displaced surfaces change -----------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A displacement shader that stores P stores with it, where that is asked for, dPdu = Du(P) and
// dPdv = Dv(P), as if it said so itself: from then on the renderer has derivatives of what was
// moved.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include <anysl/abi.h>

using namespace llvm;

namespace anysl::link {
namespace {

const stc::OpInfo *opOf(const CallBase &call) {
  const Function *callee = call.getCalledFunction();
  return callee ? stc::opOfSymbol(callee->getName()) : nullptr;
}

FunctionCallee declare(Module &module, stc::Op op) {
  return module.getOrInsertFunction(stc::info(op).symbol(),
                                    stc::functionType(module.getContext(), stc::info(op)));
}

/// Whether all that P may be moved by carries derivatives: a renderer's answers, but for pictures,
/// do not.
bool knowsDerivatives(const Shader &shader) {
  for (Function *function : reachableFrom(shader.info.body))
    for (Instruction &instruction : instructions(function)) {
      auto *call = dyn_cast<CallBase>(&instruction);
      const stc::OpInfo *op = call ? opOf(*call) : nullptr;
      if (op && (op->effect == stc::Effect::ShadowMaps || op->effect == stc::Effect::Queries ||
                 op->effect == stc::Effect::Shaders || op->effect == stc::Effect::Random))
        return false;
    }
  return true;
}

std::vector<CallInst *> storesOfP(Function &body) {
  std::vector<CallInst *> result;
  for (Instruction &instruction : instructions(body)) {
    auto *call = dyn_cast<CallInst>(&instruction);
    const stc::OpInfo *op = call ? opOf(*call) : nullptr;
    if (op && op->op == stc::Op::store_global_vector &&
        cast<ConstantInt>(call->getArgOperand(1))->equalsInt(ANYSL_P))
      result.push_back(call);
  }
  return result;
}

void storeDerivative(CallInst &store, stc::Op derivative, AnyslGlobal global) {
  Module &module = *store.getModule();
  Constant *type =
      module.getOrInsertGlobal("anysl_type_vector", Type::getInt8Ty(module.getContext()));
  IRBuilder<> builder(&*store.getFunction()->getEntryBlock().getFirstInsertionPt());
  builder.SetCurrentDebugLocation(store.getDebugLoc());
  Value *slot = builder.CreateCall(declare(module, stc::Op::alloc), {type});
  builder.SetInsertPoint(&store);
  builder.CreateCall(declare(module, derivative), {slot, store.getArgOperand(2)});
  builder.CreateCall(store.getCalledFunction(),
                     {store.getArgOperand(0), builder.getInt32(global), slot});
}

bool writes(const Shader &shader, AnyslGlobal global) {
  return any_of(shader.info.globals, [&](const stc::GlobalInfo &entry) {
    return entry.id == unsigned(global) && entry.written;
  });
}

void markWritten(Shader &shader, AnyslGlobal global) {
  for (stc::GlobalInfo &entry : shader.info.globals)
    if (entry.id == unsigned(global)) {
      entry.written = true;
      return;
    }
  shader.info.globals.push_back({unsigned(global), /*read=*/false, /*written=*/true});
}

} // namespace

bool giveTangents(Session &session) {
  for (Shader &shader : session.shaders) {
    if (!session.options.tangents || shader.info.kind != stc::ShaderKind::Displacement ||
        writes(shader, ANYSL_dPdu) || writes(shader, ANYSL_dPdv) || !knowsDerivatives(shader))
      continue;
    std::vector<CallInst *> stores = storesOfP(*shader.info.body);
    for (CallInst *store : stores) {
      storeDerivative(*store, stc::Op::Du_vector, ANYSL_dPdu);
      storeDerivative(*store, stc::Op::Dv_vector, ANYSL_dPdv);
    }
    if (stores.empty())
      continue;
    markWritten(shader, ANYSL_dPdu);
    markWritten(shader, ANYSL_dPdv);
  }
  return true;
}

} // namespace anysl::link
