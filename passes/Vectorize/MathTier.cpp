//===-- passes/Vectorize/MathTier.cpp - C's elementary functions from a math tier -------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/MathTier.h"

#include "passes/Vectorize/Intrinsics.h"

#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IRReader/IRReader.h"
#include "llvm/Linker/Linker.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/SourceMgr.h"
#include "llvm/Transforms/Utils/Cloning.h"

#include <dlfcn.h>

using namespace llvm;

namespace anysl {

//===-- Tiers ---------------------------------------------------------------===//

static std::string mathFolder() {
  Dl_info here;
  SmallString<128> folder;
  if (!dladdr(reinterpret_cast<void *>(&mathTierFile), &here) ||
      sys::fs::real_path(here.dli_fname, folder))
    return {};
  sys::path::remove_filename(folder);
  for (StringRef way : {"anysl/math", "../lib/anysl/math"}) {
    SmallString<128> math = folder;
    sys::path::append(math, way);
    if (sys::fs::is_directory(math))
      return math.str().str();
  }
  return {};
}

std::vector<std::string> mathTiers() {
  std::vector<std::string> names;
  std::error_code code;
  for (sys::fs::directory_iterator it(mathFolder(), code), end; it != end && !code;
       it.increment(code))
    if (sys::path::extension(it->path()) == ".bc")
      names.push_back(sys::path::stem(it->path()).str());
  llvm::sort(names);
  return names;
}

std::string mathTierFile(StringRef tier) { return mathFolder() + "/" + tier.str() + ".bc"; }

//===-- Calls ---------------------------------------------------------------===//

/// The tiers' functions that <math.h> has, too, with their numbers of arguments.
static unsigned argumentsOf(StringRef name) {
  static const StringMap<unsigned> functions = {
#define MATH_UNARY(name, ...) {#name, 1},
#define MATH_BINARY(name, ...) {#name, 2},
#include <anysl/MathFunctions.def>
  };
  for (StringRef own : {"inversesqrt", "reciprocal", "divide"})
    if (name == own)
      return 0;
  return functions.lookup(name);
}

/// The function of a tier that computes what a call asks for; empty if there is none.
static std::string tierFunction(const CallInst &call) {
  const Function *callee = call.getCalledFunction();
  Type *type = call.getType();
  if (!callee || !callee->isDeclaration() || (!type->isFloatTy() && !type->isDoubleTy()))
    return {};
  StringRef name = callee->getName();
  if (callee->isIntrinsic()) {
    name = mathFunctionOf(callee->getIntrinsicID());
  } else {
    if (call.isNoBuiltin() || (type->isFloatTy() && !name.consume_back("f")))
      return {};
  }
  if (call.arg_size() == 0 || argumentsOf(name) != call.arg_size() ||
      !all_of(call.args(), [&](const Use &argument) { return argument->getType() == type; }))
    return {};
  return ("anysl_math_" + name + (type->isFloatTy() ? "f" : "")).str();
}

void MathTier::link() {
  SMDiagnostic problem;
  std::unique_ptr<Module> tier = getLazyIRFileModule(file, problem, module.getContext());
  if (!tier)
    report_fatal_error(Twine(file) + ": " + problem.getMessage(), false);
  tier->setTargetTriple(module.getTargetTriple());
  tier->setDataLayout(module.getDataLayout());
  SmallPtrSet<const GlobalValue *, 32> own;
  for (const GlobalValue &value : module.global_values())
    if (!value.isDeclaration())
      own.insert(&value);
  if (Linker::linkModules(module, std::move(tier), Linker::Flags::LinkOnlyNeeded))
    report_fatal_error(Twine(file) + " cannot be linked", false);
  for (GlobalObject &object : module.global_objects())
    if (!object.isDeclaration() && !own.contains(&object) &&
        !object.getName().starts_with("llvm.")) {
      object.setComdat(nullptr);
      object.setLinkage(GlobalValue::InternalLinkage);
      linked.insert(object.getName());
    }
}

void MathTier::inlineCalls(Function &function) {
  for (bool again = true; again;) {
    again = false;
    SmallVector<CallInst *, 8> calls;
    for (Instruction &instruction : instructions(function))
      if (auto *call = dyn_cast<CallInst>(&instruction))
        if (Function *callee = call->getCalledFunction();
            callee && !callee->isDeclaration() && linked.contains(callee->getName()))
          calls.push_back(call);
    for (CallInst *call : calls) {
      InlineFunctionInfo info;
      again |= InlineFunction(*call, info).isSuccess();
    }
  }
}

bool MathTier::apply(Function &function) {
  if (file.empty())
    return false;
  SmallVector<std::pair<CallInst *, std::string>, 8> calls;
  for (Instruction &instruction : instructions(function))
    if (auto *call = dyn_cast<CallInst>(&instruction))
      if (std::string name = tierFunction(*call); !name.empty())
        calls.emplace_back(call, name);
  if (calls.empty())
    return false;
  bool isMissing = false;
  for (auto &[call, name] : calls) {
    SmallVector<Type *, 2> types(call->arg_size(), call->getType());
    FunctionCallee target =
        module.getOrInsertFunction(name, FunctionType::get(call->getType(), types, false));
    isMissing |= cast<Function>(target.getCallee())->isDeclaration();
    IRBuilder<> builder(call);
    SmallVector<Value *, 2> arguments(call->args());
    CallInst *made = builder.CreateCall(target, arguments);
    made->takeName(call);
    call->replaceAllUsesWith(made);
    call->eraseFromParent();
  }
  if (isMissing)
    link();
  inlineCalls(function);
  return true;
}

void MathTier::removeUnused() {
  for (bool again = true; again;) {
    again = false;
    for (const auto &name : linked) {
      GlobalValue *value = module.getNamedValue(name.getKey());
      if (!value || !value->use_empty() || !value->hasLocalLinkage())
        continue;
      value->eraseFromParent();
      again = true;
    }
  }
}

} // namespace anysl
