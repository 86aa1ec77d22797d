//===-- frontends/rsl/LowerSpline.cpp - splines -----------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"
#include "frontends/rsl/Sema.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

namespace {

/// One segment of a curve: knots k0 … k3 have the weights  w[i] = ((m[i][0] t + m[i][1]) t +
/// m[i][2]) t + m[i][3] for t in [0, 1]; the next segment begins `step` knots later.
struct Basis {
  unsigned step;
  double weights[4][4];
};

/// The basis matrices of the RenderMan Interface (RiCatmullRomBasis …), a column for each knot.
/// "linear" goes from the second knot to the last but one, so that it can stand in for Catmull-Rom.
const Basis &basisOf(SplineBasis basis) {
  static constexpr Basis catmullRom{
      1, {{-0.5, 1, -0.5, 0}, {1.5, -2.5, 0, 1}, {-1.5, 2, 0.5, 0}, {0.5, -0.5, 0, 0}}};
  static constexpr Basis bezier{3, {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}}};
  static constexpr Basis bspline{1,
                                 {{-1. / 6, 0.5, -0.5, 1. / 6},
                                  {0.5, -1, 0, 4. / 6},
                                  {-0.5, 0.5, 0.5, 1. / 6},
                                  {1. / 6, 0, 0, 0}}};
  // Knots are value, slope, value, slope.
  static constexpr Basis hermite{2, {{2, -3, 0, 1}, {1, -2, 1, 0}, {-2, 3, 0, 0}, {1, -1, 0, 0}}};
  static constexpr Basis power{4, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  static constexpr Basis linear{1, {{0, 0, 0, 0}, {0, 0, -1, 1}, {0, 0, 1, 0}, {0, 0, 0, 0}}};
  switch (basis) {
  case SplineBasis::CatmullRom:
    return catmullRom;
  case SplineBasis::Bezier:
    return bezier;
  case SplineBasis::BSpline:
    return bspline;
  case SplineBasis::Hermite:
    return hermite;
  case SplineBasis::Power:
    return power;
  case SplineBasis::Linear:
    return linear;
  }
  llvm_unreachable("unknown basis");
}

} // namespace

/// Slots for what text says of a curve at run time: the weights, row by row, and the step. What is
/// no name means Catmull-Rom.
static constexpr unsigned stepOfBasis = 16, basisSlots = 17;

void Lowering::chooseBasis(Value *name, MutableArrayRef<Value *> to) {
  auto set = [&](SplineBasis which) {
    const Basis &basis = basisOf(which);
    for (unsigned i = 0; i < 16; ++i)
      b.call(Op::const_float, {to[i], b.number(basis.weights[i / 4][i % 4])});
    b.call(Op::const_float, {to[stepOfBasis], b.number(basis.step)});
  };
  for (Value *&slot : to)
    slot = temporary({TypeKind::Float, true});
  set(SplineBasis::CatmullRom);
  BasicBlock *end = b.block("basis.end");
  ArrayRef<std::pair<StringLiteral, SplineBasis>> names = splineBases();
  for (size_t i = 0; i < names.size();) {
    SplineBasis basis = names[i].second;
    Value *isNamed = nullptr;
    for (; i < names.size() && names[i].second == basis; ++i) {
      Value *same = b.call(Op::eq_string, {name, text(names[i].first)});
      isNamed = isNamed ? builder().CreateOr(isNamed, same) : same;
    }
    if (basis == SplineBasis::CatmullRom)
      continue;
    BasicBlock *named = b.block("basis"), *other = b.block("basis.other");
    branchIf(isNamed, named, other);
    continueIn(named);
    set(basis);
    branchTo(end);
    continueIn(other);
  }
  branchTo(end);
  continueIn(end);
}

/// The segment is floor(x) for x = clamp(value, 0, 1) * segments, but for the last knot's sake
/// never more than the last one; t is what remains of x.
Value *Lowering::callSpline(const CallExpr &call) {
  const Basis &basis = basisOf(call.basis);
  Type scalar{TypeKind::Float, call.type.varying};
  Value *name = lowerLasting(call.basisName);
  Value *value = lowerBefore(call.args[0], call.hasEffects);
  Value *knots;
  if (call.args[1]->type.isArray()) {
    knots = lower(call.args[1]);
  } else {
    Type array = call.type;
    array.length = static_cast<int>(call.args.size()) - 1;
    knots = temporary(array, "knots");
    for (size_t i = 0; i + 1 < call.args.size(); ++i) {
      Value *knot = lower(call.args[i + 1]);
      at(call.loc);
      copy(call.type, elementOf(knots, unsigned(i)), knot);
    }
  }
  at(call.loc);
  auto apply = [&](Op op, std::initializer_list<Value *> operands) {
    SmallVector<Value *, 4> all{temporary(scalar)};
    all.append(operands);
    b.call(op, all);
    return all[0];
  };
  SmallVector<Value *, basisSlots> chosen(name ? basisSlots : 0, nullptr);
  if (name)
    chooseBasis(name, chosen);
  Value *step = name ? chosen[stepOfBasis] : number(basis.step), *segments;
  if (name || lengths.count(knots)) {
    // 1 + floor((count - 4) / step), but at least 1.
    Value *behind = apply(Op::sub_float, {lengthOf(knots), number(4)});
    Value *more = apply(Op::floor, {apply(Op::div_float, {behind, step})});
    segments = apply(Op::max_float, {apply(Op::add_float, {more, number(1)}), number(1)});
  } else {
    unsigned count = capacityOf(knots);
    segments = number(count < 4 ? 1 : (count - 4) / basis.step + 1);
  }
  Value *x =
      apply(Op::mul_float, {apply(Op::clamp_float, {value, number(0), number(1)}), segments});
  Value *segment =
      apply(Op::min_float, {apply(Op::floor, {x}), apply(Op::sub_float, {segments, number(1)})});
  Value *t = apply(Op::sub_float, {x, segment});
  Value *first = apply(Op::mul_float, {segment, step});
  Value *sum = nullptr;
  for (unsigned i = 0; i < 4; ++i) {
    Value *weight = nullptr;
    for (unsigned k = 0; k < 4; ++k) {
      double coefficient = basis.weights[i][k];
      Value *next = name ? chosen[4 * i + k] : nullptr;
      if (!next && (weight || coefficient != 0))
        next = number(coefficient);
      weight = weight ? apply(Op::add_float, {apply(Op::mul_float, {weight, t}), next}) : next;
    }
    if (!weight)
      continue;
    Value *position = apply(Op::add_float, {first, number(i)});
    Value *knot = b.element(knots, b.call(Op::index, {position}));
    Value *part = temporary(call.type);
    b.call(opFor(call.type.kind, Op::mul_float, Op::scale_color, Op::scale_vector),
           {part, knot, weight});
    if (!sum) {
      sum = part;
      continue;
    }
    Value *total = temporary(call.type);
    b.call(opFor(call.type.kind, Op::add_float, Op::add_color, Op::add_vector), {total, sum, part});
    sum = total;
  }
  return sum;
}

} // namespace anysl::rsl
