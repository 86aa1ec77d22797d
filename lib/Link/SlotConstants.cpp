//===-- lib/Link/SlotConstants.cpp - which variables of threaded code are constants -*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/SlotConstants.h"
#include "llvm/ADT/PostOrderIterator.h"
#include "llvm/Analysis/ConstantFolding.h"
#include "llvm/IR/CFG.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/Module.h"
#include <cstring>

using namespace llvm;

namespace anysl::link {

using stc::Op;
using stc::ParamKind;

namespace {

std::string textOf(const Value *value) {
  auto *global = cast<GlobalVariable>(value);
  auto *data = dyn_cast<ConstantDataArray>(global->getInitializer());
  return data ? data->getAsCString().str() : std::string();
}

/// An oracle's number or a condition as LLVM's value.
Constant *makeInteger(const Value &like, uint64_t number) {
  return ConstantInt::get(like.getType(), number);
}

void add(std::set<std::string> &to, const std::set<std::string> &from) {
  to.insert(from.begin(), from.end());
}

} // namespace

bool SlotValue::operator==(const SlotValue &other) const {
  return text == other.text && numbers.size() == other.numbers.size() &&
         std::memcmp(numbers.data(), other.numbers.data(), numbers.size() * sizeof(double)) == 0;
}

SlotConstants::SlotConstants(Function &function, StringRef real, Oracle oracle)
    : function(function), oracle(std::move(oracle)) {
  // What of intervals and arbitrary precision? Their numbers are no doubles.
  arithmetic = real == "float" || real == "dual" || real == "dual2" ? Arithmetic::Float
               : real == "double" || real == "dualdouble" || real == "dual2double"
                   ? Arithmetic::Double
                   : Arithmetic::None;
  reached.insert(&function.getEntryBlock());
  ReversePostOrderTraversal<Function *> order(&function);
  for (bool changed = true; changed;) {
    changed = false;
    for (BasicBlock *block : order)
      if (isReached(block))
        changed |= visit(*block);
  }
}

std::optional<SlotValue> SlotConstants::before(const CallInst &call, const Value *slot) const {
  auto state = enter(*call.getParent());
  if (!state)
    return std::nullopt;
  // The last call before that changes it; what it makes of it is in `left` only at the block's end,
  // so the block is gone through again.
  auto &self = const_cast<SlotConstants &>(*this);
  for (Instruction &instruction : *const_cast<BasicBlock *>(call.getParent())) {
    if (&instruction == &call)
      break;
    if (auto *other = dyn_cast<CallInst>(&instruction))
      self.visitCall(*other, *state);
  }
  auto found = state->find(slot);
  return found == state->end() ? std::nullopt : std::optional(found->second);
}

Constant *SlotConstants::constantOf(Value *value) const {
  if (auto *constant = dyn_cast<Constant>(value))
    return constant;
  auto found = facts.find(value);
  return found == facts.end() ? nullptr : found->second.constant;
}

const std::set<std::string> &SlotConstants::causesOf(const Value *value) const {
  static const std::set<std::string> none;
  auto found = facts.find(value);
  return found == facts.end() ? none : found->second.causes;
}

bool SlotConstants::set(Value &value, Constant *constant, const std::set<std::string> &causes) {
  auto [entry, isNew] = facts.try_emplace(&value, Fact{constant, causes});
  if (isNew)
    return true;
  if (!entry->second.constant || entry->second.constant == constant)
    return false;
  entry->second = {};
  return true;
}

bool SlotConstants::reach(const BasicBlock &from, const BasicBlock &to) {
  bool isNew = edges.insert({&from, &to}).second;
  return reached.insert(&to).second || isNew;
}

/// What all ways into a block agree on; nothing where none has been gone yet.
std::optional<SlotConstants::State> SlotConstants::enter(const BasicBlock &block) const {
  if (&block == &function.getEntryBlock())
    return State();
  std::optional<State> result;
  for (const BasicBlock *from : predecessors(&block)) {
    auto state = left.find(from);
    if (!edges.contains({from, &block}) || state == left.end())
      continue;
    if (!result) {
      result = state->second;
      continue;
    }
    for (auto entry = result->begin(); entry != result->end();) {
      auto other = state->second.find(entry->first);
      if (other == state->second.end() || !(other->second == entry->second)) {
        entry = result->erase(entry);
        continue;
      }
      add(entry->second.causes, other->second.causes);
      ++entry;
    }
  }
  return result;
}

bool SlotConstants::visitPhi(PHINode &phi) {
  bool changed = false;
  std::set<std::string> causes;
  for (unsigned i = 0; i < phi.getNumIncomingValues(); ++i) {
    if (!edges.contains({phi.getIncomingBlock(i), phi.getParent()}))
      continue;
    Value *value = phi.getIncomingValue(i);
    bool isConstant = isa<Constant>(value);
    if (!isConstant && !facts.contains(value))
      continue; // not computed yet
    changed |= set(phi, constantOf(value), causesOf(value));
  }
  return changed;
}

bool SlotConstants::visit(BasicBlock &block) {
  auto state = enter(block);
  if (!state)
    return false;
  bool changed = false;
  for (Instruction &instruction : block) {
    if (auto *phi = dyn_cast<PHINode>(&instruction)) {
      changed |= visitPhi(*phi);
    } else if (auto *call = dyn_cast<CallInst>(&instruction)) {
      changed |= visitCall(*call, *state);
    } else if (!instruction.isTerminator()) {
      SmallVector<Constant *> operands;
      std::set<std::string> causes;
      bool waits = false;
      for (Value *operand : instruction.operands()) {
        waits |= !isa<Constant>(operand) && !facts.contains(operand);
        operands.push_back(constantOf(operand));
        add(causes, causesOf(operand));
      }
      if (waits)
        continue;
      bool all = !is_contained(operands, nullptr);
      const DataLayout &layout = function.getParent()->getDataLayout();
      Constant *folded =
          !all ? nullptr
          : isa<CmpInst>(instruction)
              ? ConstantFoldCompareInstOperands(cast<CmpInst>(instruction).getPredicate(),
                                                operands[0], operands[1], layout)
              : ConstantFoldInstOperands(&instruction, operands, layout);
      // Of `and` and `or` one side may decide.
      if (!folded && instruction.isBitwiseLogicOp())
        for (auto [i, operand] : enumerate(operands))
          if (operand && (instruction.getOpcode() == Instruction::And  ? operand->isNullValue()
                          : instruction.getOpcode() == Instruction::Or ? operand->isAllOnesValue()
                                                                       : false)) {
            folded = operand;
            causes = causesOf(instruction.getOperand(unsigned(i)));
          }
      changed |= set(instruction, folded, causes);
    }
  }
  auto [entry, isNew] = left.try_emplace(&block, *state);
  if (!isNew && entry->second != *state) {
    entry->second = std::move(*state);
    changed = true;
  }
  changed |= isNew;
  auto *branch = dyn_cast<BranchInst>(block.getTerminator());
  if (branch && branch->isConditional()) {
    Value *condition = branch->getCondition();
    if (!isa<Constant>(condition) && !facts.contains(condition))
      return changed;
    if (auto *constant = dyn_cast_or_null<ConstantInt>(constantOf(condition)))
      return reach(block, *branch->getSuccessor(constant->isZero() ? 1 : 0)) || changed;
  }
  for (BasicBlock *next : successors(&block))
    changed |= reach(block, *next);
  return changed;
}

bool SlotConstants::visitCall(CallInst &call, State &state) {
  const Function *callee = call.getCalledFunction();
  const stc::OpInfo *op = callee ? stc::opOfSymbol(callee->getName()) : nullptr;
  if (op && op->purity == stc::Purity::Structural)
    return false;
  if (!op) {
    for (Value *operand : call.args())
      state.erase(operand);
    return !call.getType()->isVoidTy() && set(call, nullptr, {});
  }
  std::optional<Known> known = oracle ? oracle(call, *op) : std::nullopt;
  SlotValue result;
  std::optional<bool> test;
  bool hasValue = evaluate(*op, call, state, result, test);
  if (MDNode *node = call.getMetadata(causeMetadata))
    result.causes.insert(cast<MDString>(node->getOperand(0))->getString().str());
  bool isFirst = true;
  for (auto [param, operand] : zip_equal(op->params, call.args())) {
    if (param.kind != ParamKind::Out && param.kind != ParamKind::InOut &&
        param.kind != ParamKind::Array)
      continue;
    // What a call that is known not to happen leaves alone.
    bool untouched = known && !known->value && param.kind != ParamKind::Out;
    if (known && known->value && param.kind == ParamKind::Out) {
      SlotValue value = *known->value;
      if (value.numbers.empty())
        value.numbers.assign(stc::info(param.type).components, 0);
      value.causes.insert(known->cause);
      state[operand] = std::move(value);
    } else if (hasValue && isFirst && param.kind == ParamKind::Out) {
      state[operand] = result;
    } else if (!untouched) {
      state.erase(operand);
    }
    isFirst = false;
  }
  if (call.getType()->isVoidTy())
    return false;
  if (known && known->result)
    return set(call, makeInteger(call, *known->result), {known->cause});
  return set(call, test ? makeInteger(call, *test) : nullptr, result.causes);
}

bool SlotConstants::evaluate(const stc::OpInfo &op, const CallInst &call, const State &state,
                             SlotValue &result, std::optional<bool> &test) const {
  SmallVector<const SlotValue *, 4> in;
  for (auto [param, operand] : zip_equal(op.params, call.args())) {
    if (param.kind != ParamKind::In)
      continue;
    auto found = state.find(operand);
    if (found == state.end())
      return false;
    in.push_back(&found->second);
    add(result.causes, found->second.causes);
  }
  auto rounded = [&](double number) {
    return arithmetic == Arithmetic::Float ? double(float(number)) : number;
  };
  auto x = [&](unsigned i) { return in[i]->numbers[0]; };
  auto isEqual = [&] { return in[0]->numbers == in[1]->numbers && in[0]->text == in[1]->text; };
  switch (op.op) {
  case Op::const_float: {
    double number = cast<ConstantFP>(call.getArgOperand(1))->getValueAPF().convertToDouble();
    // A number that the real may hold otherwise is not known.
    if (arithmetic == Arithmetic::None && double(float(number)) != number)
      return false;
    result.numbers = {rounded(number)};
    return true;
  }
  case Op::const_string:
    result.text = textOf(call.getArgOperand(1));
    return true;
  case Op::copy_float:
  case Op::copy_color:
  case Op::copy_vector:
  case Op::copy_string:
    result.numbers = in[0]->numbers;
    result.text = in[0]->text;
    return true;
  case Op::make_color:
  case Op::make_vector:
    result.numbers = {x(0), x(1), x(2)};
    return true;
  case Op::splat_color:
  case Op::splat_vector:
    result.numbers = {x(0), x(0), x(0)};
    return true;
  case Op::neg_float:
    result.numbers = {-x(0)};
    return true;
  case Op::float_from_test: {
    auto *truth = dyn_cast_or_null<ConstantInt>(constantOf(call.getArgOperand(1)));
    if (!truth)
      return false;
    add(result.causes, causesOf(call.getArgOperand(1)));
    result.numbers = {truth->isZero() ? 0. : 1.};
    return true;
  }
  case Op::add_float:
  case Op::sub_float:
  case Op::mul_float: {
    if (arithmetic == Arithmetic::None)
      return false;
    // Exact in double, and then rounded once, for a float's sum and product.
    double value = op.op == Op::add_float   ? x(0) + x(1)
                   : op.op == Op::sub_float ? x(0) - x(1)
                                            : x(0) * x(1);
    result.numbers = {rounded(value)};
    return true;
  }
  case Op::lt_float:
    test = x(0) < x(1);
    return false;
  case Op::le_float:
    test = x(0) <= x(1);
    return false;
  case Op::gt_float:
    test = x(0) > x(1);
    return false;
  case Op::ge_float:
    test = x(0) >= x(1);
    return false;
  case Op::eq_float:
  case Op::eq_color:
  case Op::eq_vector:
  case Op::eq_string:
    test = isEqual();
    return false;
  case Op::ne_float:
  case Op::ne_color:
  case Op::ne_vector:
  case Op::ne_string:
    test = !isEqual();
    return false;
  default:
    return false;
  }
}

} // namespace anysl::link
