//===-- frontends/rsl/LowerArray.cpp - arrays whose length changes ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// `lengths` knows for the slot of each resizable array the slot of its length, a float. Lengths
// never exceed the room there is, so that what a shader asks for beyond it is left out.
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

unsigned Lowering::capacityOf(Value *array) { return stc::slotInfo(array)->arrayLength; }

/// The slot of an array's length; for an array of fixed length a constant.
Value *Lowering::lengthOf(Value *array) {
  if (Value *length = lengths.lookup(array))
    return length;
  return number(capacityOf(array));
}

/// `to` has got the elements of `from`, as far as it has room.
void Lowering::copyLength(Value *to, Value *from) {
  Value *length = lengths.lookup(to);
  if (!length)
    return;
  if (capacityOf(from) <= capacityOf(to))
    copy({TypeKind::Float}, length, lengthOf(from));
  else
    b.call(Op::min_float, {length, lengthOf(from), number(capacityOf(to))});
}

/// Whether arrays have the same elements, and as many.
Value *Lowering::equalArrays(Value *left, Value *right, Op equal) {
  bool isFixed = !lengths.contains(left) && !lengths.contains(right);
  Value *result =
      isFixed ? builder().getTrue() : b.call(Op::eq_float, {lengthOf(left), lengthOf(right)});
  unsigned count = std::min(capacityOf(left), capacityOf(right));
  for (unsigned i = 0; i < count; ++i) {
    Value *same = b.call(equal, {elementOf(left, i), elementOf(right, i)});
    if (!isFixed) // what lies behind the length does not count
      same = builder().CreateOr(same, b.call(Op::le_float, {lengthOf(left), number(i)}));
    result = builder().CreateAnd(result, same);
  }
  return result;
}

/// A length from a number: an integer that the array has room for.
void Lowering::setLength(Value *array, Value *count, StringRef name, SMLoc loc) {
  Value *whole = temporary({TypeKind::Float, true});
  b.call(Op::floor, {whole, count});
  if (b.context()) {
    BasicBlock *full = b.block("full"), *fits = b.block("fits");
    branchIf(b.call(Op::gt_float, {whole, number(capacityOf(array))}), full, fits);
    continueIn(full);
    warnFull(array, name, loc);
    branchTo(fits);
    continueIn(fits);
  }
  b.call(Op::clamp_float, {lengths.lookup(array), whole, number(0), number(capacityOf(array))});
}

/// Tells the renderer what is left out, when it gets there.
void Lowering::warnWhenRun(const Twine &message, SMLoc loc) {
  FilePosition position = diags.presumed(loc);
  b.call(Op::warn,
         {b.context(),
          text((position.file + ":" + Twine(position.line) + ": warning: " + message).str())});
}

/// Tells the renderer that elements are left out.
void Lowering::warnFull(Value *array, StringRef name, SMLoc loc) {
  warnWhenRun("array '" + name + "' has no room for more than " + Twine(capacityOf(array)) +
                  " elements; rslc --array-capacity gives it more",
              loc);
}

Value *Lowering::callArray(const CallExpr &call) {
  Value *array = lower(call.args[0]);
  if (call.arrayOp == ArrayOp::Capacity)
    return number(capacityOf(array));
  Value *value = call.args.size() > 1 ? lower(call.args[1]) : nullptr;
  at(call.loc);
  Value *length = lengths.lookup(array);
  Type element = call.args[0]->type.element();
  auto *named = dyn_cast<NameExpr>(call.args[0]);
  StringRef name = named ? named->decl->name : "";
  if (!length) // Sema refuses that; an expansion that is wrong otherwise may lead here
    return call.type.is(TypeKind::Void) ? nullptr : zero(element);
  switch (call.arrayOp) {
  case ArrayOp::Resize:
    setLength(array, value, name, call.loc);
    return nullptr;
  case ArrayOp::Push: {
    Value *grown = temporary({TypeKind::Float, true});
    bool warns = b.context() != nullptr;
    BasicBlock *room = b.block("push"), *end = b.block("push.end"),
               *full = warns ? b.block("full") : end;
    branchIf(b.call(Op::lt_float, {length, number(capacityOf(array))}), room, full);
    if (warns) {
      continueIn(full);
      warnFull(array, name, call.loc);
      branchTo(end);
    }
    continueIn(room);
    copy(element, b.element(array, b.call(Op::index, {length})), value);
    b.call(Op::add_float, {grown, length, number(1)});
    copy({TypeKind::Float}, length, grown);
    branchTo(end);
    continueIn(end);
    return nullptr;
  }
  case ArrayOp::Pop: {
    Value *result = zero(element.withVarying(true));
    Value *less = temporary({TypeKind::Float, true});
    BasicBlock *some = b.block("pop"), *end = b.block("pop.end");
    branchIf(b.call(Op::gt_float, {length, number(0)}), some, end);
    continueIn(some);
    b.call(Op::sub_float, {less, length, number(1)});
    copy({TypeKind::Float}, length, less);
    copy(element, result, b.element(array, b.call(Op::index, {length})));
    branchTo(end);
    continueIn(end);
    return result;
  }
  case ArrayOp::Reserve: // Sema has made the room
  case ArrayOp::Capacity:
    return nullptr;
  }
  llvm_unreachable("unknown operation on an array");
}

} // namespace anysl::rsl
