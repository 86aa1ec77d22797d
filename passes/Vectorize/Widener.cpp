//===-- passes/Vectorize/Widener.cpp - emit the widened function ------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Blocks are emitted in the schedule's order. What has to outlive them on paths that no longer
// follow the scalar function's, that is masks, phis and values whose definition no longer dominates
// a use, goes through variables in memory, which are promoted to registers at the end. So SSA form
// is repaired by LLVM's own algorithm, and since a variable starts out as poison (a mask as false),
// a select against a value that was never set folds away.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/Widener.h"

#include "llvm/IR/CFG.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"
#include "llvm/Transforms/Utils/BasicBlockUtils.h"
#include "llvm/Transforms/Utils/PromoteMemToReg.h"

using namespace llvm;

namespace anysl {

Widener::Widener(Function &scalar, Function &wide, const VariantName &name,
                 const VariantSignature &signature, const LoopInfo &loops,
                 const ShapeAnalysis &shapes, const Schedule &schedule, VariantProvider &provider,
                 const Remarks &remarks, const Function &reported)
    : scalar(scalar), widened(wide), name(name), signature(signature), loops(loops), shapes(shapes),
      schedule(schedule), provider(provider), remarks(remarks), reported(reported),
      layout(scalar.getParent()->getDataLayout()), context(scalar.getContext()), width(name.width),
      builder(context) {}

void Widener::run() {
  emitEntry();
  for (unsigned index = 0; index < schedule.plans().size(); ++index)
    emitBlock(index);
  builder.ClearInsertionPoint();

  // Blocks that only a `Branch` on a constant could reach, and the like, have no predecessors.
  EliminateUnreachableBlocks(widened);
  DominatorTree tree(widened);
  SmallVector<AllocaInst *, 32> promotable;
  for (AllocaInst *variable : variables)
    if (isAllocaPromotable(variable))
      promotable.push_back(variable);
  PromoteMemToReg(promotable, tree);
}

//===-- Values --------------------------------------------------------------===//

Value *Widener::allOn() const {
  return ConstantInt::getAllOnesValue(FixedVectorType::get(Type::getInt1Ty(context), width));
}

Value *Widener::broadcast(Value *value) {
  Type *type = value->getType();
  if (isa<PoisonValue>(value))
    return PoisonValue::get(wide(type));
  if (!type->isAggregateType() && !type->isVectorTy())
    return builder.CreateVectorSplat(width, value);
  Value *result = PoisonValue::get(wide(type));
  unsigned count = isa<FixedVectorType>(type) ? cast<FixedVectorType>(type)->getNumElements()
                   : isa<ArrayType>(type)     ? type->getArrayNumElements()
                                              : type->getStructNumElements();
  for (unsigned i = 0; i < count; ++i) {
    Value *element = type->isVectorTy() ? builder.CreateExtractElement(value, i)
                                        : builder.CreateExtractValue(value, i);
    result = builder.CreateInsertValue(result, broadcast(element), i);
  }
  return result;
}

Value *Widener::addStride(Value *base, int64_t stride) {
  Type *type = base->getType();
  Type *integer = type->isPointerTy() ? layout.getIndexType(type) : type;
  SmallVector<Constant *, 32> steps;
  for (unsigned lane = 0; lane < width; ++lane)
    steps.push_back(ConstantInt::get(
        integer, APInt(64, uint64_t(stride) * lane).sextOrTrunc(integer->getIntegerBitWidth())));
  Constant *offsets = ConstantVector::get(steps);
  if (type->isPointerTy())
    return builder.CreateGEP(builder.getInt8Ty(), base, offsets);
  return builder.CreateAdd(builder.CreateVectorSplat(width, base), offsets);
}

/// The emitted form of a value, in the current block.
Value *Widener::fetch(Value *value, Value *defined) {
  auto *instruction = dyn_cast<Instruction>(value);
  if (!instruction)
    return defined;
  unsigned home = definedIn.lookup(value);
  if (home == current || schedule.dominates(home, current) || isa<Constant>(defined))
    return defined;
  Value *&here = fetched[value];
  if (here)
    return here;
  AllocaInst *&memory = demoted[value];
  if (!memory) {
    memory = variable(defined->getType(), PoisonValue::get(defined->getType()),
                      instruction->getParent(), "kept");
    IRBuilder<> after(definedAt.lookup(value)->getTerminator());
    after.CreateStore(defined, memory);
  }
  return here = builder.CreateLoad(defined->getType(), memory);
}

Value *Widener::base(Value *value) {
  if (isa<Constant>(value) || isa<MetadataAsValue>(value) || isa<InlineAsm>(value))
    return value;
  assert(shapeOf(value).isStrided() && "no single value");
  auto found = definitions.find(value);
  assert(found != definitions.end() && "used before it is defined");
  return fetch(value, found->second);
}

Value *Widener::vector(Value *value) {
  if (isa<Constant>(value))
    return broadcast(value);
  Shape shape = shapeOf(value);
  if (shape.isUniform())
    return broadcast(base(value));
  if (shape.isStrided())
    return addStride(base(value), shape.stride());
  auto found = definitions.find(value);
  assert(found != definitions.end() && "used before it is defined");
  return fetch(value, found->second);
}

void Widener::define(Instruction &instruction, Value *value) {
  definitions[&instruction] = value;
  definedIn[&instruction] = current;
  definedAt[&instruction] = builder.GetInsertBlock();
  if (instruction.hasName() && !value->hasName() && isa<Instruction>(value))
    value->setName(instruction.getName());
}

Value *Widener::blend(Value *mask, Value *ifActive, Value *otherwise) {
  if (isa<PoisonValue>(otherwise))
    return ifActive;
  return mapLeaves(nullptr, {ifActive, otherwise}, [&](ArrayRef<Value *> leaves) {
    return builder.CreateSelect(mask, leaves[0], leaves[1]);
  });
}

/// A variable that is \p initial again in each iteration of the loop around \p home.
AllocaInst *Widener::variable(Type *type, Value *initial, const BasicBlock *home,
                              const Twine &name) {
  IRBuilder<> start(variablesEnd);
  AllocaInst *memory = start.CreateAlloca(type, nullptr, name);
  variables.push_back(memory);
  start.CreateStore(initial, memory);
  const Loop *loop = loops.getLoopFor(home);
  if (loop && loop->getHeader() != home) {
    BasicBlock *header = blocks[schedule.indexOf(loop->getHeader())].body;
    start.SetInsertPoint(header, header->getFirstInsertionPt());
    start.CreateStore(initial, memory);
  }
  return memory;
}

AllocaInst *Widener::phiVariable(const PHINode &phi) {
  AllocaInst *&memory = phiVariables[&phi];
  if (!memory) {
    Type *type = shapeOf(&phi).isStrided() ? phi.getType() : wide(phi.getType());
    memory = variable(type, PoisonValue::get(type), phi.getParent(), phi.getName());
  }
  return memory;
}

//===-- Masks ---------------------------------------------------------------===//

AllocaInst *Widener::maskVariable(Masks &masks, unsigned leader) {
  AllocaInst *&memory = masks.variables[leader];
  if (!memory) {
    Type *type = allOn()->getType();
    const BasicBlock *home = schedule.plan(leader).block;
    memory = variable(type, Constant::getNullValue(type), home, home->getName() + ".mask");
  }
  return memory;
}

AllocaInst *Widener::leftVariable(Masks &masks, unsigned index) {
  AllocaInst *&memory = masks.left[index];
  if (!memory) {
    Type *type = allOn()->getType();
    const BasicBlock *home = schedule.plan(index).block;
    memory = variable(type, Constant::getNullValue(type), home, home->getName() + ".left");
  }
  return memory;
}

/// Gives a block the mask that `above` and `without` of its plan describe.
void Widener::subtractLeavers(Masks &masks, unsigned index) {
  Value *left = builder.CreateLoad(allOn()->getType(), leftVariable(masks, index));
  Value *all = maskOf(masks, schedule.plan(index).above);
  builder.CreateStore(builder.CreateAnd(all, builder.CreateNot(left)), maskVariable(masks, index));
}

/// The loop that a block is in, if it has none inside and lanes may leave it at different times.
const Loop *Widener::innermostDivergent(unsigned index) const {
  const Loop *loop = loops.getLoopFor(schedule.plan(index).block);
  return loop && loop->isInnermost() && shapes.isDivergentLoop(loop) ? loop : nullptr;
}

Value *Widener::maskOf(Masks &masks, unsigned index) {
  const Schedule::Plan &plan = schedule.plan(index);
  if (plan.full)
    return allOn();
  if (&masks == &inIteration) {
    const Loop *loop = innermostDivergent(index);
    if (!loop)
      return maskOf(active, index);
    if (schedule.plan(plan.leader).block == loop->getHeader())
      return allOn();
  }
  Value *&mask = masks.loaded[plan.leader];
  if (!mask)
    mask = builder.CreateLoad(allOn()->getType(), maskVariable(masks, plan.leader));
  return mask;
}

Value *Widener::anyLane(Value *mask) {
  Value *bits = builder.CreateBitCast(mask, builder.getIntNTy(width));
  return builder.CreateICmpNE(bits, ConstantInt::get(bits->getType(), 0));
}

/// A condition may be poison in lanes that are not active, so it must not reach the mask there.
Value *Widener::andMask(Value *mask, Value *condition) {
  if (auto *constant = dyn_cast<Constant>(mask); constant && constant->isAllOnesValue())
    return condition;
  return builder.CreateSelect(mask, condition, Constant::getNullValue(mask->getType()));
}

/// The lanes of a conditional block that go to its first successor, or to its second.
Value *Widener::edgeMask(Masks &masks, unsigned from, bool whenTrue) {
  auto *branch = cast<BranchInst>(schedule.plan(from).block->getTerminator());
  Value *mask = maskOf(masks, from);
  Value *condition = branch->getCondition();
  if (shapeOf(condition).isUniform()) {
    Value *one = base(condition);
    if (!schedule.plan(from).occupied)
      one = builder.CreateFreeze(one);
    Value *none = Constant::getNullValue(mask->getType());
    return builder.CreateSelect(one, whenTrue ? mask : none, whenTrue ? none : mask);
  }
  Value *lanes = vector(condition);
  return andMask(mask, whenTrue ? lanes : builder.CreateNot(lanes));
}

//===-- Control flow --------------------------------------------------------===//

/// Whether a run in which no lane is active would do anything that it must not.
bool Widener::needsEntryTest() const {
  if (!name.masked)
    return false;
  if (scalar.size() > 1)
    return true;
  for (Instruction &instruction : scalar.getEntryBlock()) {
    if (needsActiveLane(instruction, shapes) || instruction.isAtomic())
      return true;
    // Values of odd sizes are loaded and stored by one lane after the other.
    if (isa<LoadInst, StoreInst>(instruction) && !isLaneSized(getLoadStoreType(&instruction)))
      return true;
  }
  return false;
}

void Widener::emitEntry() {
  entryBlock = BasicBlock::Create(context, "entry", &widened);
  builder.SetInsertPoint(entryBlock);
  for (const Schedule::Plan &plan : schedule.plans()) {
    Emitted emitted;
    if (plan.guarded)
      emitted.entry = BasicBlock::Create(context, plan.block->getName() + ".guard", &widened);
    emitted.body = BasicBlock::Create(context, plan.block->getName(), &widened);
    if (!emitted.entry)
      emitted.entry = emitted.body;
    blocks.push_back(emitted);
    for (auto edge : plan.without)
      leavers[edge].push_back(blocks.size() - 1);
  }

  SmallVector<Value *, 8> arguments = signature.unpackArguments(builder, widened);
  for (auto [i, argument] : enumerate(scalar.args())) {
    Value *value = arguments[i];
    const VariantParam &param = name.params[i];
    if (param.kind == VariantParam::Kind::LinearByParam) {
      Value *step = builder.CreateSExtOrTrunc(arguments[param.step], value->getType());
      SmallVector<Constant *, 32> lanes;
      for (unsigned lane = 0; lane < width; ++lane)
        lanes.push_back(ConstantInt::get(value->getType(), lane));
      value = builder.CreateAdd(
          builder.CreateVectorSplat(width, value),
          builder.CreateMul(builder.CreateVectorSplat(width, step), ConstantVector::get(lanes)));
    }
    definitions[&argument] = value;
    if (!value->hasName())
      value->setName(argument.getName());
  }
  entryMask = name.masked ? arguments.back() : allOn();
  if (!entryMask->hasName() && name.masked)
    entryMask->setName("mask");

  Instruction *end = nullptr;
  if (needsEntryTest()) {
    BasicBlock *none = BasicBlock::Create(context, "none", &widened);
    end = builder.CreateCondBr(anyLane(entryMask), blocks[0].entry, none);
    builder.SetInsertPoint(none);
    Type *result = scalar.getReturnType();
    signature.packReturn(builder, widened,
                         result->isVoidTy() ? nullptr : PoisonValue::get(wide(result)));
  } else {
    end = builder.CreateBr(blocks[0].entry);
  }
  variablesEnd = end;
  if (!schedule.plan(0).full) {
    AllocaInst *memory = maskVariable(active, 0);
    builder.SetInsertPoint(end);
    builder.CreateStore(entryMask, memory);
  }
}

void Widener::emitBlock(unsigned index) {
  const Schedule::Plan &plan = schedule.plan(index);
  current = index;
  fetched.clear();
  active.loaded.clear();
  inIteration.loaded.clear();
  builder.SetCurrentDebugLocation(DebugLoc());
  builder.SetInsertPoint(blocks[index].entry);
  if (plan.above != Schedule::None) {
    subtractLeavers(active, index);
    if (innermostDivergent(index))
      subtractLeavers(inIteration, index);
  }
  if (plan.guarded) {
    builder.CreateCondBr(anyLane(currentMask()), blocks[index].body, blocks[plan.skipTo].entry);
  }
  builder.SetInsertPoint(blocks[index].body);
  auto *block = const_cast<BasicBlock *>(plan.block);
  for (PHINode &phi : block->phis()) {
    AllocaInst *memory = phiVariable(phi);
    define(phi, builder.CreateLoad(memory->getAllocatedType(), memory));
  }
  for (Instruction &instruction : *block) {
    if (isa<PHINode>(instruction) || instruction.isTerminator())
      continue;
    builder.SetCurrentDebugLocation(instruction.getDebugLoc());
    widen(instruction);
  }
  builder.SetCurrentDebugLocation(block->getTerminator()->getDebugLoc());
  emitExit(index);
}

/// What happens where lanes take an edge: the target's phis get their values, and its mask the
/// lanes.
/// \p direct says that the target runs next, for all lanes that are here.
void Widener::emitEdge(unsigned from, const BasicBlock *to, Value *mask, Value *maskInIteration,
                       bool direct) {
  const BasicBlock *source = schedule.plan(from).block;
  unsigned target = schedule.indexOf(to);
  const Schedule::Plan &plan = schedule.plan(target);
  const Loop *loop = loops.getLoopFor(to);
  // A header's variables are dead for lanes that are elsewhere.
  bool replaces = loop && loop->getHeader() == to;
  auto isAll = [](Value *lanes) {
    return isa<Constant>(lanes) && cast<Constant>(lanes)->isAllOnesValue();
  };
  // A phi's variable is dead, too, for lanes that are here and go elsewhere: if they come to the
  // phi after all, it is by another edge, which has its turn later. So their own mask will do,
  // which is known before the branch's condition, and mostly needed for something else.
  bool isInside = !replaces && loop == innermostDivergent(from);
  Value *here = maskOf(loop && isInside ? inIteration : active, from);

  for (const PHINode &phi : to->phis()) {
    AllocaInst *memory = phiVariable(phi);
    Value *incoming = phi.getIncomingValueForBlock(source);
    bool single = shapeOf(&phi).isStrided();
    Value *value = single ? base(incoming) : vector(incoming);
    if (isa<PoisonValue>(value))
      continue;
    bool keepsOld =
        single ? !isAll(mask) && !(direct && schedule.plan(from).occupied) : !isAll(here);
    if (!replaces && keepsOld) {
      Value *old = builder.CreateLoad(value->getType(), memory);
      value = single ? builder.CreateSelect(anyLane(mask), value, old) : blend(here, value, old);
    }
    builder.CreateStore(value, memory);
  }

  addToMask(active, from, to, mask);
  if (innermostDivergent(from))
    addToMask(inIteration, from, to, maskInIteration);
}

/// Lanes take an edge: they are in its target, and no longer on the way to other blocks.
void Widener::addToMask(Masks &masks, unsigned from, const BasicBlock *to, Value *mask) {
  unsigned target = schedule.indexOf(to);
  const Schedule::Plan &plan = schedule.plan(target);
  const Loop *loop = loops.getLoopFor(to);
  bool replaces = loop && loop->getHeader() == to;
  // Who comes to other loops is known from `active`.
  bool isCounted = &masks == &active || (loop == innermostDivergent(from) && !replaces);
  auto add = [&](AllocaInst *memory) {
    Value *before = builder.CreateLoad(mask->getType(), memory);
    builder.CreateStore(builder.CreateOr(before, mask), memory);
  };
  for (unsigned index : leavers.lookup({from, target}))
    if (&masks == &active || innermostDivergent(index) == innermostDivergent(from))
      add(leftVariable(masks, index));
  if (plan.leader != target || plan.full || plan.above != Schedule::None || !isCounted)
    return;
  auto *constant = dyn_cast<Constant>(mask);
  if (replaces || (constant && constant->isAllOnesValue()))
    builder.CreateStore(mask, maskVariable(masks, target));
  else
    add(maskVariable(masks, target));
}

void Widener::emitExit(unsigned index) {
  const Schedule::Plan &plan = schedule.plan(index);
  const Instruction *terminator = plan.block->getTerminator();
  auto entryOf = [&](unsigned next) { return blocks[next].entry; };
  const auto *branch = dyn_cast<BranchInst>(terminator);

  switch (plan.exit) {
  case Schedule::Exit::Return: {
    Value *result = cast<ReturnInst>(terminator)->getReturnValue();
    signature.packReturn(builder, widened, result ? vector(result) : nullptr);
    return;
  }
  case Schedule::Exit::Unreachable:
    builder.CreateUnreachable();
    return;
  case Schedule::Exit::Jump:
    if (!branch) { // lanes end here; others wait elsewhere
      builder.CreateBr(entryOf(plan.next[0]));
      return;
    }
    if (branch->isUnconditional()) {
      const BasicBlock *to = branch->getSuccessor(0);
      emitEdge(index, to, maskOf(index), maskOf(inIteration, index),
               schedule.indexOf(to) == plan.next[0]);
    } else {
      // Both masks before either edge, whose effects they do not depend on.
      Value *masks[2][2];
      for (unsigned i = 0; i < 2; ++i) {
        masks[i][0] = edgeMask(active, index, i == 0);
        masks[i][1] =
            innermostDivergent(index) ? edgeMask(inIteration, index, i == 0) : masks[i][0];
      }
      for (unsigned i = 0; i < 2; ++i)
        emitEdge(index, branch->getSuccessor(i), masks[i][0], masks[i][1], false);
    }
    builder.CreateBr(entryOf(plan.next[0]));
    return;
  case Schedule::Exit::Branch: {
    Value *condition = base(branch->getCondition());
    if (!plan.occupied)
      condition = builder.CreateFreeze(condition);
    BasicBlock *edges[2];
    for (unsigned i = 0; i < 2; ++i)
      edges[i] = BasicBlock::Create(
          context, plan.block->getName() + ".to." + branch->getSuccessor(i)->getName(), &widened,
          blocks[index].body->getNextNode());
    Value *mask = maskOf(index), *maskInIteration = maskOf(inIteration, index);
    // Values that the edges use must be fetched where both can see them.
    for (unsigned i = 0; i < 2; ++i)
      for (const PHINode &phi : branch->getSuccessor(i)->phis())
        if (Value *incoming = phi.getIncomingValueForBlock(plan.block); isa<Instruction>(incoming))
          fetch(incoming, definitions.lookup(incoming));
    builder.CreateCondBr(condition, edges[0], edges[1]);
    for (unsigned i = 0; i < 2; ++i) {
      builder.SetInsertPoint(edges[i]);
      const BasicBlock *to = branch->getSuccessor(i);
      emitEdge(index, to, mask, maskInIteration, schedule.indexOf(to) == plan.next[i]);
      builder.CreateBr(entryOf(plan.next[i]));
    }
    return;
  }
  case Schedule::Exit::RepeatIfAny: {
    const Loop *loop = loops.getLoopFor(plan.block);
    const BasicBlock *header = loop->getHeader();
    remark(VectorizeRemark::Kind::DivergentLoop, *terminator,
           "lanes may leave this loop at different times");
    Value *again = maskOf(index);
    if (branch->isConditional()) {
      bool repeatsWhenTrue = branch->getSuccessor(0) == header;
      again = edgeMask(active, index, repeatsWhenTrue);
      Value *leaving = edgeMask(active, index, !repeatsWhenTrue);
      emitEdge(index, branch->getSuccessor(repeatsWhenTrue ? 1 : 0), leaving, leaving, false);
    }
    emitEdge(index, header, again, again, true);
    BasicBlock *done;
    if (plan.next[0] == Schedule::None) {
      done = BasicBlock::Create(context, "never", &widened);
      new UnreachableInst(context, done);
    } else {
      done = entryOf(plan.next[0]);
    }
    builder.CreateCondBr(anyLane(again), entryOf(schedule.indexOf(header)), done);
    return;
  }
  }
}

} // namespace anysl
