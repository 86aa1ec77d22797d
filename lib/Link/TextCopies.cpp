//===-- lib/Link/TextCopies.cpp - operators for texts that are constants ------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Library functions that tell by a text what to do, as ctransform() does by the names of colour
// spaces, are handed constants nearly always. Such a call gets a copy of the function for its
// texts, in which comparisons of constant texts are decided and what is never reached is gone. What
// would be inlined is then a small part, which matters in shaders with hundreds of such calls.
//
// Done on the threaded code, where a variable that is given a constant text once and never changed
// is easy to see.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "lib/STC/MetadataNames.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Analysis/InstructionSimplify.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/Transforms/Utils/Cloning.h"
#include "llvm/Transforms/Utils/Local.h"

using namespace llvm;

namespace anysl::link {

using stc::Op;
using stc::ParamKind;

namespace {

const stc::OpInfo *opOf(const CallInst &call) {
  const Function *callee = call.getCalledFunction();
  return callee ? stc::opOfSymbol(callee->getName()) : nullptr;
}

bool isComparison(const CallInst &call) {
  const stc::OpInfo *op = opOf(call);
  return op && (op->op == Op::eq_string || op->op == Op::ne_string);
}

/// Where a function of threaded code takes a text and is not to change it.
bool takesText(const stc::OpParam &param) {
  return param.kind == ParamKind::In && param.type == stc::Type::stringTy && !param.arrayLength;
}

/// The texts of one function's variables.
class Texts {
public:
  explicit Texts(Function &function) : dominators(function) {}

  /// The constant (`i8` array) that a variable holds whenever `use` reads it; null if it may hold
  /// something else.
  Constant *of(Value *slot, const CallInst &use) const {
    auto *alloc = dyn_cast<CallInst>(slot);
    const stc::OpInfo *op = alloc ? opOf(*alloc) : nullptr;
    if (!op || op->op != Op::alloc)
      return nullptr;
    CallInst *writer = nullptr;
    for (Use &slotUse : alloc->uses()) {
      auto *call = dyn_cast<CallInst>(slotUse.getUser());
      Function *callee = call ? call->getCalledFunction() : nullptr;
      auto params = callee ? stc::signatureOf(*callee) : std::nullopt;
      if (!params || params->size() <= slotUse.getOperandNo())
        return nullptr;
      ParamKind kind = (*params)[slotUse.getOperandNo()].kind;
      if (kind == ParamKind::In)
        continue;
      if (kind != ParamKind::Out || writer)
        return nullptr;
      writer = call;
    }
    const stc::OpInfo *written = writer ? opOf(*writer) : nullptr;
    if (!written || !dominators.dominates(writer, &use))
      return nullptr;
    if (written->op == Op::const_string)
      return cast<Constant>(writer->getArgOperand(1));
    return written->op == Op::copy_string ? of(writer->getArgOperand(1), *writer) : nullptr;
  }

private:
  DominatorTree dominators;
};

StringRef contentsOf(Constant *text) {
  auto *global = cast<GlobalVariable>(text);
  auto *data = dyn_cast<ConstantDataArray>(global->getInitializer());
  return data ? data->getAsCString() : "";
}

class TextCopies {
public:
  explicit TextCopies(Module &module) : module(module) {}

  /// Decides what is known in a function, and lets it call copies.
  void treat(Function &function) {
    if (any_of(instructions(function), [](Instruction &instruction) {
          auto *call = dyn_cast<CallInst>(&instruction);
          return call && isComparison(*call);
        }))
      decide(function);
    Texts texts(function);
    SmallVector<CallInst *> calls;
    for (Instruction &instruction : instructions(function))
      if (auto *call = dyn_cast<CallInst>(&instruction))
        if (Function *callee = call->getCalledFunction(); callee && !callee->isDeclaration())
          calls.push_back(call);
    for (CallInst *call : calls)
      redirect(*call, texts);
  }

private:
  /// Replaces comparisons of constant texts, and takes away what no way leads to any more.
  static void decide(Function &function) {
    Texts texts(function);
    SmallVector<std::pair<CallInst *, bool>> decided;
    for (Instruction &instruction : instructions(function)) {
      auto *call = dyn_cast<CallInst>(&instruction);
      if (!call || !isComparison(*call))
        continue;
      Constant *a = texts.of(call->getArgOperand(0), *call);
      Constant *b = a ? texts.of(call->getArgOperand(1), *call) : nullptr;
      if (a && b)
        decided.push_back(
            {call, (contentsOf(a) == contentsOf(b)) == (opOf(*call)->op == Op::eq_string)});
    }
    if (decided.empty())
      return;
    SmallSetVector<Instruction *, 8> conditions;
    for (auto [call, truth] : decided) {
      for (User *user : call->users())
        conditions.insert(cast<Instruction>(user));
      call->replaceAllUsesWith(ConstantInt::getBool(call->getType(), truth));
      call->eraseFromParent();
    }
    const DataLayout &layout = function.getParent()->getDataLayout();
    while (!conditions.empty()) {
      Instruction *condition = conditions.pop_back_val();
      Value *simple = condition->isTerminator() || isa<CallInst>(condition)
                          ? nullptr
                          : simplifyInstruction(condition, SimplifyQuery(layout));
      if (!simple || simple == condition)
        continue;
      for (User *user : condition->users())
        conditions.insert(cast<Instruction>(user));
      condition->replaceAllUsesWith(simple);
      condition->eraseFromParent();
    }
    for (BasicBlock &block : function)
      ConstantFoldTerminator(&block, /*DeleteDeadConditions=*/true);
    removeUnreachableBlocks(function);
  }

  /// Whether what a function does may depend on its parameter `number`, a text, in a way that a
  /// constant decides.
  bool asks(Function &function, unsigned number) {
    auto [entry, isNew] = asked.try_emplace({&function, number}, false);
    if (!isNew)
      return entry->second;
    bool result = any_of(function.getArg(number)->uses(), [&](Use &use) {
      auto *call = dyn_cast<CallInst>(use.getUser());
      Function *callee = call ? call->getCalledFunction() : nullptr;
      if (!callee || use.getOperandNo() >= call->arg_size())
        return false;
      if (isComparison(*call))
        return true;
      auto params = callee->isDeclaration() ? std::nullopt : stc::signatureOf(*callee);
      return params && takesText((*params)[use.getOperandNo()]) &&
             asks(*callee, use.getOperandNo());
    });
    return asked[{&function, number}] = result;
  }

  void redirect(CallInst &call, const Texts &texts) {
    Function &callee = *call.getCalledFunction();
    auto params = stc::signatureOf(callee);
    if (!params || params->size() != call.arg_size())
      return;
    SmallVector<Constant *> known(call.arg_size());
    std::string key = callee.getName().str();
    for (auto [i, param] : enumerate(*params)) {
      if (!takesText(param) || !asks(callee, unsigned(i)))
        continue;
      known[i] = texts.of(call.getArgOperand(unsigned(i)), call);
      if (known[i])
        key += (Twine(".") + Twine(i) + "=" + contentsOf(known[i])).str();
    }
    if (any_of(known, [](Constant *text) { return text != nullptr; }))
      call.setCalledFunction(copyOf(callee, known, key));
  }

  Function *copyOf(Function &original, ArrayRef<Constant *> known, const std::string &key) {
    Function *&copy = copies[key];
    if (copy)
      return copy;
    ValueToValueMapTy values;
    Function *made = copy = CloneFunction(&original, values);
    made->setName(key);
    made->setLinkage(GlobalValue::InternalLinkage);
    made->setComdat(nullptr);
    describe(*made, original);
    Type *pointer = PointerType::getUnqual(module.getContext());
    Type *nothing = Type::getVoidTy(module.getContext());
    BasicBlock &entry = made->getEntryBlock();
    IRBuilder<> builder(&entry, entry.getFirstNonPHIOrDbg()->getIterator());
    builder.SetCurrentDebugLocation(entry.getFirstNonPHIOrDbg()->getDebugLoc());
    for (auto [i, text] : enumerate(known)) {
      if (!text)
        continue;
      Value *slot = builder.CreateCall(
          module.getOrInsertFunction(info(Op::alloc).symbol(), pointer, pointer),
          module.getNamedGlobal(
              (stc::typeSymbolPrefix + stc::info(stc::Type::stringTy).name).str()));
      builder.CreateCall(
          module.getOrInsertFunction(info(Op::const_string).symbol(), nothing, pointer, pointer),
          {slot, text});
      made->getArg(unsigned(i))->replaceAllUsesWith(slot);
    }
    treat(*made);
    return made;
  }

  /// An operator's copy has another name, so what its parameters are is written down.
  static void describe(Function &copy, Function &original) {
    if (copy.getMetadata(stc::metadata::signature))
      return;
    auto params = stc::signatureOf(original);
    SmallVector<Metadata *> words;
    for (const stc::OpParam &param : *params)
      words.push_back(MDString::get(copy.getContext(), stc::toString(param)));
    copy.setMetadata(stc::metadata::signature, MDNode::get(copy.getContext(), words));
  }

  Module &module;
  std::map<std::pair<Function *, unsigned>, bool> asked;
  StringMap<Function *> copies;
};

} // namespace

bool copyForTexts(Session &session) {
  SmallVector<Function *> functions;
  for (Function &function : *session.module)
    if (!function.isDeclaration())
      functions.push_back(&function);
  TextCopies copies(*session.module);
  for (Function *function : functions)
    copies.treat(*function);
  return true;
}

} // namespace anysl::link
