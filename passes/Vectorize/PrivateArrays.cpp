//===-- passes/Vectorize/PrivateArrays.cpp - arrays that each lane has for itself -------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A pointer to byte o of a lane's variable becomes a pointer to byte o · W of all lanes' memory, to
// which the lane's number times the element's size is added. As both are linear in o, steps from
// pointer to pointer are scaled, and everything else (phis, selects, comparisons) stays as it is.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/PrivateArrays.h"

#include "llvm/ADT/MapVector.h"
#include "llvm/ADT/SetVector.h"
#include "llvm/ADT/SmallPtrSet.h"
#include "llvm/Analysis/ValueTracking.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"
#include "llvm/IR/Operator.h"
#include "llvm/IR/PatternMatch.h"
#include "llvm/Transforms/Utils/BasicBlockUtils.h"

using namespace llvm;
using namespace llvm::PatternMatch;

namespace anysl {

static constexpr StringRef Mark = "anysl.interleaved";

namespace {

/// A variable and all pointers into it.
class PrivateArray {
public:
  explicit PrivateArray(AllocaInst &variable)
      : variable(variable), layout(variable.getModule()->getDataLayout()) {}

  bool findPointers();
  uint64_t elementSize() const { return size; }
  bool fits(unsigned width) const;
  void interleave(unsigned width);

private:
  bool noteAccess(Type *type);
  bool stepsByElements(const GetElementPtrInst &step) const;
  Value *scaledIndex(IRBuilder<> &builder, const GetElementPtrInst &step, unsigned width) const;
  uint64_t bytes() const;

  AllocaInst &variable;
  const DataLayout &layout;
  SetVector<Value *> pointers;
  SmallVector<GetElementPtrInst *, 8> steps;
  uint64_t size = 0; ///< of an element
};

} // namespace

bool PrivateArray::noteAccess(Type *type) {
  if (!type->isIntegerTy() && !type->isFloatingPointTy() && !type->isPointerTy())
    return false;
  uint64_t bits = layout.getTypeSizeInBits(type);
  if (bits < 8 || bits > 64 || !isPowerOf2_64(bits) || (size && size != bits / 8))
    return false;
  size = bits / 8;
  return true;
}

/// Follows every use of the variable; false if one of them lets it out of sight.
bool PrivateArray::findPointers() {
  pointers.insert(&variable);
  SmallVector<Instruction *, 8> mixing;
  for (unsigned next = 0; next < pointers.size(); ++next)
    for (User *user : pointers[next]->users()) {
      auto *instruction = cast<Instruction>(user);
      if (auto *load = dyn_cast<LoadInst>(instruction)) {
        if (!load->isSimple() || !noteAccess(load->getType()))
          return false;
      } else if (auto *store = dyn_cast<StoreInst>(instruction)) {
        if (!store->isSimple() || store->getValueOperand() == pointers[next] ||
            !noteAccess(store->getValueOperand()->getType()))
          return false;
      } else if (auto *step = dyn_cast<GetElementPtrInst>(instruction)) {
        if (step->getType()->isVectorTy())
          return false;
        if (pointers.insert(step))
          steps.push_back(step);
      } else if (isa<PHINode>(instruction) || isa<SelectInst>(instruction)) {
        pointers.insert(instruction);
        mixing.push_back(instruction);
      } else if (isa<ICmpInst>(instruction)) {
        mixing.push_back(instruction);
      } else if (!instruction->isLifetimeStartOrEnd() && !isa<MemIntrinsic>(instruction)) {
        return false;
      }
    }
  return all_of(mixing, [&](Instruction *instruction) {
    return all_of(instruction->operands(), [&](const Use &operand) {
      bool isCondition = isa<SelectInst>(instruction) && operand.getOperandNo() == 0;
      return isCondition || isa<UndefValue>(operand) || pointers.contains(operand.get());
    });
  });
}

uint64_t PrivateArray::bytes() const {
  return layout.getTypeAllocSize(variable.getAllocatedType()).getFixedValue() *
         cast<ConstantInt>(variable.getArraySize())->getZExtValue();
}

bool PrivateArray::stepsByElements(const GetElementPtrInst &step) const {
  MapVector<Value *, APInt> terms;
  unsigned bits = layout.getIndexTypeSizeInBits(step.getType());
  APInt constant(bits, 0);
  if (!step.collectOffset(layout, bits, terms, constant))
    return false;
  return constant.getSExtValue() % int64_t(size) == 0 && all_of(terms, [&](const auto &term) {
           return term.second.getSExtValue() % int64_t(size) == 0;
         });
}

bool PrivateArray::fits(unsigned width) const {
  auto *count = dyn_cast<ConstantInt>(variable.getArraySize());
  if (!size || !count || !count->getValue().isIntN(24) || bytes() <= size || bytes() % size ||
      bytes() > (1u << 30) / width)
    return false;
  for (Value *pointer : pointers)
    if (any_of(pointer->users(), [](User *user) { return isa<MemIntrinsic>(user); }))
      return false;
  return all_of(steps, [&](const GetElementPtrInst *step) { return stepsByElements(*step); });
}

/// How many elements of all lanes' memory a step goes. 32 bits are enough for a place in it, and
/// let processors gather with narrow indices.
Value *PrivateArray::scaledIndex(IRBuilder<> &builder, const GetElementPtrInst &step,
                                 unsigned width) const {
  MapVector<Value *, APInt> terms;
  unsigned bits = layout.getIndexTypeSizeInBits(step.getType());
  APInt constant(bits, 0);
  step.collectOffset(layout, bits, terms, constant);
  int64_t perElement = int64_t(size);
  Value *index = builder.getInt32(uint32_t(constant.getSExtValue() / perElement * width));
  for (auto &[value, scale] : terms) {
    Value *narrow = value, *inner;
    if (match(value, m_ZExtOrSExt(m_Value(inner))) && inner->getType()->isIntegerTy(32))
      narrow = inner;
    narrow = builder.CreateSExtOrTrunc(narrow, builder.getInt32Ty());
    Value *factor = builder.getInt32(uint32_t(scale.getSExtValue() / perElement * width));
    index = builder.CreateAdd(builder.CreateMul(narrow, factor), index);
  }
  return index;
}

void PrivateArray::interleave(unsigned width) {
  LLVMContext &context = variable.getContext();
  Type *element = IntegerType::get(context, unsigned(8 * size));
  IRBuilder<> builder(&variable);
  AllocaInst *all = builder.CreateAlloca(ArrayType::get(element, bytes() / size * width),
                                         variable.getAddressSpace(), nullptr, variable.getName());
  all->setAlignment(std::max(variable.getAlign(), Align(std::min<uint64_t>(64, size * width))));
  all->setMetadata(Mark, MDNode::get(context, ConstantAsMetadata::get(builder.getInt64(size))));
  for (GetElementPtrInst *step : steps) {
    builder.SetInsertPoint(step);
    builder.SetCurrentDebugLocation(step->getDebugLoc());
    Value *moved =
        builder.CreateGEP(element, step->getPointerOperand(), scaledIndex(builder, *step, width));
    moved->takeName(step);
    step->replaceAllUsesWith(moved);
    step->eraseFromParent();
  }
  variable.replaceAllUsesWith(all);
  variable.eraseFromParent();
}

uint64_t interleavedElementSize(const AllocaInst &variable) {
  const MDNode *mark = variable.getMetadata(Mark);
  return mark ? mdconst::extract<ConstantInt>(mark->getOperand(0))->getZExtValue() : 0;
}

uint64_t accessSize(const AllocaInst &variable) {
  PrivateArray array(const_cast<AllocaInst &>(variable));
  return array.findPointers() ? array.elementSize() : 0;
}

//===-- Which variable ------------------------------------------------------===//

/// The first access to memory in a phi's block, if it goes through the phi and could as well happen
/// before the block.
static Instruction *firstAccess(PHINode &phi) {
  for (Instruction &instruction : *phi.getParent()) {
    if (isa<PHINode>(instruction) || (!instruction.mayReadOrWriteMemory() &&
                                      isGuaranteedToTransferExecutionToSuccessor(&instruction)))
      continue;
    if (auto *load = dyn_cast<LoadInst>(&instruction))
      return load->isSimple() && load->getPointerOperand() == &phi ? load : nullptr;
    auto *store = dyn_cast<StoreInst>(&instruction);
    if (!store || !store->isSimple() || store->getPointerOperand() != &phi)
      return nullptr;
    auto *value = dyn_cast<Instruction>(store->getValueOperand());
    bool isKnownBefore = !value || isa<PHINode>(value) || value->getParent() != phi.getParent();
    return isKnownBefore && value != &phi ? store : nullptr;
  }
  return nullptr;
}

/// A phi of variables, each by an edge of its own.
static bool choosesVariable(PHINode &phi) {
  SmallPtrSet<BasicBlock *, 8> seen;
  return phi.getType()->isPointerTy() && phi.getNumIncomingValues() > 1 &&
         all_of(phi.incoming_values(), [](const Use &value) { return isa<AllocaInst>(value); }) &&
         all_of(phi.blocks(), [&](BasicBlock *block) {
           return seen.insert(block).second && !isa<IndirectBrInst>(block->getTerminator());
         });
}

static void moveToEdges(PHINode &phi, Instruction &access) {
  BasicBlock *block = phi.getParent();
  PHINode *loaded = nullptr;
  if (isa<LoadInst>(access)) {
    loaded = PHINode::Create(access.getType(), phi.getNumIncomingValues());
    loaded->insertBefore(block->begin());
  }
  SmallVector<BasicBlock *, 8> sources(phi.blocks());
  for (BasicBlock *source : sources) {
    BasicBlock *edge = SplitEdge(source, block);
    auto onEdge = [&](Value *value) {
      auto *other = dyn_cast<PHINode>(value);
      return other && other->getParent() == block ? other->getIncomingValueForBlock(edge) : value;
    };
    Instruction *moved = access.clone();
    moved->insertBefore(edge->getTerminator());
    for (Use &operand : moved->operands())
      operand.set(onEdge(operand));
    if (loaded)
      loaded->addIncoming(moved, edge);
  }
  if (loaded)
    access.replaceAllUsesWith(loaded);
  access.eraseFromParent();
}

bool accessKnownVariables(Function &function) {
  bool changed = false;
  for (BasicBlock &block : make_early_inc_range(function))
    for (PHINode &phi : make_early_inc_range(block.phis())) {
      if (!choosesVariable(phi))
        continue;
      while (Instruction *access = firstAccess(phi)) {
        moveToEdges(phi, *access);
        changed = true;
      }
      if (phi.use_empty())
        phi.eraseFromParent();
    }
  return changed;
}

//===-- Layout --------------------------------------------------------------===//

bool interleavePrivateArrays(Function &function, unsigned width) {
  SmallVector<AllocaInst *, 8> variables;
  for (Instruction &instruction : instructions(function))
    if (auto *variable = dyn_cast<AllocaInst>(&instruction))
      variables.push_back(variable);
  bool changed = false;
  for (AllocaInst *variable : variables) {
    PrivateArray array(*variable);
    if (!array.findPointers() || !array.fits(width))
      continue;
    array.interleave(width);
    changed = true;
  }
  return changed;
}

} // namespace anysl
