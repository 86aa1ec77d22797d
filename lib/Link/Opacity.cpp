//===-- lib/Link/Opacity.cpp - surfaces that leave opacity alone --------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Needs.h"
#include "lib/Link/Prune.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/InstIterator.h"
#include <anysl/abi.h>

using namespace llvm;

namespace anysl::link {

using stc::Op;
using stc::ParamKind;

namespace {

class OpacitySearch {
public:
  explicit OpacitySearch(Function &body) : dominators(body) {}

  /// Whether every value that a variable is given is Os or Oi as they came, and it has one before
  /// it is read.
  bool holdsOpacity(const Value *slot, const Instruction &reader) {
    bool isSet = false;
    for (const User *user : slot->users()) {
      auto *call = dyn_cast<CallInst>(user);
      const stc::OpInfo *op = call ? opOf(*call) : nullptr;
      if (!op || op->op == Op::element)
        return false;
      bool isWritten = any_of(zip_equal(op->params, call->args()), [slot](auto pair) {
        auto [param, operand] = pair;
        return operand == slot && param.isValue() && param.kind != ParamKind::In;
      });
      if (!isWritten)
        continue;
      bool isLoad = op->op == Op::load_global_color &&
                    (idOf(*call, *op) == ANYSL_Os || idOf(*call, *op) == ANYSL_Oi);
      if (!isLoad && op->op != Op::copy_color)
        return false;
      isSet |= dominators.dominates(call, &reader);
      if (!isLoad && seen.insert(call).second && !holdsOpacity(call->getArgOperand(1), *call))
        return false;
    }
    return isSet && isa<CallInst>(slot);
  }

private:
  DominatorTree dominators;
  SmallPtrSet<const CallInst *, 8> seen; ///< copies, each of which is looked at once
};

} // namespace

bool keepsOpacity(Function &body) {
  OpacitySearch search(body);
  return all_of(instructions(body), [&](const Instruction &instruction) {
    const stc::OpInfo *op = opOf(instruction);
    if (!op || op->purity != stc::Purity::Writes || idKind(*op) != stc::IdKind::Global)
      return true;
    auto &call = cast<CallInst>(instruction);
    return idOf(call, *op) != ANYSL_Oi || search.holdsOpacity(call.getArgOperand(2), call);
  });
}

} // namespace anysl::link
