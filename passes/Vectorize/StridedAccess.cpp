//===-- passes/Vectorize/StridedAccess.cpp - records in memory, lane by lane ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// W lanes of a record of K elements are K vectors V0 … V(K-1) in memory; member m of lane l is
// element f = K·l + m, at place f mod W of V(f / W). For odd K and W a power of two, each lane of a
// member has a place of its own, so that a member is the vectors blended by place and then permuted
// once, and a stored vector is a blend of the members permuted once each. For even K lanes are
// picked in steps from two vectors at a time.
//
// Where lanes are idle or members are left out, the vectors are read and written under masks: an
// element is accessed if its lane is active and it is a member of the group.
//
//===------------------------------------------------------------------------------------------===//

#include "passes/Vectorize/StridedAccess.h"

#include "llvm/ADT/SmallVector.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/DataLayout.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"
#include "llvm/IR/Operator.h"
#include "llvm/IR/PatternMatch.h"

using namespace llvm;
using namespace llvm::PatternMatch;

namespace anysl {

namespace {

/// A gather or a scatter whose lanes lie `stride` bytes apart.
struct Access {
  IntrinsicInst *call;
  FixedVectorType *type;
  Value *first; ///< the address of lane 0
  Value *root;  ///< with `index` and `bytes`, that address as root + 1·index + bytes
  Value *index; ///< what is added to the root, sign-extended and times `scale`, or null
  Value *mask;  ///< null if all lanes access
  uint64_t scale;
  int64_t bytes;
  int64_t stride;
  Align align;

  bool isLoad() const { return call->getIntrinsicID() == Intrinsic::masked_gather; }
};

/// 0, s, 2s, … in the lanes of a constant.
std::optional<int64_t> strideOf(Value *offsets) {
  auto *constant = dyn_cast<ConstantDataVector>(offsets);
  if (!constant || constant->getNumElements() < 2 || constant->getElementAsInteger(0) != 0)
    return std::nullopt;
  int64_t stride = constant->getElementAsAPInt(1).getSExtValue();
  for (unsigned lane = 0; lane < constant->getNumElements(); ++lane)
    if (constant->getElementAsAPInt(lane).getSExtValue() != stride * int64_t(lane))
      return std::nullopt;
  return stride;
}

/// Takes constants out of an address. A sum that wraps is poison, and an address that all lanes
/// access is not; so sext(i + 1) is sext(i) + 1 here.
void decompose(Access &access, const DataLayout &layout) {
  access.root = access.first;
  access.index = nullptr;
  access.scale = 0;
  access.bytes = 0;
  while (auto *gep = dyn_cast<GEPOperator>(access.root)) {
    APInt constant(64, 0);
    if (gep->accumulateConstantOffset(layout, constant)) {
      access.bytes += constant.getSExtValue();
      access.root = gep->getPointerOperand();
      continue;
    }
    if (access.index || gep->getNumIndices() != 1)
      return;
    Value *index = gep->getOperand(1), *inner = index;
    uint64_t scale = layout.getTypeAllocSize(gep->getSourceElementType()).getFixedValue();
    match(index, m_SExt(m_Value(inner)));
    bool isExtended = index->getType()->getIntegerBitWidth() < 64 || inner != index;
    Value *rest;
    const APInt *added;
    auto *sum = dyn_cast<OverflowingBinaryOperator>(inner);
    bool isExact = !isExtended || (sum && sum->hasNoSignedWrap());
    if (isExact && match(inner, m_Add(m_Value(rest), m_APInt(added)))) {
      access.bytes += added->getSExtValue() * int64_t(scale);
      inner = rest;
    }
    access.index = inner;
    access.scale = scale;
    access.root = gep->getPointerOperand();
  }
}

std::optional<Access> accessOf(Instruction &instruction, const DataLayout &layout) {
  auto *call = dyn_cast<IntrinsicInst>(&instruction);
  if (!call)
    return std::nullopt;
  bool isLoad = call->getIntrinsicID() == Intrinsic::masked_gather;
  if (!isLoad && call->getIntrinsicID() != Intrinsic::masked_scatter)
    return std::nullopt;
  unsigned at = isLoad ? 0 : 1;
  auto *pointers = dyn_cast<GetElementPtrInst>(call->getArgOperand(at));
  auto *type = cast<FixedVectorType>(isLoad ? call->getType() : call->getArgOperand(0)->getType());
  Type *element = type->getElementType();
  if (!pointers || !isPowerOf2_32(type->getNumElements()) ||
      pointers->getPointerOperandType()->isVectorTy() || pointers->getNumIndices() != 1 ||
      !layout.typeSizeEqualsStoreSize(element))
    return std::nullopt;
  auto stride = strideOf(pointers->getOperand(1));
  if (!stride)
    return std::nullopt;
  Access access;
  access.call = call;
  access.type = type;
  access.first = pointers->getPointerOperand();
  access.mask = call->getArgOperand(at + 2);
  if (match(access.mask, m_AllOnes()))
    access.mask = nullptr;
  access.align = Align(cast<ConstantInt>(call->getArgOperand(at + 1))->getZExtValue());
  access.stride = *stride * int64_t(layout.getTypeAllocSize(pointers->getSourceElementType()));
  // What is known of active lanes' addresses holds for lane 0's as far as the stride keeps it.
  if (access.mask)
    access.align = commonAlignment(access.align, std::abs(access.stride));
  int64_t size = layout.getTypeStoreSize(element);
  if (access.stride % size || access.stride / size < 2 || access.stride / size > 4)
    return std::nullopt;
  decompose(access, layout);
  return access;
}

/// The accesses to members of the same records, in one block, that may become one.
class Group {
public:
  explicit Group(const Access &access) { members.push_back(access); }

  bool accepts(const Access &access, const DataLayout &layout) const;
  void add(const Access &access) { members.push_back(access); }
  bool isLoad() const { return members[0].isLoad(); }
  bool rewrite(const DataLayout &layout, const TargetTransformInfo &target);

private:
  bool isWorthwhile(const TargetTransformInfo &target) const;
  void rewriteLoads(IRBuilder<> &builder);
  void rewriteStores(IRBuilder<> &builder);
  unsigned memberOf(const Access &access) const { return (access.bytes - lowest) / size; }
  Value *address(IRBuilder<> &builder, int64_t elements) const {
    return builder.CreateGEP(builder.getInt8Ty(), base->first,
                             builder.getInt64(lowest - base->bytes + elements * size));
  }
  Align alignment(int64_t elements) const {
    return commonAlignment(base->align, std::abs(lowest - base->bytes + elements * size));
  }
  Value *maskOf(IRBuilder<> &builder, unsigned vector) const;
  template <class Lane>
  Value *shuffle(IRBuilder<> &builder, Value *a, Value *b, Lane lane) const {
    SmallVector<int, 32> mask;
    for (unsigned place = 0; place < width; ++place)
      mask.push_back(lane(place));
    return builder.CreateShuffleVector(a, b, mask);
  }
  void keepWhatIsKnown(Instruction *to) const;

  SmallVector<Access, 4> members;
  SmallVector<bool, 4> present; ///< which elements of a record are accessed
  const Access *base = nullptr;
  int64_t lowest = 0, highest = 0; ///< offsets of the first and the last member
  int64_t size = 0;                ///< of an element
  unsigned width = 0, count = 0;   ///< lanes, elements of a record
};

} // namespace

bool Group::accepts(const Access &access, const DataLayout &layout) const {
  const Access &one = members[0];
  if (one.isLoad() != access.isLoad() || one.type != access.type || one.stride != access.stride ||
      one.mask != access.mask || one.root != access.root || one.index != access.index ||
      one.scale != access.scale)
    return false;
  int64_t low = access.bytes, high = access.bytes;
  for (const Access &member : members) {
    low = std::min(low, member.bytes);
    high = std::max(high, member.bytes);
  }
  int64_t element = layout.getTypeStoreSize(one.type->getElementType());
  return high - low < one.stride && (access.bytes - low) % element == 0 &&
         (one.bytes - low) % element == 0;
}

/// Only what is known of all members.
void Group::keepWhatIsKnown(Instruction *to) const {
  for (unsigned kind :
       {LLVMContext::MD_tbaa, LLVMContext::MD_alias_scope, LLVMContext::MD_noalias}) {
    MDNode *node = members[0].call->getMetadata(kind);
    if (all_of(members,
               [&](const Access &member) { return member.call->getMetadata(kind) == node; }))
      to->setMetadata(kind, node);
  }
}

/// Which elements of a vector are accessed: those of active lanes, and only members of the group.
Value *Group::maskOf(IRBuilder<> &builder, unsigned vector) const {
  Value *mask = members[0].mask;
  if (!mask)
    mask = Constant::getAllOnesValue(FixedVectorType::get(builder.getInt1Ty(), width));
  return shuffle(builder, mask, Constant::getNullValue(mask->getType()), [&](unsigned place) {
    unsigned element = vector * width + place;
    return present[element % count] ? element / count : width;
  });
}

void Group::rewriteLoads(IRBuilder<> &builder) {
  // The last vector ends with the last member, not with the record: what follows may be out of
  // bounds. Under a mask it is not read.
  FixedVectorType *type = members[0].type;
  Value *mask = members[0].mask;
  int64_t end = int64_t(count) * (width - 1) + (highest - lowest) / size + 1;
  SmallVector<Value *, 4> vectors;
  SmallVector<int64_t, 4> starts;
  for (unsigned i = 0; i < count; ++i) {
    starts.push_back(mask ? i * width : std::min<int64_t>(i * width, end - width));
    Value *from = address(builder, starts[i]);
    Align align = alignment(starts[i]);
    Instruction *loaded =
        mask ? (Instruction *)builder.CreateMaskedLoad(type, from, align, maskOf(builder, i),
                                                       Constant::getNullValue(type))
             : builder.CreateAlignedLoad(type, from, align);
    keepWhatIsKnown(loaded);
    vectors.push_back(loaded);
  }
  for (const Access &access : members) {
    unsigned member = memberOf(access);
    // Where lane l comes from: which vector, which place of it.
    auto source = [&](unsigned lane) {
      int64_t element = int64_t(count) * lane + member;
      unsigned vector = std::min<int64_t>(element / width, count - 1);
      return std::pair<unsigned, unsigned>(vector, element - starts[vector]);
    };
    SmallVector<int, 32> laneAt(width, -1); // of a place, if all lanes have places of their own
    bool ownPlaces = true;
    for (unsigned lane = 0; lane < width; ++lane) {
      int &here = laneAt[source(lane).second];
      ownPlaces &= here < 0;
      here = lane;
    }
    Value *result = vectors[0];
    for (unsigned i = 1; i < count; ++i)
      result = shuffle(builder, result, vectors[i], [&](unsigned place) -> int {
        if (ownPlaces) {
          int lane = laneAt[place];
          return source(lane).first == i ? place + width : source(lane).first < i ? int(place) : -1;
        }
        auto [vector, at] = source(place);
        return vector == i ? at + width : vector > i ? -1 : i > 1 || vector > 0 ? place : at;
      });
    if (ownPlaces)
      result = shuffle(builder, result, result, [&](unsigned lane) { return source(lane).second; });
    // Idle lanes have zeros by now.
    Value *idle = access.call->getArgOperand(3);
    if (mask && !isa<UndefValue>(idle) && !match(idle, m_Zero()))
      result = builder.CreateSelect(mask, result, idle);
    access.call->replaceAllUsesWith(result);
  }
}

void Group::rewriteStores(IRBuilder<> &builder) {
  SmallVector<Value *, 4> values(count, PoisonValue::get(members[0].type));
  for (const Access &access : members)
    values[memberOf(access)] = access.call->getArgOperand(0);
  bool isMasked = members[0].mask || members.size() < count;
  // For odd counts: each member's lanes moved to the places that they have in memory.
  bool ownPlaces = count % 2;
  if (ownPlaces)
    for (unsigned member = 0; member < count; ++member) {
      SmallVector<int, 32> laneAt(width);
      for (unsigned lane = 0; lane < width; ++lane)
        laneAt[(count * lane + member) % width] = lane;
      values[member] = shuffle(builder, values[member], values[member],
                               [&](unsigned place) { return laneAt[place]; });
    }
  for (unsigned i = 0; i < count; ++i) {
    auto source = [&](unsigned place) {
      unsigned element = i * width + place;
      return std::pair<unsigned, unsigned>(element % count, ownPlaces ? place : element / count);
    };
    Value *result = values[0];
    for (unsigned member = 1; member < count; ++member)
      result = shuffle(builder, result, values[member], [&](unsigned place) -> int {
        auto [from, at] = source(place);
        return from == member ? at + width : from > member ? -1 : member > 1 ? place : at;
      });
    Value *to = address(builder, i * width);
    Align align = alignment(i * width);
    Instruction *stored =
        isMasked ? (Instruction *)builder.CreateMaskedStore(result, to, align, maskOf(builder, i))
                 : builder.CreateAlignedStore(result, to, align);
    keepWhatIsKnown(stored);
  }
}

/// Whether whole vectors do what gathers and scatters do, and sooner.
bool Group::isWorthwhile(const TargetTransformInfo &target) const {
  const Access &one = members[0];
  if (isLoad())
    // A mask has to be spread over each vector, which a single gather is not worth.
    return !one.mask || (members.size() > 1 && target.isLegalMaskedLoad(one.type, one.align));
  if (size_t(count_if(present, [](bool is) { return is; })) < members.size())
    return false; // one place is written twice
  return (!one.mask && members.size() == count) || target.isLegalMaskedStore(one.type, one.align);
}

bool Group::rewrite(const DataLayout &layout, const TargetTransformInfo &target) {
  size = layout.getTypeStoreSize(members[0].type->getElementType());
  width = members[0].type->getNumElements();
  count = members[0].stride / size;
  lowest = highest = members[0].bytes;
  for (const Access &member : members) {
    lowest = std::min(lowest, member.bytes);
    highest = std::max(highest, member.bytes);
  }
  base = find_if(members, [&](const Access &member) { return member.bytes == lowest; });
  present.assign(count, false);
  for (const Access &member : members)
    present[memberOf(member)] = true;
  if (!isWorthwhile(target))
    return false;
  // Loads happen where the first was, stores where the last was.
  IRBuilder<> builder(isLoad() ? members.front().call : members.back().call);
  if (isLoad()) {
    // The address of the lowest member may be computed further down.
    if (base->call != members.front().call) {
      auto *known = dyn_cast<Instruction>(base->first);
      if (known && known->getParent() == members.front().call->getParent() &&
          members.front().call->comesBefore(known))
        base = &members.front();
    }
    rewriteLoads(builder);
  } else {
    rewriteStores(builder);
  }
  for (const Access &member : members)
    member.call->eraseFromParent();
  return true;
}

Value *maskOfRecords(Instruction &instruction, const TargetTransformInfo &target) {
  auto access = accessOf(instruction, instruction.getModule()->getDataLayout());
  if (!access || !access->mask)
    return nullptr;
  bool isWhole = access->isLoad() ? target.isLegalMaskedLoad(access->type, access->align)
                                  : target.isLegalMaskedStore(access->type, access->align);
  return isWhole ? nullptr : access->mask;
}

bool widenStridedAccess(Function &function, const TargetTransformInfo &target) {
  const DataLayout &layout = function.getParent()->getDataLayout();
  SmallVector<Group, 4> groups;
  for (BasicBlock &block : function) {
    // Groups that further members of the block may join.
    SmallVector<Group, 4> open;
    auto close = [&](function_ref<bool(const Group &)> which) {
      SmallVector<Group, 4> kept;
      for (Group &group : open)
        (which(group) ? groups : kept).push_back(std::move(group));
      open = std::move(kept);
    };
    for (Instruction &instruction : block) {
      if (auto access = accessOf(instruction, layout)) {
        auto group = find_if(open, [&](Group &g) { return g.accepts(*access, layout); });
        // Members of the same kind lie in different places, anything else may be the same place.
        bool joins = group != open.end();
        size_t joined = group - open.begin();
        if (joins) {
          open[joined].add(*access);
          if (!access->isLoad()) {
            Group own = std::move(open[joined]);
            open.erase(open.begin() + joined);
            close([](const Group &) { return true; });
            open.push_back(std::move(own));
          }
          continue;
        }
        close([&](const Group &group) { return !(group.isLoad() && access->isLoad()); });
        open.emplace_back(*access);
        continue;
      }
      if (instruction.mayWriteToMemory() || instruction.mayThrow() || !instruction.willReturn())
        close([](const Group &) { return true; });
      else if (instruction.mayReadFromMemory())
        close([](const Group &group) { return !group.isLoad(); });
    }
    close([](const Group &) { return true; });
  }
  bool changed = false;
  for (Group &group : groups)
    changed |= group.rewrite(layout, target);
  return changed;
}

} // namespace anysl
