//===-- lib/Link/MathTiers.cpp - several math tiers in one library ------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Every tier defines the same names. Where several are linked, the tier that a function comes from
// by default keeps `anysl_math_sinf`, and the others' becomes `anysl_math_sinf.fast`. A place in a
// shader that has a tier of its own calls copies of the operators on the way from there to the
// function, and the last of them calls the tier's.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/Transforms/Utils/Cloning.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// The functions of both number formats.
SmallVector<std::string> symbolsOf(StringRef function) {
  std::string name = ("anysl_math_" + function).str();
  return {name, name + "f"};
}

/// The elementary function that a function of the module is; empty if it is none.
StringRef mathFunctionOf(const Function &function) {
  StringRef name = function.getName();
  if (!name.consume_front("anysl_math_"))
    return "";
  name = name.split('.').first;
  for (StringRef candidate : {name, name.ends_with("f") ? name.drop_back() : name})
    if (is_contained(mathFunctions(), candidate))
      return candidate;
  return "";
}

/// What a module links in place of a tier's names that are another tier's.
std::string ownName(const Twine &symbol, StringRef tier) { return (symbol + "." + tier).str(); }

/// The elementary functions that functions lead to.
class ReachedMath {
public:
  /// Of a function, itself included.
  const StringSet<> &of(Function &function) {
    auto [entry, isNew] = reached.try_emplace(&function);
    if (!isNew)
      return *entry->second;
    entry->second = std::make_unique<StringSet<>>();
    StringSet<> &set = *entry->second;
    if (StringRef name = mathFunctionOf(function); !name.empty())
      set.insert(name);
    else
      for (Instruction &instruction : instructions(function))
        if (auto *call = dyn_cast<CallBase>(&instruction))
          if (Function *callee = call->getCalledFunction())
            for (const auto &name : of(*callee))
              set.insert(name.first());
    return set;
  }

private:
  DenseMap<const Function *, std::unique_ptr<StringSet<>>> reached;
};

/// Gives calls copies of what they call.
class SiteTiers {
public:
  SiteTiers(Session &session, ReachedMath &math) : session(session), math(math) {}

  void redirect(CallBase &call, StringRef function, StringRef tier) {
    call.setCalledFunction(copyOf(*call.getCalledFunction(), function, tier));
  }

private:
  Function *copyOf(Function &original, StringRef function, StringRef tier) {
    if (mathFunctionOf(original) == function)
      return inTier(original, function, tier);
    Function *&copy = copies[(original.getName() + "." + function + "=" + tier).str()];
    if (copy)
      return copy;
    ValueToValueMapTy values;
    copy = CloneFunction(&original, values);
    copy->setName(original.getName() + "." + function + "." + tier);
    copy->setLinkage(GlobalValue::InternalLinkage);
    copy->setComdat(nullptr);
    for (Instruction &instruction : instructions(copy))
      if (auto *call = dyn_cast<CallBase>(&instruction))
        if (Function *callee = call->getCalledFunction(); callee && isWanted(*callee, function))
          call->setCalledFunction(copyOf(*callee, function, tier));
    return copy;
  }

  bool isWanted(Function &callee, StringRef function) {
    return !callee.isDeclaration() && math.of(callee).contains(function);
  }

  /// The same function of another tier: of a function that another rule has redirected, too.
  Function *inTier(Function &original, StringRef function, StringRef tier) {
    StringRef symbol = original.getName().split('.').first;
    bool isDefault = session.math.tierOf(function) == tier;
    Function *other = session.module->getFunction(isDefault ? symbol.str() : ownName(symbol, tier));
    return other ? other : &original;
  }

  Session &session;
  ReachedMath &math;
  StringMap<Function *> copies;
};

} // namespace

void separateTier(Session &session, StringRef tier, Module &module) {
  StringSet<> functions;
  for (StringRef function : mathFunctions())
    for (StringRef symbol : symbolsOf(function)) {
      GlobalValue *value = module.getNamedValue(symbol);
      if (!value || value->isDeclaration())
        continue;
      if (session.math.tierOf(function) != tier)
        value->setName(ownName(symbol, tier));
      functions.insert(value->getName());
    }
  // Operators guard their functions all alike, as the tier for all that is not named wants it.
  if (tier == session.math.tier)
    functions.insert("anysl_math_keeps_flags");
  // Tiers share the names of what their functions are made from, but not always its meaning.
  for (GlobalObject &object : module.global_objects())
    if (!object.isDeclaration() && !functions.contains(object.getName())) {
      object.setComdat(nullptr);
      object.setLinkage(GlobalValue::InternalLinkage);
    }
}

std::vector<std::string> tierSymbols(const Session &session) {
  std::vector<std::string> result;
  for (const MathSite &site : session.math.sites)
    for (StringRef symbol : symbolsOf(site.function))
      if (session.math.tierOf(site.function) != site.tier)
        result.push_back(ownName(symbol, site.tier));
  return result;
}

/// Lists the places in a shader that compute elementary functions, its own functions included.
static std::vector<MathCall> mathCallsOf(const Session &session, ReachedMath &math,
                                         ArrayRef<Function *> roots) {
  SmallSetVector<Function *, 8> functions(roots.begin(), roots.end());
  std::map<std::tuple<std::string, unsigned, unsigned, std::string>, MathCall> calls;
  for (unsigned i = 0; i < functions.size(); ++i)
    for (Instruction &instruction : instructions(functions[i])) {
      auto *call = dyn_cast<CallBase>(&instruction);
      Function *callee = call ? call->getCalledFunction() : nullptr;
      if (!callee || callee->isDeclaration())
        continue;
      const stc::OpInfo *op = stc::opOfSymbol(callee->getName());
      if (!op) {
        functions.insert(callee);
        continue;
      }
      MathCall entry{stc::positionOf(*call), op->name.str(), {}};
      for (StringRef function : mathFunctions())
        if (math.of(*callee).contains(function))
          entry.functions.push_back(
              {function.str(), session.math.tierOf(function, entry.position)});
      const FilePosition &at = entry.position;
      if (!entry.functions.empty())
        calls.try_emplace({at.file, at.line, at.column, entry.op}, entry);
    }
  std::vector<MathCall> result;
  for (auto &[place, call] : calls)
    result.push_back(std::move(call));
  return result;
}

bool chooseTiers(Session &session) {
  static constexpr WarningGroup Unused{"unused-math-choice", true};
  ReachedMath math;
  SiteTiers tiers(session, math);
  std::vector<bool> isUsed(session.math.sites.size());
  for (Shader &shader : session.shaders)
    shader.report.mathCalls = mathCallsOf(session, math, {shader.info.body, shader.info.init});
  // Copies that are made on the way are no places in a shader.
  SmallVector<CallBase *> calls;
  for (Function &function : *session.module)
    for (Instruction &instruction : instructions(function))
      if (auto *call = dyn_cast<CallBase>(&instruction))
        if (call->getDebugLoc() && call->getCalledFunction())
          calls.push_back(call);
  for (CallBase *call : calls) {
    FilePosition position = stc::positionOf(*call);
    for (auto [i, site] : enumerate(session.math.sites))
      if (site.fits(position) && math.of(*call->getCalledFunction()).contains(site.function)) {
        isUsed[i] = true;
        tiers.redirect(*call, site.function, site.tier);
      }
  }
  for (auto [i, site] : enumerate(session.math.sites))
    if (!isUsed[i])
      session.diags.warning(FilePosition{session.options.mathChoices}, Unused,
                            "nothing in line " + Twine(site.line) + " of '" + site.file +
                                "' computes '" + site.function + "'");
  return true;
}

} // namespace anysl::link
