//===-- lib/Link/CallGraph.cpp - questions about who calls whom ---------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SetVector.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/IntrinsicInst.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// A depth-first walk over direct calls that keeps its path.
class RecursionFinder {
public:
  explicit RecursionFinder(Session &session) : session(session) {}

  bool visit(Function &function) {
    path.insert(&function);
    for (Instruction &instruction : instructions(function)) {
      auto *call = dyn_cast<CallBase>(&instruction);
      Function *callee = call ? call->getCalledFunction() : nullptr;
      if (!callee || callee->isDeclaration() || done.contains(callee))
        continue;
      if (path.contains(callee)) {
        report(*call, *callee);
        return false;
      }
      if (!visit(*callee))
        return false;
    }
    path.remove(&function);
    done.insert(&function);
    return true;
  }

private:
  void report(CallBase &call, Function &callee) {
    std::string cycle;
    auto *first = find(path, &callee);
    for (Function *function : make_range(first, path.end()))
      cycle += function->getName().str() + " → ";
    session.diags.error(stc::positionOf(call),
                        "recursion, which shaders cannot have: " + cycle + callee.getName());
  }

  Session &session;
  SmallSetVector<Function *, 16> path;
  SmallPtrSet<Function *, 32> done;
};

} // namespace

bool refuseRecursion(Session &session, Function &root) {
  return RecursionFinder(session).visit(root);
}

uint64_t expandedInstructions(const Function &root) {
  DenseMap<const Function *, uint64_t> known;
  auto count = [&known](auto &count, const Function &function) -> uint64_t {
    if (auto found = known.find(&function); found != known.end())
      return found->second;
    uint64_t result = 0;
    for (const Instruction &instruction : instructions(function)) {
      ++result;
      auto *call = dyn_cast<CallBase>(&instruction);
      if (const Function *callee = call ? call->getCalledFunction() : nullptr)
        result += count(count, *callee);
    }
    return known[&function] = result;
  };
  return count(count, root);
}

SmallSetVector<Function *, 8> reachableFrom(ArrayRef<Function *> roots) {
  SmallSetVector<Function *, 8> reached;
  reached.insert(roots.begin(), roots.end());
  for (unsigned i = 0; i < reached.size(); ++i)
    for (Instruction &instruction : instructions(reached[i]))
      if (auto *call = dyn_cast<CallBase>(&instruction))
        if (Function *callee = call->getCalledFunction(); callee && !callee->isDeclaration())
          reached.insert(callee);
  return reached;
}

std::vector<std::string> callsIn(const Function &function) {
  SetVector<StringRef> names;
  for (const Instruction &instruction : instructions(function)) {
    auto *call = dyn_cast<CallBase>(&instruction);
    if (!call || isa<IntrinsicInst>(call))
      continue;
    const Function *callee = call->getCalledFunction();
    names.insert(callee ? callee->getName() : "a service");
  }
  return {names.begin(), names.end()};
}

} // namespace anysl::link
