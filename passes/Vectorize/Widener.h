//===-- passes/Vectorize/Widener.h - emit the widened function ----------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Private to the vectoriser. Widener.cpp has the control flow and the bookkeeping of values,
// WidenValues.cpp the instructions that compute, WidenMemory.cpp those that touch memory,
// WidenCalls.cpp the calls.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_WIDENER_H
#define ANYSL_PASSES_VECTORIZE_WIDENER_H

#include "passes/Vectorize/Remarks.h"
#include "passes/Vectorize/Schedule.h"
#include "passes/Vectorize/VectorAbi.h"

#include "llvm/IR/IntrinsicInst.h"

namespace anysl {

/// Where a call inside widened code can get a wide form of its callee from.
class VariantProvider {
public:
  struct Request {
    llvm::Function *scalar;
    llvm::SmallVector<VariantParam, 8> params;
    bool masked;
    unsigned width;
    Isa isa;                      ///< of the caller
    const llvm::Function *caller; ///< whose target features the variant takes over
  };
  virtual ~VariantProvider() = default;
  /// A variant that is made from the body of a function in the module; null where that has none.
  virtual llvm::Function *request(const Request &request, VariantName &name) = 0;
};

/// Emits the body of one variant from a normalised scalar function.
class Widener {
public:
  /// \p reported is the function that remarks name.
  Widener(llvm::Function &scalar, llvm::Function &wide, const VariantName &name,
          const VariantSignature &signature, const llvm::LoopInfo &loops,
          const ShapeAnalysis &shapes, const Schedule &schedule, VariantProvider &provider,
          const Remarks &remarks, const llvm::Function &reported);
  void run();

private:
  using Value = llvm::Value;
  using Instruction = llvm::Instruction;
  struct Masks;

  //===-- Control flow, Widener.cpp -----------------------------------------===//
  void emitEntry();
  void emitBlock(unsigned index);
  void emitExit(unsigned index);
  void emitEdge(unsigned from, const llvm::BasicBlock *to, Value *mask, Value *inIteration,
                bool direct);
  void addToMask(Masks &masks, unsigned from, const llvm::BasicBlock *to, Value *mask);
  bool needsEntryTest() const;
  Value *edgeMask(Masks &masks, unsigned from, bool whenTrue);
  Value *maskOf(Masks &masks, unsigned index);
  Value *maskOf(unsigned index) { return maskOf(active, index); }
  Value *currentMask() { return maskOf(current); }
  const llvm::Loop *innermostDivergent(unsigned index) const;
  bool isFull() const { return schedule.plan(current).full; }
  bool isOccupied() const { return schedule.plan(current).occupied; }
  Value *anyLane(Value *mask);
  Value *andMask(Value *mask, Value *condition);
  llvm::AllocaInst *maskVariable(Masks &masks, unsigned leader);
  llvm::AllocaInst *leftVariable(Masks &masks, unsigned index);
  void subtractLeavers(Masks &masks, unsigned index);
  llvm::AllocaInst *phiVariable(const llvm::PHINode &phi);
  llvm::AllocaInst *variable(llvm::Type *type, Value *initial, const llvm::BasicBlock *home,
                             const llvm::Twine &name);

  //===-- Values, Widener.cpp -----------------------------------------------===//
  Shape shapeOf(const Value *value) const { return shapes.shapeOf(value); }
  Value *base(Value *value);   ///< the value of lane 0, for a strided one
  Value *vector(Value *value); ///< the values of all lanes
  Value *fetch(Value *value, Value *defined);
  void define(Instruction &instruction, Value *value);
  Value *broadcast(Value *scalar);
  Value *addStride(Value *base, int64_t stride);
  Value *blend(Value *mask, Value *ifActive, Value *otherwise);
  llvm::Type *wide(llvm::Type *type) const { return widenedType(type, width); }
  Value *allOn() const;

  //===-- Instructions, WidenValues.cpp -------------------------------------===//
  void widen(Instruction &instruction);
  void copyScalar(Instruction &instruction);
  Value *extendedBase(llvm::CastInst::CastOps extension, Value *value, llvm::Type *type);
  void widenBinary(llvm::BinaryOperator &op);
  Value *safeDivisor(llvm::BinaryOperator &op, Value *divisor);
  void widenCast(llvm::CastInst &cast);
  void widenSelect(llvm::SelectInst &select);
  Value *mapLeaves(llvm::Type *type, llvm::ArrayRef<Value *> operands,
                   llvm::function_ref<Value *(llvm::ArrayRef<Value *>)> leaf);
  void copyFlags(Value *to, const Instruction &from);

  /// Runs an instruction once per active lane, as a loop; or for all lanes in a row, if it is
  /// harmless.
  void replicate(Instruction &instruction);
  Value *extractLane(Value *widened, llvm::Type *type, Value *lane);
  Value *insertLane(Value *widened, Value *scalar, Value *lane);
  Value *laneOf(Value *value, Value *lane);
  Value *lastActiveLane();

  //===-- Memory, WidenMemory.cpp -------------------------------------------===//
  struct Address {
    Shape shape;
    Value *base = nullptr;  ///< of lane 0, if strided
    Value *lanes = nullptr; ///< of all lanes, otherwise
  };
  Address addressOf(Value *pointer);
  Address offset(const Address &address, uint64_t bytes);
  Value *lanePointers(const Address &address);
  void widenLoad(llvm::LoadInst &load);
  void widenStore(llvm::StoreInst &store);
  void widenAlloca(llvm::AllocaInst &alloca);
  void widenGep(llvm::GetElementPtrInst &gep);
  Value *load(llvm::Type *type, const Address &address, llvm::Align align, Instruction &origin);
  void store(Value *value, llvm::Type *type, const Address &address, llvm::Align align,
             Instruction &origin);
  bool isLaneSized(llvm::Type *type) const;
  llvm::Align alignOfLanes(const Shape &shape, llvm::Align align, int64_t size) const;

  //===-- Calls, WidenCalls.cpp ---------------------------------------------===//
  void widenCall(llvm::CallInst &call);
  bool widenIntrinsic(llvm::IntrinsicInst &call);
  bool widenConstrained(llvm::ConstrainedFPIntrinsic &call);
  bool fusesLikeScalar() const;
  bool shiftsThroughFloats() const;
  bool callVariant(llvm::CallInst &call);
  bool tryVariant(llvm::CallInst &call, const VariantName &name, llvm::Function &variant);
  bool callIfAllActive(llvm::CallInst &call, const VariantName &name, llvm::Function &variant);
  llvm::Function *variantNamed(const VariantName &variant, llvm::Function &callee);
  bool argumentsFit(llvm::CallInst &call, const VariantName &name);

  void remark(VectorizeRemark::Kind kind, const Instruction &at, const llvm::Twine &message) {
    remarks.emit(kind, reported, at.getDebugLoc(), message);
  }

  llvm::Function &scalar;
  llvm::Function &widened;
  const VariantName &name;
  const VariantSignature &signature;
  const llvm::LoopInfo &loops;
  const ShapeAnalysis &shapes;
  const Schedule &schedule;
  VariantProvider &provider;
  const Remarks &remarks;
  const llvm::Function &reported;
  const llvm::DataLayout &layout;
  llvm::LLVMContext &context;
  unsigned width;
  llvm::IRBuilder<> builder;

  unsigned current = 0; ///< the block being emitted
  struct Emitted {
    llvm::BasicBlock *entry = nullptr; ///< the guard if there is one, else the body
    llvm::BasicBlock *body = nullptr;
  };
  llvm::SmallVector<Emitted, 32> blocks;
  llvm::BasicBlock *entryBlock = nullptr;
  llvm::Instruction *variablesEnd = nullptr; ///< where variables get their initial values
  Value *entryMask = nullptr;

  llvm::DenseMap<Value *, Value *> definitions;          ///< base or vector, by shape
  llvm::DenseMap<Value *, unsigned> definedIn;           ///< which scalar block
  llvm::DenseMap<Value *, llvm::BasicBlock *> definedAt; ///< which emitted block
  llvm::DenseMap<Value *, llvm::AllocaInst *> demoted;
  llvm::DenseMap<Value *, Value *> fetched; ///< in the current block
  llvm::DenseMap<const llvm::PHINode *, llvm::AllocaInst *> phiVariables;
  /// The masks of blocks, in variables.
  struct Masks {
    llvm::DenseMap<unsigned, llvm::AllocaInst *> variables; ///< of blocks that are leaders
    llvm::DenseMap<unsigned, llvm::AllocaInst *> left;      ///< who took an edge of `without`
    llvm::DenseMap<unsigned, Value *> loaded;               ///< in the current block, by leader
  };
  Masks active; ///< which lanes are in a block
  /// Which lanes would be if all had begun the iteration of the innermost loop, a divergent one.
  /// That is what matters to a choice between values inside: lanes that have left the loop do not
  /// look at them, and the choice does not wait for who has.
  Masks inIteration;
  /// The blocks of whose `without` an edge is part.
  llvm::DenseMap<std::pair<unsigned, unsigned>, llvm::SmallVector<unsigned, 2>> leavers;
  llvm::SmallVector<llvm::AllocaInst *, 32> variables;
};

} // namespace anysl

#endif
