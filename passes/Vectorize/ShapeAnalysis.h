//===-- passes/Vectorize/ShapeAnalysis.h - shapes of values, divergence of control --*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_SHAPEANALYSIS_H
#define ANYSL_PASSES_VECTORIZE_SHAPEANALYSIS_H

#include "passes/Vectorize/Shape.h"

#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/DenseSet.h"
#include "llvm/Analysis/AssumptionCache.h"
#include "llvm/Analysis/LoopInfo.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/Operator.h"

namespace anysl {

/// Finds which values differ between lanes, and where lanes part and meet again.
///
/// Needs a function as `normalize` leaves it: reducible, loops with preheader, one latch and exits
/// of their own, closed SSA, no switches. Three things make a value differ: its operands; for a
/// phi, paths on which lanes come from different sides of a divergent branch; and leaving a loop at
/// different times with a value that changes from iteration to iteration.
class ShapeAnalysis {
public:
  ShapeAnalysis(const llvm::Function &function, const llvm::LoopInfo &loops,
                const llvm::DominatorTree &dominators, llvm::AssumptionCache &assumptions,
                llvm::ArrayRef<Shape> argumentShapes, unsigned width);

  unsigned lanes() const { return width; }
  Shape shapeOf(const llvm::Value *value) const;
  /// Whether lanes may take different successors here at the same time.
  bool isDivergentBranch(const llvm::BasicBlock *block) const {
    return divergentBranches.contains(block);
  }
  /// Whether lanes may leave in different iterations.
  bool isDivergentLoop(const llvm::Loop *loop) const { return divergentLoops.contains(loop); }
  /// Makes a loop divergent that the schedule cannot run otherwise, and repeats the analysis.
  void forceDivergent(const llvm::Loop *loop);

  void print(llvm::raw_ostream &out) const;

private:
  void run();
  bool visit(const llvm::Instruction &instruction);
  Shape transfer(const llvm::Instruction &instruction) const;
  Shape transferPhi(const llvm::PHINode &phi) const;
  Shape transferCall(const llvm::CallBase &call) const;
  Shape transferArithmetic(const llvm::BinaryOperator &op) const;
  Shape transferGep(const llvm::GEPOperator &gep, const llvm::Instruction &at) const;
  unsigned zerosOf(const llvm::Value *value, const llvm::Instruction &at) const;
  void branchDiverges(const llvm::BasicBlock *block);
  void loopDiverges(const llvm::Loop *loop);
  void propagate(llvm::ArrayRef<const llvm::BasicBlock *> starts, const llvm::BasicBlock *root,
                 const llvm::Loop *around);

  const llvm::Function &function;
  const llvm::LoopInfo &loops;
  const llvm::DominatorTree &dominators;
  llvm::AssumptionCache &assumptions;
  unsigned width;
  llvm::SmallVector<const llvm::BasicBlock *, 32> order; ///< reverse post-order
  llvm::DenseMap<const llvm::BasicBlock *, unsigned> position;
  llvm::DenseMap<const llvm::Value *, Shape> shapes;
  llvm::DenseSet<const llvm::BasicBlock *> divergentBranches;
  llvm::DenseSet<const llvm::Loop *> divergentLoops;
  llvm::DenseSet<const llvm::BasicBlock *> joins; ///< blocks in which parted lanes may meet
};

/// Whether a call can be made once for all lanes when its arguments are the same for all.
bool isReplaceableByOne(const llvm::CallBase &call);

} // namespace anysl

#endif
