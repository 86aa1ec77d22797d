//===-- passes/Vectorize/Schedule.h - partial linearisation -------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_SCHEDULE_H
#define ANYSL_PASSES_VECTORIZE_SCHEDULE_H

#include "passes/Vectorize/ShapeAnalysis.h"

namespace anysl {

/// Decides how control flows in the widened function: which branches stay, in which order the sides
/// of the others run, where empty sides are jumped over, and what is known of each block's mask.
///
/// After "Partial Control-Flow Linearization" (Moll & Hack, PLDI 2018). Blocks are numbered such
/// that edges lead forward, but for a loop's; that a loop's blocks are consecutive; and, within
/// that, that the blocks that a block dominates are. Wherever lanes may part, the first of the
/// targets runs next and the others become *pending*: the lanes bound for them wait until their
/// number comes.
class Schedule {
public:
  static constexpr unsigned None = ~0u;

  enum class Exit {
    Return,
    Unreachable,
    Jump,   ///< to next[0]
    Branch, ///< by a condition that is the same for all lanes: next[0] if true, next[1] if false
    RepeatIfAny ///< of a divergent loop: to its header if any lane goes on, else next[0]
  };

  struct Plan {
    const llvm::BasicBlock *block = nullptr;
    /// Blocks for which lanes may wait while this one runs, in order.
    llvm::SmallVector<unsigned, 4> pending;
    /// Whether to jump to `skipTo` when no lane is active here.
    bool guarded = false;
    unsigned skipTo = None;
    /// What is known of the mask past the guard: some lane is active; all are.
    bool occupied = false;
    bool full = false;
    /// The block whose mask this one has.
    unsigned leader = None;
    /// Where it takes fewer operations than to collect the lanes that come: the mask is that of the
    /// block `above` without the lanes that take one of these edges. None if `above` is None.
    unsigned above = None;
    llvm::SmallVector<std::pair<unsigned, unsigned>, 2> without;
    Exit exit = Exit::Jump;
    unsigned next[2] = {None, None};
  };

  /// \p startsFull: all lanes are active when the function starts; otherwise at least one is.
  Schedule(const llvm::Function &function, const llvm::LoopInfo &loops,
           const llvm::DominatorTree &dominators, ShapeAnalysis &shapes, bool startsFull);

  llvm::ArrayRef<Plan> plans() const { return list; }
  const Plan &plan(unsigned index) const { return list[index]; }
  unsigned indexOf(const llvm::BasicBlock *block) const { return indices.lookup(block); }
  /// Whether, in the widened function, the body of block \p a runs on every path to the body of \p
  /// b.
  bool dominates(unsigned a, unsigned b) const;

  void print(llvm::raw_ostream &out) const;

private:
  bool build();
  void order(const llvm::Loop *level);
  void reset();
  unsigned route(unsigned from, llvm::SmallVector<unsigned, 8> targets, unsigned direct);
  void addEdge(unsigned fromNode, unsigned to, bool direct, bool occupied, bool full);
  unsigned leaderOf(unsigned index) const;
  bool alwaysMeets(const llvm::BasicBlock *from, const llvm::BasicBlock *to,
                   const llvm::Loop *loop) const;
  void subtractLeavers(unsigned index);
  bool needsLane(unsigned index) const;
  unsigned idleCost(const llvm::Instruction &instruction) const;
  bool isWorthGuard(unsigned index) const;
  bool dominatesNode(unsigned a, unsigned b) const;

  const llvm::Function &function;
  const llvm::LoopInfo &loops;
  const llvm::DominatorTree &dominators;
  ShapeAnalysis &shapes;
  bool startsFull;

  llvm::SmallVector<const llvm::BasicBlock *, 32> sequence;
  llvm::DenseMap<const llvm::BasicBlock *, unsigned> indices;
  llvm::DenseMap<const llvm::BasicBlock *, unsigned> reversePostOrder;
  llvm::SmallVector<Plan, 32> list;

  // Each block has two nodes in the new control flow, 2i where it is entered and 2i + 1 its body
  // past the guard. Edges come in order, so the dominator tree grows along.
  struct Node {
    unsigned parent = None;
    unsigned depth = 0;
    bool reached = false;
    bool direct = true, occupied = true, full = true; ///< of all edges that lead here
  };
  llvm::SmallVector<Node, 64> nodes;
};

/// Whether an instruction may run for lanes that are not active, on whatever they hold. A function
/// that is declared so may be called early, but not with arguments that no lane has computed.
bool isHarmless(const llvm::Instruction &instruction);

/// Whether an instruction of this shape runs as one scalar instruction that must not run when no
/// lane is active: it may trap, or touches memory.
bool needsActiveLane(const llvm::Instruction &instruction, const ShapeAnalysis &shapes);

} // namespace anysl

#endif
