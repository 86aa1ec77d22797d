//===-- passes/Vectorize/Schedule.cpp - partial linearisation ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// One invariant carries everything: when block b runs, every active lane of the function is in b or
// waits in a pending block. So a block with nothing pending has an active lane; no lane is lost,
// because pending blocks are handed on along every edge until their number comes; and a lane runs
// its blocks in an order that its own scalar run would have taken, because edges only lead forward.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Schedule.h"

#include "llvm/ADT/PostOrderIterator.h"
#include "llvm/Analysis/ValueTracking.h"
#include "llvm/IR/CFG.h"
#include "llvm/IR/IntrinsicInst.h"

using namespace llvm;

namespace anysl {

Schedule::Schedule(const Function &function, const LoopInfo &loops, const DominatorTree &dominators,
                   ShapeAnalysis &shapes, bool startsFull)
    : function(function), loops(loops), dominators(dominators), shapes(shapes),
      startsFull(startsFull) {
  for (const BasicBlock *block : ReversePostOrderTraversal<const Function *>(&function))
    reversePostOrder[block] = reversePostOrder.size();
  order(nullptr);
  // The one block that returns has no successor and may come last, when nobody can be waiting.
  auto returns = find_if(
      sequence, [](const BasicBlock *block) { return isa<ReturnInst>(block->getTerminator()); });
  if (returns != sequence.end())
    std::rotate(returns, returns + 1, sequence.end());
  for (auto [index, block] : enumerate(sequence))
    indices[block] = index;
  while (!build())
    reset();
  for (unsigned index = 0; index < list.size(); ++index)
    subtractLeavers(index);
}

//===-- Order ---------------------------------------------------------------===//

/// The block that stands for \p block where \p level's inner loops count as one block each.
static const BasicBlock *nodeAt(const BasicBlock *block, const Loop *level, const LoopInfo &loops) {
  const Loop *loop = loops.getLoopFor(block);
  const BasicBlock *node = block;
  while (loop != level) {
    node = loop->getHeader();
    loop = loop->getParentLoop();
  }
  return node;
}

/// Walks the dominator tree of one loop level in pre-order, the children of a node in reverse
/// post-order. An edge between two subtrees enters the second at its root, so this is a topological
/// order.
void Schedule::order(const Loop *level) {
  DenseMap<const BasicBlock *, SmallVector<const BasicBlock *, 4>> children;
  const BasicBlock *root = level ? level->getHeader() : &function.getEntryBlock();
  auto consider = [&](const BasicBlock *node) {
    if (node == root)
      return;
    const BasicBlock *parent = dominators.getNode(node)->getIDom()->getBlock();
    children[nodeAt(parent, level, loops)].push_back(node);
  };
  ArrayRef<BasicBlock *> inLoop = level ? level->getBlocks() : ArrayRef<BasicBlock *>();
  auto considerBlock = [&](const BasicBlock *block) {
    if (dominators.isReachableFromEntry(block) && nodeAt(block, level, loops) == block)
      consider(block);
  };
  if (level)
    for (const BasicBlock *block : inLoop)
      considerBlock(block);
  else
    for (const BasicBlock &block : function)
      considerBlock(&block);
  for (auto &entry : children)
    sort(entry.second, [&](const BasicBlock *a, const BasicBlock *b) {
      return reversePostOrder.lookup(a) < reversePostOrder.lookup(b);
    });

  SmallVector<const BasicBlock *, 16> stack = {root};
  while (!stack.empty()) {
    const BasicBlock *node = stack.pop_back_val();
    if (loops.getLoopFor(node) == level)
      sequence.push_back(node);
    else
      order(loops.getLoopFor(node));
    for (const BasicBlock *child : reverse(children[node]))
      stack.push_back(child);
  }
}

//===-- Dominance in the new control flow -----------------------------------===//

bool Schedule::dominatesNode(unsigned a, unsigned b) const {
  while (nodes[b].depth > nodes[a].depth)
    b = nodes[b].parent;
  return a == b;
}

bool Schedule::dominates(unsigned a, unsigned b) const {
  return dominatesNode(2 * a + 1, 2 * b + 1);
}

void Schedule::addEdge(unsigned fromNode, unsigned to, bool direct, bool occupied, bool full) {
  Node &node = nodes[2 * to];
  if (!node.reached) {
    node.parent = fromNode;
  } else {
    unsigned a = node.parent, b = fromNode;
    while (a != b) {
      if (nodes[a].depth < nodes[b].depth)
        std::swap(a, b);
      a = nodes[a].parent;
    }
    node.parent = a;
  }
  node.reached = true;
  node.depth = nodes[node.parent].depth + 1;
  node.direct &= direct;
  node.occupied &= direct && occupied;
  node.full &= direct && full;
}

//===-- Guards --------------------------------------------------------------===//

bool isHarmless(const Instruction &instruction) {
  if (isa<CallBase>(instruction) && !isa<IntrinsicInst>(instruction))
    return false;
  return isSafeToSpeculativelyExecute(&instruction);
}

bool needsActiveLane(const Instruction &instruction, const ShapeAnalysis &shapes) {
  if (const auto *load = dyn_cast<LoadInst>(&instruction))
    return shapes.shapeOf(load->getPointerOperand()).isUniform();
  if (const auto *store = dyn_cast<StoreInst>(&instruction))
    return shapes.shapeOf(store->getPointerOperand()).isUniform();
  if (const auto *call = dyn_cast<CallBase>(&instruction)) {
    if (isa<DbgInfoIntrinsic>(call) || isa<AssumeInst>(call))
      return false;
    return !isHarmless(*call);
  }
  switch (instruction.getOpcode()) {
  case Instruction::UDiv:
  case Instruction::SDiv:
  case Instruction::URem:
  case Instruction::SRem:
    return shapes.shapeOf(&instruction).isUniform() && !isHarmless(instruction);
  case Instruction::Fence:
    return true;
  default:
    return false;
  }
}

bool Schedule::needsLane(unsigned index) const {
  const BasicBlock *block = sequence[index];
  for (const Instruction &instruction : *block)
    if (needsActiveLane(instruction, shapes))
      return true;
  // An empty mask must not enter a loop: what ends it may be undefined.
  for (const BasicBlock *successor : successors(block))
    if (const Loop *loop = loops.getLoopFor(successor);
        loop && loop->getHeader() == successor && !loop->contains(block))
      return true;
  return false;
}

/// From which cost on a region is jumped over when it is empty: what a test and, now and then, a
/// mispredicted jump cost. In halves of a cycle, as the costs are.
static constexpr unsigned guardLimit = 24;

/// What an instruction costs for all lanes, in halves of a cycle as processors of today have it:
/// they begin two vector operations a cycle, but divide, take roots and gather part by part.
unsigned Schedule::idleCost(const Instruction &instruction) const {
  if (isa<PHINode>(instruction) || isa<DbgInfoIntrinsic>(instruction) ||
      shapes.shapeOf(&instruction).isUniform())
    return 0;
  // Divisions and roots of 16 bytes come out every 4 and 6 cycles, of wider registers less often.
  unsigned bits = unsigned(instruction.getType()->getScalarSizeInBits()) * shapes.lanes();
  unsigned parts = std::max(1u, bits / 128);
  switch (instruction.getOpcode()) {
  case Instruction::Call:
    if (const auto *call = dyn_cast<IntrinsicInst>(&instruction))
      if (call->getIntrinsicID() == Intrinsic::sqrt)
        return 12 * parts;
    return isHarmless(instruction) ? 4 : guardLimit;
  case Instruction::FDiv:
    return 8 * parts;
  case Instruction::FRem:
  case Instruction::UDiv:
  case Instruction::SDiv:
  case Instruction::URem:
  case Instruction::SRem:
    return guardLimit;
  case Instruction::Load:
  case Instruction::Store:
    return shapes.shapeOf(getLoadStorePointerOperand(&instruction)).isVarying()
               ? std::max(6u, 3 * shapes.lanes() / 2)
               : 6;
  default:
    return 1;
  }
}

/// Whether jumping over a region costs less than running it idle.
bool Schedule::isWorthGuard(unsigned index) const {
  unsigned cost = 0;
  for (unsigned i = index; i < sequence.size() && cost < guardLimit; ++i) {
    if (!dominators.dominates(sequence[index], sequence[i]))
      break;
    for (const Instruction &instruction : *sequence[i])
      cost += idleCost(instruction);
  }
  return cost >= guardLimit;
}

//===-- The schedule --------------------------------------------------------===//

void Schedule::reset() {
  list.clear();
  nodes.clear();
}

/// Whether every path from \p from meets \p to before it leaves the loop around both or begins its
/// next iteration. (Post-dominance is not enough: a path may leave the loop and come back to it.)
bool Schedule::alwaysMeets(const BasicBlock *from, const BasicBlock *to, const Loop *loop) const {
  SmallVector<const BasicBlock *, 16> stack = {from};
  SmallPtrSet<const BasicBlock *, 16> seen = {from};
  while (!stack.empty()) {
    const BasicBlock *block = stack.pop_back_val();
    if (succ_empty(block))
      return false;
    for (const BasicBlock *next : successors(block)) {
      if (next == to)
        continue;
      if (loop && (!loop->contains(next) || next == loop->getHeader()))
        return false;
      if (seen.insert(next).second)
        stack.push_back(next);
    }
  }
  return true;
}

unsigned Schedule::leaderOf(unsigned index) const {
  const BasicBlock *block = sequence[index];
  const Loop *loop = loops.getLoopFor(block);
  if (loop && loop->getHeader() == block) {
    // Lanes stay in a uniform loop together, so each iteration has the mask that entered.
    return shapes.isDivergentLoop(loop) ? index : list[indexOf(loop->getLoopPreheader())].leader;
  }
  for (auto *node = dominators.getNode(block)->getIDom(); node; node = node->getIDom()) {
    if (loops.getLoopFor(node->getBlock()) != loop)
      continue;
    // Every lane that was there comes here, and nobody else.
    if (alwaysMeets(node->getBlock(), block, loop))
      return list[indexOf(node->getBlock())].leader;
    break;
  }
  return index;
}

/// Whoever is in the dominator comes to the block, or leaves the way to it by one of the edges from
/// a block that leads there to one that does not. Where fewer edges leave than arrive, such as
/// below a `switch` of which one case continues the loop, masks need fewer operations and, as those
/// of the cases are not waited for, come sooner.
void Schedule::subtractLeavers(unsigned index) {
  Plan &plan = list[index];
  const Loop *loop = loops.getLoopFor(plan.block);
  if (plan.leader != index || plan.full || index == 0 || (loop && loop->getHeader() == plan.block))
    return;
  auto *node = dominators.getNode(plan.block)->getIDom();
  while (node && loops.getLoopFor(node->getBlock()) != loop)
    node = node->getIDom();
  if (!node)
    return;
  const BasicBlock *above = node->getBlock();
  SmallPtrSet<const BasicBlock *, 16> leading = {above};
  SmallVector<const BasicBlock *, 16> stack = {plan.block};
  unsigned arriving = pred_size(plan.block);
  while (!stack.empty())
    for (const BasicBlock *before : predecessors(stack.pop_back_val()))
      if (dominators.isReachableFromEntry(before) && leading.insert(before).second)
        stack.push_back(before);
  SmallVector<std::pair<unsigned, unsigned>, 2> leaving;
  for (const BasicBlock *block : leading)
    for (const BasicBlock *next : successors(block))
      if (next != plan.block && !leading.contains(next))
        leaving.push_back({indexOf(block), indexOf(next)});
  if (leaving.empty() || leaving.size() >= arriving)
    return;
  sort(leaving);
  plan.above = indexOf(above);
  plan.without = leaving;
}

/// Sends the lanes bound for \p targets on: the first runs next, for the others they wait. \p
/// direct is the one target that all lanes at \p from are bound for, if there is one.
unsigned Schedule::route(unsigned from, SmallVector<unsigned, 8> targets, unsigned direct) {
  sort(targets);
  targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
  unsigned next = targets.front();
  auto &pending = list[next].pending;
  pending.append(targets.begin() + 1, targets.end());
  sort(pending);
  pending.erase(std::unique(pending.begin(), pending.end()), pending.end());
  addEdge(2 * from + 1, next, next == direct, list[from].occupied, list[from].full);
  return next;
}

/// Returns false if a loop had to be made divergent on the way.
bool Schedule::build() {
  list.resize(sequence.size());
  nodes.resize(2 * sequence.size());
  for (unsigned index = 0; index < sequence.size(); ++index) {
    const BasicBlock *block = sequence[index];
    const Loop *loop = loops.getLoopFor(block);
    Plan &plan = list[index];
    plan.block = block;
    plan.leader = leaderOf(index);
    Node &entered = nodes[2 * index];
    bool isHeader = loop && loop->getHeader() == block;
    if (index == 0) {
      entered.reached = true;
      entered.full = startsFull;
    }
    assert(entered.reached && "a block without a way in");
    if (isHeader && shapes.isDivergentLoop(loop)) {
      // Lanes that left in an earlier iteration wait for the loop's exits.
      entered.full = false;
      SmallVector<BasicBlock *, 4> exits;
      loop->getUniqueExitBlocks(exits);
      for (BasicBlock *exit : exits)
        plan.pending.push_back(indexOf(exit));
      sort(plan.pending);
      plan.pending.erase(std::unique(plan.pending.begin(), plan.pending.end()), plan.pending.end());
    }
    if (plan.leader != index && dominatesNode(2 * plan.leader + 1, 2 * index)) {
      entered.occupied |= list[plan.leader].occupied;
      entered.full |= list[plan.leader].full;
    }
    entered.occupied |= plan.pending.empty();

    if (!entered.occupied && !plan.pending.empty() && (needsLane(index) || isWorthGuard(index))) {
      plan.guarded = true;
      plan.skipTo = plan.pending.front();
      auto &handedOn = list[plan.skipTo].pending;
      handedOn.append(plan.pending.begin() + 1, plan.pending.end());
      sort(handedOn);
      handedOn.erase(std::unique(handedOn.begin(), handedOn.end()), handedOn.end());
      addEdge(2 * index, plan.skipTo, false, false, false);
    }
    plan.occupied = entered.occupied || plan.guarded;
    plan.full = entered.full;
    nodes[2 * index + 1] = entered;
    nodes[2 * index + 1].parent = 2 * index;
    nodes[2 * index + 1].depth = entered.depth + 1;

    // Where lanes go from here.
    SmallVector<unsigned, 8> waiting(plan.pending.begin(), plan.pending.end());
    const Instruction *terminator = block->getTerminator();
    SmallVector<unsigned, 8> added;
    bool isLatch = loop && loop->getLoopLatch() == block;
    if (isLatch && shapes.isDivergentLoop(loop)) {
      plan.exit = Exit::RepeatIfAny;
      for (const BasicBlock *successor : successors(block))
        if (successor != loop->getHeader())
          added.push_back(indexOf(successor));
      SmallVector<unsigned, 8> targets = waiting;
      targets.append(added);
      if (!targets.empty())
        plan.next[0] = route(index, targets, None);
      SmallVector<BasicBlock *, 4> exits;
      loop->getUniqueExitBlocks(exits);
      for (BasicBlock *exit : exits)
        added.push_back(indexOf(exit));
    } else if (isa<ReturnInst>(terminator)) {
      plan.exit = Exit::Return;
    } else if (const auto *branch = dyn_cast<BranchInst>(terminator)) {
      for (const BasicBlock *successor : successors(block))
        added.push_back(indexOf(successor));
      auto go = [&](ArrayRef<unsigned> to) {
        // Going round a uniform loop: its header knows already who waits.
        if (isLatch && to.size() == 1 && sequence[to[0]] == loop->getHeader())
          return to[0];
        SmallVector<unsigned, 8> targets = waiting;
        targets.append(to.begin(), to.end());
        return route(index, targets, to.size() == 1 ? to[0] : None);
      };
      if (branch->isConditional() && !shapes.isDivergentBranch(block)) {
        plan.exit = Exit::Branch;
        plan.next[0] = go(added[0]);
        plan.next[1] = go(added[1]);
      } else {
        plan.exit = Exit::Jump;
        plan.next[0] = go(added);
      }
    } else {
      plan.exit = Exit::Unreachable;
      if (!waiting.empty()) {
        plan.exit = Exit::Jump;
        plan.next[0] = route(index, waiting, None);
      }
    }

    // A uniform loop is left by all lanes at once: none may wait outside while others are inside.
    for (unsigned i = 0; i < added.size(); ++i) {
      unsigned next = plan.exit == Exit::Branch ? plan.next[i] : plan.next[0];
      for (const Loop *around = loop; around && next != None; around = around->getParentLoop())
        if (!shapes.isDivergentLoop(around) && around->contains(sequence[next]) &&
            !around->contains(sequence[added[i]])) {
          shapes.forceDivergent(around);
          return false;
        }
    }
  }
  return true;
}

//===-- Printing ------------------------------------------------------------===//

void Schedule::print(raw_ostream &out) const {
  auto nameOf = [&](unsigned index) { return sequence[index]->getName(); };
  out << "schedule of " << function.getName() << "\n";
  for (const Plan &plan : list) {
    unsigned index = &plan - list.data();
    out << plan.block->getName() << ":";
    if (plan.full)
      out << " full";
    else if (plan.occupied)
      out << " occupied";
    else
      out << " perhaps empty";
    if (plan.leader != index)
      out << ", mask of " << nameOf(plan.leader);
    if (plan.above != None) {
      out << ", mask of " << nameOf(plan.above) << " without";
      for (auto [from, to] : plan.without)
        out << " " << nameOf(from) << "->" << nameOf(to);
    }
    if (!plan.pending.empty()) {
      out << ", pending";
      for (unsigned pending : plan.pending)
        out << " " << nameOf(pending);
    }
    if (plan.guarded)
      out << ", skipped to " << nameOf(plan.skipTo);
    out << "\n";
    switch (plan.exit) {
    case Exit::Return:
      out << "  return\n";
      break;
    case Exit::Unreachable:
      out << "  unreachable\n";
      break;
    case Exit::Jump:
      out << "  jump " << nameOf(plan.next[0]) << "\n";
      break;
    case Exit::Branch:
      out << "  branch " << nameOf(plan.next[0]) << ", " << nameOf(plan.next[1]) << "\n";
      break;
    case Exit::RepeatIfAny:
      out << "  repeat if any, else " << (plan.next[0] == None ? "never" : nameOf(plan.next[0]))
          << "\n";
      break;
    }
  }
}

} // namespace anysl
