//===-- lib/Link/SlotConstants.h - which variables of threaded code are constants ---*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_SLOTCONSTANTS_H
#define ANYSL_LIB_LINK_SLOTCONSTANTS_H

#include "lib/STC/Reader.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/DenseSet.h"
#include "llvm/IR/Instructions.h"
#include <functional>
#include <map>
#include <set>

namespace anysl::link {

/// What a variable holds, and whose word that is.
struct SlotValue {
  std::vector<double> numbers; ///< empty: it is text
  std::string text;
  std::set<std::string> causes; ///< "Kr = 0 (scene.rib:12)"
  /// Bit by bit: -0 is not 0.
  bool operator==(const SlotValue &other) const;
};

/// The name of the metadata that says why an operator makes a constant.
inline constexpr llvm::StringLiteral causeMetadata = "anysl.cause";

/// Finds out, for one function of threaded code, which variables are constants where, and which
/// blocks are therefore never reached: sparse conditional constant propagation, whose lattice
/// covers variables as well as LLVM's own values. Arithmetic is done as the real does it, or not at
/// all.
class SlotConstants {
public:
  /// What is known of a call besides: the outcome of a test, or the value that it gives its first
  /// Out operand, 0 if that has no numbers. Either may be missing.
  struct Known {
    std::optional<uint64_t> result;
    std::optional<SlotValue> value;
    std::string cause;
  };
  using Oracle = std::function<std::optional<Known>(const llvm::CallInst &, const stc::OpInfo &)>;

  SlotConstants(llvm::Function &function, llvm::StringRef real, Oracle oracle);

  bool isReached(const llvm::BasicBlock *block) const { return reached.contains(block); }
  /// A variable's value just before a call; null if it is not known.
  std::optional<SlotValue> before(const llvm::CallInst &call, const llvm::Value *slot) const;
  /// The value of a test, condition or counter, if it is one constant.
  llvm::Constant *constantOf(llvm::Value *value) const;
  const std::set<std::string> &causesOf(const llvm::Value *value) const;

private:
  using State = std::map<const llvm::Value *, SlotValue>;
  struct Fact {
    llvm::Constant *constant = nullptr; ///< null: more than one
    std::set<std::string> causes;
  };

  bool visit(llvm::BasicBlock &block);
  std::optional<State> enter(const llvm::BasicBlock &block) const;
  bool visitPhi(llvm::PHINode &phi);
  bool visitCall(llvm::CallInst &call, State &state);
  bool evaluate(const stc::OpInfo &op, const llvm::CallInst &call, const State &state,
                SlotValue &result, std::optional<bool> &test) const;
  bool set(llvm::Value &value, llvm::Constant *constant, const std::set<std::string> &causes);
  bool reach(const llvm::BasicBlock &from, const llvm::BasicBlock &to);

  llvm::Function &function;
  enum class Arithmetic { Float, Double, None } arithmetic;
  Oracle oracle;
  llvm::DenseSet<const llvm::BasicBlock *> reached;
  llvm::DenseSet<std::pair<const llvm::BasicBlock *, const llvm::BasicBlock *>> edges;
  std::map<const llvm::BasicBlock *, State> left; ///< as a block leaves its variables
  llvm::DenseMap<const llvm::Value *, Fact> facts;
};

} // namespace anysl::link

#endif
