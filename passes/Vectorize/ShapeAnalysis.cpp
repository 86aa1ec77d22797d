//===-- passes/Vectorize/ShapeAnalysis.cpp - shapes of values, divergence of control ----------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// An optimistic fixed point: everything starts out unreached, shapes only fall from there, and each
// branch that turns out divergent makes phis fall where its sides meet. Meeting points are found by
// sending a label down each side (the idea of sync dependence, Karrenberg & Hack 2012; LLVM's
// UniformityAnalysis does the same): where two labels meet, lanes meet. If one side can reach the
// end of a loop's iteration with another label than an exit of it, lanes leave that loop at
// different times.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/ShapeAnalysis.h"

#include "passes/Vectorize/PrivateArrays.h"

#include "llvm/ADT/PostOrderIterator.h"
#include "llvm/Analysis/ValueTracking.h"
#include "llvm/IR/CFG.h"
#include "llvm/IR/DataLayout.h"
#include "llvm/IR/GetElementPtrTypeIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"
#include "llvm/Support/KnownBits.h"

#include <queue>

using namespace llvm;

namespace anysl {

ShapeAnalysis::ShapeAnalysis(const Function &function, const LoopInfo &loops,
                             const DominatorTree &dominators, AssumptionCache &assumptions,
                             ArrayRef<Shape> argumentShapes, unsigned width)
    : function(function), loops(loops), dominators(dominators), assumptions(assumptions),
      width(width) {
  for (const BasicBlock *block : ReversePostOrderTraversal<const Function *>(&function)) {
    position[block] = order.size();
    order.push_back(block);
  }
  for (auto [argument, shape] : zip(function.args(), argumentShapes))
    shapes[&argument] = shape;
  run();
}

void ShapeAnalysis::run() {
  bool changed = true;
  while (changed) {
    changed = false;
    for (const BasicBlock *block : order) {
      for (const Instruction &instruction : *block)
        changed |= visit(instruction);
      const auto *branch = dyn_cast<BranchInst>(block->getTerminator());
      if (branch && branch->isConditional() && !divergentBranches.contains(block)) {
        Shape condition = shapeOf(branch->getCondition());
        if (!condition.isUnknown() && !condition.isUniform()) {
          branchDiverges(block);
          changed = true;
        }
      }
    }
  }
}

void ShapeAnalysis::forceDivergent(const Loop *loop) {
  loopDiverges(loop);
  run();
}

Shape ShapeAnalysis::shapeOf(const Value *value) const {
  auto found = shapes.find(value);
  if (found != shapes.end())
    return found->second;
  return isa<Instruction>(value) || isa<Argument>(value) ? Shape() : Shape::uniform();
}

bool ShapeAnalysis::visit(const Instruction &instruction) {
  if (instruction.getType()->isVoidTy())
    return false;
  Shape &shape = shapes[&instruction];
  Shape before = shape;
  if (before.isVarying())
    return false;
  Shape after = Shape::join(before, transfer(instruction));
  shapes[&instruction] = after;
  return after != before;
}

//===-- Values --------------------------------------------------------------===//

/// How many low bits of lane 0's value are zero where the instruction runs for some lane.
unsigned ShapeAnalysis::zerosOf(const Value *value, const Instruction &at) const {
  Shape shape = shapeOf(value);
  // What holds in each lane by itself holds in lane 0 as far as it has the same low bits.
  KnownBits known = computeKnownBits(value, function.getParent()->getDataLayout(), 0, &assumptions,
                                     &at, &dominators);
  unsigned own = known.countMinTrailingZeros();
  if (!shape.isUniform())
    own = std::min<unsigned>(own, countr_zero(uint64_t(shape.stride())));
  return std::max(own, shape.zeros());
}

/// What instructions on integers make of strides, where lane values stay exact.
Shape ShapeAnalysis::transferArithmetic(const BinaryOperator &op) const {
  Shape a = shapeOf(op.getOperand(0)), b = shapeOf(op.getOperand(1));
  if (!op.getType()->isIntegerTy())
    return Shape::varying();
  bool noSigned = false, noUnsigned = false;
  if (const auto *flags = dyn_cast<OverflowingBinaryOperator>(&op)) {
    noSigned = flags->hasNoSignedWrap() && a.noSignedWrap() && b.noSignedWrap();
    noUnsigned = flags->hasNoUnsignedWrap() && a.noUnsignedWrap() && b.noUnsignedWrap();
  }
  const auto *constant = dyn_cast<ConstantInt>(op.getOperand(1));
  bool smallConstant = constant && constant->getValue().isSignedIntN(32);
  auto zeros = [&](unsigned i) { return zerosOf(op.getOperand(i), op); };
  int64_t stride;
  switch (op.getOpcode()) {
  case Instruction::Or:
    if (!cast<PossiblyDisjointInst>(op).isDisjoint())
      return Shape::varying();
    noSigned = a.noSignedWrap() && b.noSignedWrap();
    noUnsigned = a.noUnsignedWrap() && b.noUnsignedWrap();
    [[fallthrough]];
  case Instruction::Add:
    if (AddOverflow(a.stride(), b.stride(), stride))
      return Shape::varying();
    return Shape::strided(stride, noSigned, noUnsigned).aligned(std::min(zeros(0), zeros(1)));
  case Instruction::Sub:
    if (SubOverflow(a.stride(), b.stride(), stride))
      return Shape::varying();
    return Shape::strided(stride, noSigned, noUnsigned).aligned(std::min(zeros(0), zeros(1)));
  case Instruction::Mul:
    if (!smallConstant || MulOverflow(a.stride(), constant->getSExtValue(), stride))
      return Shape::varying();
    return Shape::strided(stride, noSigned, noUnsigned).aligned(zeros(0) + zeros(1));
  case Instruction::Shl:
    if (!smallConstant || constant->getValue().uge(31) ||
        MulOverflow(a.stride(), int64_t(1) << constant->getZExtValue(), stride))
      return Shape::varying();
    return Shape::strided(stride, noSigned, noUnsigned)
        .aligned(zeros(0) + unsigned(constant->getZExtValue()));
  default:
    return Shape::varying();
  }
}

Shape ShapeAnalysis::transferGep(const GEPOperator &gep, const Instruction &at) const {
  const DataLayout &layout = function.getParent()->getDataLayout();
  if (gep.getType()->isVectorTy())
    return Shape::varying();
  Shape base = shapeOf(gep.getPointerOperand());
  if (base.isUnknown())
    return Shape();
  if (base.isVarying())
    return Shape::varying();
  int64_t stride = base.stride();
  unsigned zeros = zerosOf(gep.getPointerOperand(), at);
  for (auto it = gep_type_begin(gep), end = gep_type_end(gep); it != end; ++it) {
    if (StructType *record = it.getStructTypeOrNull()) {
      unsigned field = cast<ConstantInt>(it.getOperand())->getZExtValue();
      uint64_t offset = layout.getStructLayout(record)->getElementOffset(field);
      zeros = std::min<unsigned>(zeros, countr_zero(offset));
      continue;
    }
    Shape index = shapeOf(it.getOperand());
    if (index.isUnknown())
      return Shape();
    TypeSize size = it.getSequentialElementStride(layout);
    if (index.isVarying() || size.isScalable())
      return Shape::varying();
    zeros = std::min<unsigned>(zeros, zerosOf(it.getOperand(), at) +
                                          countr_zero(uint64_t(size.getFixedValue())));
    if (index.isUniform())
      continue;
    // Narrow indices are sign-extended, which keeps a stride only if lanes do not wrap.
    unsigned bits = it.getOperand()->getType()->getIntegerBitWidth();
    bool wraps = bits < layout.getIndexTypeSizeInBits(gep.getType()) && !index.noSignedWrap();
    int64_t scaled;
    if (wraps || MulOverflow(index.stride(), int64_t(size.getFixedValue()), scaled) ||
        AddOverflow(stride, scaled, stride))
      return Shape::varying();
  }
  return Shape::strided(stride, false, false).aligned(zeros);
}

bool isReplaceableByOne(const CallBase &call) {
  if (call.isInlineAsm() || call.isConvergent() || call.getType()->isVoidTy())
    return false;
  if (const auto *intrinsic = dyn_cast<IntrinsicInst>(&call))
    switch (intrinsic->getIntrinsicID()) {
    case Intrinsic::stacksave:
    case Intrinsic::thread_pointer:
      return false;
    default:
      break;
    }
  // Raising a flag twice is no more than raising it once.
  if (isa<ConstrainedFPIntrinsic>(call))
    return true;
  return call.onlyReadsMemory() && call.doesNotThrow() && call.willReturn();
}

Shape ShapeAnalysis::transferCall(const CallBase &call) const {
  Shape joined = Shape::uniform();
  for (const Use &operand : call.args()) {
    Shape shape = shapeOf(operand);
    if (shape.isUnknown())
      return Shape();
    joined = Shape::join(joined, shape);
  }
  // What strides is joined to varying, as no call keeps a stride.
  if (!joined.isUniform() || !shapeOf(call.getCalledOperand()).isUniform())
    return Shape::varying();
  return isReplaceableByOne(call) ? Shape::uniform() : Shape::varying();
}

Shape ShapeAnalysis::transferPhi(const PHINode &phi) const {
  Shape joined;
  const Value *common = nullptr;
  bool isConstant = true;
  for (const Value *value : phi.incoming_values()) {
    if (value == &phi)
      continue;
    if (common && common != value)
      isConstant = false;
    common = value;
    joined = Shape::join(joined, shapeOf(value));
  }
  if (!joins.contains(phi.getParent()))
    return joined;
  if (!isConstant)
    return joined.isUnknown() ? Shape() : Shape::varying();
  // One value from all sides; it still differs between lanes that left its loop at different times.
  if (const auto *source = dyn_cast_or_null<Instruction>(common))
    for (const Loop *loop = loops.getLoopFor(source->getParent()); loop;
         loop = loop->getParentLoop())
      if (!loop->contains(phi.getParent()) && divergentLoops.contains(loop))
        return joined.isUnknown() ? Shape() : Shape::varying();
  return joined;
}

Shape ShapeAnalysis::transfer(const Instruction &instruction) const {
  if (const auto *phi = dyn_cast<PHINode>(&instruction))
    return transferPhi(*phi);
  if (const auto *call = dyn_cast<CallBase>(&instruction))
    return transferCall(*call);
  const DataLayout &layout = function.getParent()->getDataLayout();
  if (const auto *alloca = dyn_cast<AllocaInst>(&instruction)) {
    const auto *count = dyn_cast<ConstantInt>(alloca->getArraySize());
    if (!count || !count->getValue().isIntN(32))
      return Shape::varying();
    unsigned zeros = Log2(alloca->getAlign());
    if (uint64_t element = interleavedElementSize(*alloca))
      return Shape::strided(int64_t(element), false, false).aligned(zeros);
    // Each lane has a copy of its own, aligned like the original.
    uint64_t size = layout.getTypeAllocSize(alloca->getAllocatedType()) * count->getZExtValue();
    auto stride = int64_t(alignTo(std::max<uint64_t>(size, 1), alloca->getAlign()));
    return Shape::strided(stride, false, false).aligned(zeros);
  }

  bool allUniform = true;
  for (const Value *operand : instruction.operand_values()) {
    Shape shape = shapeOf(operand);
    if (shape.isUnknown())
      return Shape();
    allUniform &= shape.isUniform();
  }
  if (const auto *load = dyn_cast<LoadInst>(&instruction))
    return allUniform && load->isSimple() ? Shape::uniform() : Shape::varying();
  if (isa<AtomicRMWInst>(instruction) || isa<AtomicCmpXchgInst>(instruction) ||
      isa<VAArgInst>(instruction))
    return Shape::varying();
  if (const auto *gep = dyn_cast<GetElementPtrInst>(&instruction))
    return transferGep(*cast<GEPOperator>(gep), instruction);
  if (allUniform)
    // A freeze of poison may choose a value for each lane, but one choice for all is a choice too.
    return Shape::uniform();

  // Everything below knows strides of integers and pointers only.
  auto operandShape = [&](unsigned i) { return shapeOf(instruction.getOperand(i)); };
  if (isa<SelectInst>(instruction)) {
    if (!operandShape(0).isUniform())
      return Shape::varying();
    return Shape::join(operandShape(1), operandShape(2));
  }
  for (unsigned i = 0; i < instruction.getNumOperands(); ++i)
    if (operandShape(i).isVarying())
      return Shape::varying();
  if (const auto *op = dyn_cast<BinaryOperator>(&instruction))
    return transferArithmetic(*op);
  Shape source = operandShape(0);
  switch (instruction.getOpcode()) {
  case Instruction::SExt:
    return source.noSignedWrap() ? source : Shape::varying();
  case Instruction::ZExt:
    return source.noUnsignedWrap() ? source : Shape::varying();
  case Instruction::Trunc:
    return instruction.getType()->isIntegerTy(1)
               ? Shape::varying()
               : Shape::strided(source.stride(), false, false).aligned(source.zeros());
  case Instruction::PtrToInt:
  case Instruction::IntToPtr:
    if (layout.getTypeSizeInBits(instruction.getType()) ==
        layout.getTypeSizeInBits(instruction.getOperand(0)->getType()))
      return Shape::strided(source.stride(), false, false).aligned(source.zeros());
    return Shape::varying();
  default:
    return Shape::varying();
  }
}

//===-- Control -------------------------------------------------------------===//

void ShapeAnalysis::branchDiverges(const BasicBlock *block) {
  divergentBranches.insert(block);
  SmallVector<const BasicBlock *, 2> targets(successors(block));
  propagate(targets, block, loops.getLoopFor(block));
}

void ShapeAnalysis::loopDiverges(const Loop *loop) {
  if (!divergentLoops.insert(loop).second)
    return;
  SmallVector<BasicBlock *, 4> exits;
  loop->getUniqueExitBlocks(exits);
  joins.insert(exits.begin(), exits.end());
  SmallVector<const BasicBlock *, 4> targets(exits.begin(), exits.end());
  propagate(targets, nullptr, loop->getParentLoop());
}

/// Sends a label down from each start. \p around is the innermost loop that is left or repeated by
/// lanes that took part; \p root the branch, or null if the starts are a divergent loop's exits.
void ShapeAnalysis::propagate(ArrayRef<const BasicBlock *> starts, const BasicBlock *root,
                              const Loop *around) {
  // A label names a start (even), or a join from which on lanes go on together (odd). 0 is no
  // label.
  using Label = unsigned;
  auto startLabel = [&](const BasicBlock *block) { return 2 * position.lookup(block) + 2; };
  auto joinLabel = [&](const BasicBlock *block) { return 2 * position.lookup(block) + 3; };
  DenseMap<const BasicBlock *, Label> labels;
  std::priority_queue<unsigned, std::vector<unsigned>, std::greater<unsigned>> pending;
  DenseSet<unsigned> queued;

  // For each loop around: the label that goes round, and those that leave.
  struct Ends {
    SmallVector<Label, 2> repeats;
    SmallVector<Label, 4> exits;
  };
  DenseMap<const Loop *, Ends> ends;

  auto send = [&](const BasicBlock *from, const BasicBlock *to, Label label) {
    for (const Loop *loop = around; loop; loop = loop->getParentLoop()) {
      if (to == loop->getHeader()) {
        ends[loop].repeats.push_back(label);
        return;
      }
      if (!loop->contains(to) && (!from || loop->contains(from)))
        ends[loop].exits.push_back(label);
    }
    if (from && position.lookup(to) <= position.lookup(from))
      return; // goes round a loop that was entered later
    Label &present = labels[to];
    if (!present) {
      present = label;
    } else if (present != label && present != joinLabel(to)) {
      present = joinLabel(to);
      joins.insert(to);
    } else {
      return;
    }
    if (queued.insert(position.lookup(to)).second)
      pending.push(position.lookup(to));
  };

  for (const BasicBlock *start : starts)
    send(root, start, startLabel(start));
  while (!pending.empty()) {
    unsigned next = pending.top();
    pending.pop();
    queued.erase(next);
    const BasicBlock *block = order[next];
    for (const BasicBlock *successor : successors(block))
      send(block, successor, labels[block]);
  }

  for (const Loop *loop = around; loop; loop = loop->getParentLoop()) {
    const Ends &end = ends[loop];
    bool differs = false;
    for (Label repeat : end.repeats)
      for (Label exit : end.exits)
        differs |= repeat != exit;
    if (differs)
      loopDiverges(loop);
  }
}

void ShapeAnalysis::print(raw_ostream &out) const {
  out << "shapes of " << function.getName() << ", " << width << " lanes\n";
  for (const Argument &argument : function.args()) {
    out << "  " << argument.getName() << ": ";
    shapeOf(&argument).print(out);
    out << "\n";
  }
  for (const BasicBlock *block : order) {
    out << block->getName() << ":";
    if (joins.contains(block))
      out << " lanes meet";
    if (const Loop *loop = loops.getLoopFor(block); loop && loop->getHeader() == block)
      out << (isDivergentLoop(loop) ? " divergent loop" : " uniform loop");
    if (isDivergentBranch(block))
      out << " lanes part";
    out << "\n";
    for (const Instruction &instruction : *block)
      if (!instruction.getType()->isVoidTy()) {
        out << "  " << (instruction.hasName() ? instruction.getName() : "(unnamed)") << ": ";
        shapeOf(&instruction).print(out);
        out << "\n";
      }
  }
}

} // namespace anysl
