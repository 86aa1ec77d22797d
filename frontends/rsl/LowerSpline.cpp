//===-- frontends/rsl/LowerSpline.cpp - splines -----------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"

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

/// The segment is floor(x) for x = clamp(value, 0, 1) * segments, but for the last knot's sake
/// never more than the last one; t is what remains of x.
Value *Lowering::callSpline(const CallExpr &call) {
  const Basis &basis = basisOf(call.basis);
  Type scalar{TypeKind::Float, call.type.varying};
  Value *value = lowerBefore(call.args[0], call.hasEffects);
  Value *knots;
  unsigned count;
  if (call.args[1]->type.isArray()) {
    knots = lower(call.args[1]);
    count = stc::slotInfo(knots)->arrayLength;
  } else {
    count = static_cast<unsigned>(call.args.size()) - 1;
    Type array = call.type;
    array.length = static_cast<int>(count);
    knots = temporary(array, "knots");
    for (unsigned i = 0; i < count; ++i) {
      Value *knot = lower(call.args[i + 1]);
      at(call.loc);
      copy(call.type, elementOf(knots, i), knot);
    }
  }
  at(call.loc);
  auto apply = [&](Op op, std::initializer_list<Value *> operands) {
    SmallVector<Value *, 4> all{temporary(scalar)};
    all.append(operands);
    b.call(op, all);
    return all[0];
  };
  unsigned segments = count < 4 ? 1 : (count - 4) / basis.step + 1;
  Value *x = apply(Op::mul_float,
                   {apply(Op::clamp_float, {value, number(0), number(1)}), number(segments)});
  Value *segment = apply(Op::min_float, {apply(Op::floor, {x}), number(segments - 1)});
  Value *t = apply(Op::sub_float, {x, segment});
  Value *first = apply(Op::mul_float, {segment, number(basis.step)});
  Value *sum = nullptr;
  for (unsigned i = 0; i < 4; ++i) {
    const double(&w)[4] = basis.weights[i];
    Value *weight = nullptr;
    for (double coefficient : w) {
      if (weight)
        weight = apply(Op::add_float, {apply(Op::mul_float, {weight, t}), number(coefficient)});
      else if (coefficient != 0)
        weight = number(coefficient);
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
