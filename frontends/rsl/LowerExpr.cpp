//===-- frontends/rsl/LowerExpr.cpp - expressions ---------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

//===-- Slots -----------------------------------------------------------------------------------//

Op Lowering::opFor(TypeKind kind, Op onFloat, Op onColor, Op onVector) {
  switch (kind) {
  case TypeKind::Float:
    return onFloat;
  case TypeKind::Color:
    return onColor;
  case TypeKind::Point:
  case TypeKind::Vector:
  case TypeKind::Normal:
    return onVector;
  default:
    llvm_unreachable("the operator has no form for this type");
  }
}

Value *Lowering::temporary(Type type, StringRef name) {
  if (type.isArray()) {
    Value *array = b.allocArray(lowered(type.kind), unsigned(type.length), name, storage(type));
    if (type.isResizable)
      lengths[array] = b.alloc(stc::Type::floatTy, (name + ".length").str(), storage(type));
    return array;
  }
  return b.alloc(lowered(type.kind), name, storage(type));
}

void Lowering::copy(Type type, Value *to, Value *from) {
  if (to == from)
    return;
  auto slot = stc::slotInfo(to);
  if (slot && slot->arrayLength) {
    unsigned count = std::min(slot->arrayLength, capacityOf(from));
    for (unsigned i = 0; i < count; ++i)
      copy(type.element(), elementOf(to, i), elementOf(from, i));
    copyLength(to, from);
    return;
  }
  Op op = type.kind == TypeKind::Matrix ? Op::copy_matrix
          : type.kind == TypeKind::String || type.kind == TypeKind::Shader
              ? Op::copy_string
              : opFor(type.kind, Op::copy_float, Op::copy_color, Op::copy_vector);
  b.call(op, {to, from});
}

Value *Lowering::copied(Type type, Value *value) {
  if (auto slot = stc::slotInfo(value); slot && slot->arrayLength)
    type.length = static_cast<int>(slot->arrayLength);
  type.isResizable = lengths.count(value);
  Value *fresh = temporary(type);
  copy(type, fresh, value);
  return fresh;
}

Value *Lowering::number(double value) {
  Value *slot = temporary({TypeKind::Float});
  b.call(Op::const_float, {slot, b.number(value)});
  return slot;
}

Value *Lowering::text(StringRef value) {
  Value *slot = temporary({TypeKind::String});
  b.call(Op::const_string, {slot, b.text(value)});
  return slot;
}

void Lowering::setZero(Type type, Value *slot) {
  if (auto info = stc::slotInfo(slot); info && info->arrayLength) {
    for (unsigned i = 0; i < info->arrayLength; ++i)
      setZero(type.element(), elementOf(slot, i));
    if (Value *length = lengths.lookup(slot))
      b.call(Op::const_float, {length, b.number(0)});
    return;
  }
  if (type.kind == TypeKind::String || type.kind == TypeKind::Shader)
    b.call(Op::const_string, {slot, b.text("")});
  else if (type.kind == TypeKind::Float)
    b.call(Op::const_float, {slot, b.number(0)});
  else
    copy(type, slot, convert(number(0), {TypeKind::Float}, type.element()));
}

Value *Lowering::zero(Type type) {
  Value *slot = temporary(type);
  setZero(type, slot);
  return slot;
}

Value *Lowering::convert(Value *value, Type from, Type to) {
  if (from.kind == to.kind || (from.isGeometric() && to.isGeometric()))
    return value;
  Value *result = temporary(to.withVarying(from.varying));
  if (from.is(TypeKind::Float)) {
    b.call(to.is(TypeKind::Matrix)
               ? Op::splat_matrix
               : opFor(to.kind, Op::copy_float, Op::splat_color, Op::splat_vector),
           {result, value});
  } else {
    assert(from.isTriple() && to.isTriple() && "Sema allows no other conversion");
    b.call(to.is(TypeKind::Color) ? Op::color_from_vector : Op::vector_from_color, {result, value});
  }
  return result;
}

//===-- Places ----------------------------------------------------------------------------------//

Lowering::Place Lowering::place(const Expr *target) {
  if (auto *name = dyn_cast<NameExpr>(target)) {
    if (name->decl->kind == VarKind::Global && !name->decl->isReadOnly &&
        !lightGlobals.count(name->decl->id))
      writtenGlobals.insert(name->decl->id);
    return {slotOf(*name->decl), name->type, nullptr};
  }
  auto *index = cast<IndexExpr>(target);
  Place base = place(index->base);
  if (index->base->type.isArray())
    return {lowerIndex(*index), index->type, nullptr};
  return {base.slot, index->base->type, copied(index->index->type, lower(index->index))};
}

Value *Lowering::load(const Place &place, Type type) {
  if (!place.component)
    return place.slot;
  Value *result = temporary(type);
  b.call(opFor(place.type.kind, Op::get_color, Op::get_color, Op::get_vector),
         {result, place.slot, place.component});
  return result;
}

void Lowering::store(const Place &place, Value *value) {
  if (!place.component)
    return copy(place.type, place.slot, value);
  b.call(opFor(place.type.kind, Op::set_color, Op::set_color, Op::set_vector),
         {place.slot, place.component, value});
}

//===-- Expressions -----------------------------------------------------------------------------//

/// The slot of an expression's value, which may be a variable's own.
Value *Lowering::lower(const Expr *expr) {
  // Only an expression that is a statement can still be a condition here: Sema has made numbers of
  // all others.
  if (expr->type.is(TypeKind::Bool)) {
    lowerCondition(expr);
    return nullptr;
  }
  if (expr->type.structure && isa<NameExpr, IndexExpr>(expr))
    return nullptr; // Sema has made operations on its members of everything that is done to it
  switch (expr->kind) {
  case ExprKind::Number:
    at(expr->loc);
    return number(cast<NumberExpr>(expr)->value);
  case ExprKind::String:
    at(expr->loc);
    return text(cast<StringExpr>(expr)->value);
  case ExprKind::Name:
    at(expr->loc);
    return slotOf(*cast<NameExpr>(expr)->decl);
  case ExprKind::Index: {
    auto *index = cast<IndexExpr>(expr);
    if (index->base->type.isArray())
      return lowerIndex(*index);
    Value *base = lowerBefore(index->base, index->index->hasEffects);
    Value *component = lower(index->index);
    at(expr->loc);
    return load({base, index->base->type, component}, expr->type);
  }
  case ExprKind::Negate: {
    Value *operand = lower(cast<NegateExpr>(expr)->operand);
    at(expr->loc);
    Value *result = temporary(expr->type);
    b.call(expr->type.is(TypeKind::Matrix)
               ? Op::neg_matrix
               : opFor(expr->type.kind, Op::neg_float, Op::neg_color, Op::neg_vector),
           {result, operand});
    return result;
  }
  case ExprKind::Binary:
    return lowerBinary(*cast<BinaryExpr>(expr));
  case ExprKind::Conditional:
    return lowerConditional(*cast<ConditionalExpr>(expr));
  case ExprKind::Assign:
    return lowerAssign(*cast<AssignExpr>(expr));
  case ExprKind::Tuple:
    return lowerTuple(*cast<TupleExpr>(expr));
  case ExprKind::Cast:
    return lowerCast(*cast<CastExpr>(expr));
  case ExprKind::Call:
    return lowerCall(*cast<CallExpr>(expr));
  case ExprKind::Comma: {
    Value *last = nullptr;
    for (const Expr *element : cast<CommaExpr>(expr)->elements)
      last = lower(element);
    return last;
  }
  case ExprKind::Opaque:
    return opaques.lookup(cast<OpaqueExpr>(expr));
  case ExprKind::Member:
  case ExprKind::Not:
  case ExprKind::List:
    break;
  }
  llvm_unreachable("this expression has no slot");
}

/// Whether the slot of an expression's value may be a variable's own, which something else can
/// change.
bool Lowering::mayBeVariable(const Expr *expr) {
  if (auto *cast = dyn_cast<CastExpr>(expr))
    return mayBeVariable(cast->operand);
  if (auto *list = dyn_cast<CommaExpr>(expr))
    return mayBeVariable(list->elements.back());
  return isa<NameExpr, IndexExpr, OpaqueExpr, AssignExpr>(expr);
}

/// The value of an operand, safe from what is evaluated after it.
Value *Lowering::lowerBefore(const Expr *expr, bool effectsFollow) {
  Value *value = lower(expr);
  return effectsFollow && mayBeVariable(expr) ? copied(expr->type, value) : value;
}

Value *Lowering::lowerIndex(const IndexExpr &index) {
  Value *base = lower(index.base);
  if (auto *number = dyn_cast<NumberExpr>(index.index)) {
    at(index.loc);
    // An array that came without a known length may be shorter than what it stands for.
    int last = int(capacityOf(base)) - 1;
    return b.element(base, b.index(std::clamp(static_cast<int>(number->value), 0, last)));
  }
  Value *subscript = lower(index.index);
  at(index.loc);
  return b.element(base, b.call(Op::index, {subscript}));
}

/// The operator that compares values of a kind.
Op Lowering::equality(TypeKind kind) {
  return kind == TypeKind::Matrix ? Op::eq_matrix
         : kind == TypeKind::String || kind == TypeKind::Shader
             ? Op::eq_string
             : opFor(kind, Op::eq_float, Op::eq_color, Op::eq_vector);
}

/// The value of a condition: an i1.
Value *Lowering::lowerCondition(const Expr *expr) {
  if (auto *inversion = dyn_cast<NotExpr>(expr))
    return builder().CreateNot(lowerCondition(inversion->operand));
  if (auto *cast = dyn_cast<CastExpr>(expr)) {
    Value *value = lower(cast->operand);
    at(expr->loc);
    return b.call(Op::ne_float, {value, number(0)});
  }
  if (auto *call = dyn_cast<CallExpr>(expr))
    return lowerCall(*call);
  if (auto *list = dyn_cast<CommaExpr>(expr)) {
    for (const Expr *element : list->elements.drop_back())
      lower(element);
    return lowerCondition(list->elements.back());
  }
  auto *binary = cast<BinaryExpr>(expr);
  if (isLogical(binary->op)) {
    // Both sides are evaluated, as in all of RSL.
    Value *left = lowerCondition(binary->left);
    Value *right = lowerCondition(binary->right);
    return binary->op == BinaryOp::And ? builder().CreateAnd(left, right)
                                       : builder().CreateOr(left, right);
  }
  Value *left = lowerBefore(binary->left, binary->right->hasEffects);
  Value *right = lower(binary->right);
  at(expr->loc);
  TypeKind kind = binary->left->type.kind;
  if (kind == TypeKind::Shader)
    kind = TypeKind::String;
  if (binary->left->type.isArray()) {
    Value *same = equalArrays(left, right, equality(kind));
    return binary->op == BinaryOp::Equal ? same : builder().CreateNot(same);
  }
  Op op = Op::lt_float;
  switch (binary->op) {
  case BinaryOp::Less:
    op = Op::lt_float;
    break;
  case BinaryOp::LessEqual:
    op = Op::le_float;
    break;
  case BinaryOp::Greater:
    op = Op::gt_float;
    break;
  case BinaryOp::GreaterEqual:
    op = Op::ge_float;
    break;
  case BinaryOp::Equal:
    op = equality(kind);
    break;
  default:
    op = kind == TypeKind::Matrix   ? Op::ne_matrix
         : kind == TypeKind::String ? Op::ne_string
                                    : opFor(kind, Op::ne_float, Op::ne_color, Op::ne_vector);
  }
  return b.call(op, {left, right});
}

Value *Lowering::lowerBinary(const BinaryExpr &binary) {
  const Expr *leftExpr = binary.left, *rightExpr = binary.right;
  Value *left = lowerBefore(leftExpr, rightExpr->hasEffects);
  Value *right = lower(rightExpr);
  at(binary.loc);
  TypeKind kind = binary.type.kind;
  Value *result = temporary(binary.type);
  bool leftIsNumber = leftExpr->type.is(TypeKind::Float),
       rightIsNumber = rightExpr->type.is(TypeKind::Float);
  if (kind != TypeKind::Float && leftIsNumber != rightIsNumber) {
    // A number times a triple or matrix, or a matrix divided by a number.
    if (leftIsNumber)
      std::swap(left, right);
    if (binary.op == BinaryOp::Divide) {
      Value *inverse = temporary({TypeKind::Float, rightExpr->type.varying});
      b.call(Op::div_float, {inverse, number(1), right});
      right = inverse;
    }
    b.call(kind == TypeKind::Matrix ? Op::scale_matrix
                                    : opFor(kind, Op::mul_float, Op::scale_color, Op::scale_vector),
           {result, left, right});
    return result;
  }
  Op op = Op::dot;
  bool isMatrix = kind == TypeKind::Matrix;
  switch (binary.op) {
  case BinaryOp::Add:
    op = isMatrix ? Op::add_matrix : opFor(kind, Op::add_float, Op::add_color, Op::add_vector);
    break;
  case BinaryOp::Subtract:
    op = isMatrix ? Op::sub_matrix : opFor(kind, Op::sub_float, Op::sub_color, Op::sub_vector);
    break;
  case BinaryOp::Multiply:
    op = isMatrix ? Op::mul_matrix : opFor(kind, Op::mul_float, Op::mul_color, Op::mul_vector);
    break;
  case BinaryOp::Divide:
    op = isMatrix ? Op::div_matrix : opFor(kind, Op::div_float, Op::div_color, Op::div_vector);
    break;
  case BinaryOp::Dot:
    op = Op::dot;
    break;
  case BinaryOp::Cross:
    op = Op::cross;
    break;
  default:
    llvm_unreachable("conditions are lowered elsewhere");
  }
  b.call(op, {result, left, right});
  return result;
}

Value *Lowering::lowerConditional(const ConditionalExpr &conditional) {
  Value *condition = lowerCondition(conditional.condition);
  at(conditional.loc);
  Value *result = temporary(conditional.type);
  BasicBlock *whenTrue = b.block("true"), *whenFalse = b.block("false"), *join = b.block("chosen");
  branchIf(condition, whenTrue, whenFalse);
  auto arm = [&](BasicBlock *block, const Expr *expr) {
    continueIn(block);
    Value *value = lower(expr);
    at(expr->loc);
    copy(conditional.type, result, value);
    branchTo(join);
  };
  arm(whenTrue, conditional.whenTrue);
  arm(whenFalse, conditional.whenFalse);
  continueIn(join);
  return result;
}

/// 0, (0, 0, 0) or either as a vector.
static bool isZero(const Expr *expr) {
  if (auto *number = dyn_cast<NumberExpr>(expr))
    return number->value == 0;
  if (auto *tuple = dyn_cast<TupleExpr>(expr))
    return llvm::all_of(tuple->elements, isZero);
  auto *cast = dyn_cast<CastExpr>(expr);
  return cast && !cast->space && isZero(cast->operand);
}

/// `L = 0`, which classic ambient lights say although it is so anyway.
static bool saysAmbient(const AssignExpr &assign) {
  auto *target = dyn_cast<NameExpr>(assign.target);
  return target && target->decl->kind == VarKind::Global && target->name == "L" &&
         isZero(assign.value);
}

/// The value of an assignment is that of its target afterwards.
Value *Lowering::lowerAssign(const AssignExpr &assign) {
  bool isSimple = isa<NameExpr>(assign.target);
  if (assign.isCompound) {
    Place target = place(assign.target);
    Value *old = load(target, assign.target->type);
    opaques[assign.old] = old;
    Value *value = lower(assign.value);
    at(assign.loc);
    store(target, value);
    return target.component ? value : target.slot;
  }
  // A place with an index is found before the value, which could change the index.
  Place target;
  if (!isSimple)
    target = place(assign.target);
  if (auto *list = dyn_cast<ListExpr>(assign.value)) {
    Place array = place(assign.target);
    Value *value = copied(assign.target->type, array.slot); // the list may name the array
    lowerListInto(*list, value);
    copy(assign.target->type, array.slot, value);
    return array.slot;
  }
  Value *value = lower(assign.value);
  at(assign.loc);
  if (saysAmbient(assign))
    target = {slotOf(*cast<NameExpr>(assign.target)->decl), assign.type, nullptr};
  else if (isSimple)
    target = place(assign.target);
  store(target, value);
  return target.component ? value : target.slot;
}

Value *Lowering::lowerTuple(const TupleExpr &tuple) {
  SmallVector<Value *, 17> operands{nullptr};
  for (size_t i = 0; i < tuple.elements.size(); ++i) {
    bool effectsFollow = false;
    for (const Expr *later : tuple.elements.drop_front(i + 1))
      effectsFollow |= later->hasEffects;
    operands.push_back(lowerBefore(tuple.elements[i], effectsFollow));
  }
  at(tuple.loc);
  operands[0] = temporary(tuple.type);
  b.call(tuple.type.is(TypeKind::Matrix)
             ? Op::make_matrix
             : opFor(tuple.type.kind, Op::make_color, Op::make_color, Op::make_vector),
         operands);
  return operands[0];
}

/// The matrix between two named coordinate systems.
Value *Lowering::spaceMatrix(Value *from, Value *to, SMLoc loc) {
  Value *matrix = temporary({TypeKind::Matrix});
  if (hasContext(loc))
    b.call(Op::space_matrix, {matrix, b.context(), from, to});
  return matrix;
}

Value *Lowering::lowerCast(const CastExpr &cast) {
  Type from = cast.operand->type;
  Value *value;
  if (from.is(TypeKind::Bool)) {
    Value *condition = lowerCondition(cast.operand);
    at(cast.loc);
    value = temporary({TypeKind::Float, from.varying});
    b.call(Op::float_from_test, {value, condition});
    from = {TypeKind::Float, from.varying};
  } else {
    value = lower(cast.operand);
  }
  at(cast.loc);
  value = convert(value, from, {cast.to, from.varying});
  if (!cast.space)
    return value;
  Value *space = lower(cast.space);
  at(cast.loc);
  Value *result = temporary(cast.type);
  switch (cast.to) {
  case TypeKind::Color:
    b.call(Op::ctransform, {result, space, text("rgb"), value});
    break;
  case TypeKind::Point:
    b.call(Op::transform_point, {result, spaceMatrix(space, text("current"), cast.loc), value});
    break;
  case TypeKind::Vector:
    b.call(Op::transform_vector, {result, spaceMatrix(space, text("current"), cast.loc), value});
    break;
  case TypeKind::Normal:
    b.call(Op::transform_normal, {result, spaceMatrix(space, text("current"), cast.loc), value});
    break;
  default: // a matrix: what it does in that space, then on to "current"
    b.call(Op::mul_matrix, {result, value, spaceMatrix(space, text("current"), cast.loc)});
  }
  return result;
}

/// Elements that the list does not give are 0.
void Lowering::lowerListInto(const ListExpr &list, Value *array) {
  Type element = list.type.element();
  if (Value *length = lengths.lookup(array)) {
    for (size_t i = 0; i < list.elements.size() && i < capacityOf(array); ++i) {
      Value *value = lower(list.elements[i]);
      at(list.loc);
      copy(element, elementOf(array, unsigned(i)), value);
    }
    b.call(Op::const_float, {length, b.number(double(list.elements.size()))});
    return;
  }
  for (int i = 0; i < list.type.length; ++i) {
    Value *value = size_t(i) < list.elements.size() ? lower(list.elements[i]) : zero(element);
    at(list.loc);
    copy(element, elementOf(array, unsigned(i)), value);
  }
}

} // namespace anysl::rsl
