//===-- frontends/rsl/LowerGather.cpp - gather() ----------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

static bool isKnownOnMiss(GatherValue value) {
  switch (value) {
#define RSL_GATHER_OUTPUT(id, name, type, onMiss, meaning)                                         \
  case GatherValue::id:                                                                            \
    return onMiss;
#include "frontends/rsl/GatherOutputs.def"
  }
  llvm_unreachable("unknown output");
}

/// What is asked about a surface besides GatherOutputs.def, and the values that the variables have
/// now, which stay where there is no answer. Null: nothing.
Value *Lowering::packAsked(const GatherStmt &stmt, Message &message) {
  if (stmt.asked.empty())
    return nullptr;
  SmallVector<Value *, 4> values;
  std::string names;
  for (const LightMessage &asked : stmt.asked) {
    Place target = place(asked.value);
    values.push_back(load(target, asked.value->type));
    names += names.empty() ? "" : ",";
    names += (asked.name + ":").str() + (target.component
                                             ? addItem(message, asked.value->type, 0u)
                                             : addItem(message, asked.value->type, values.back()));
  }
  at(stmt.loc);
  makeArrays(message, stmt.loc);
  for (unsigned i = 0; i < values.size(); ++i)
    pack(message, i, values[i]);
  return text(names);
}

/// One ray for each sample, and then the body or the other one:
///
///     for (i = 0; i < floor(samples + 0.5); ++i) {
///       direction = cone_direction(axis, angle, i, samples, cosine)
///       if (trace_hit(P, direction, maxdist, …)) { outputs; body } else { other }
///     }
///
/// Rays of the category "samplepattern" meet nothing.
void Lowering::lowerGather(const GatherStmt &stmt) {
  if (!hasContext(stmt.loc))
    return;
  Type scalar{TypeKind::Float, true}, vector{TypeKind::Vector, true}, color{TypeKind::Color, true};
  auto *category = dyn_cast<StringExpr>(stmt.category);
  if (!category)
    lower(stmt.category);
  bool traces = !category || category->value != "samplepattern";
  Value *position = lowerLasting(stmt.position);
  Value *axis = lowerLasting(stmt.direction);
  Value *angle = lowerLasting(stmt.angle);
  Value *samples = lowerLasting(stmt.samples);
  const Expr *reachExpr = stmt.named[0];
  Value *bias = lowerLasting(stmt.named[2]);
  Value *reach = reachExpr ? lowerLasting(reachExpr) : number(1e30);
  auto textField = [&](unsigned i) {
    return stmt.named[i] ? lowerLasting(stmt.named[i]) : text("");
  };
  Value *distribution = textField(1), *kind = textField(3), *subset = textField(4),
        *sides = textField(5);
  at(stmt.loc);
  auto apply = [&](Op op, std::initializer_list<Value *> operands) {
    SmallVector<Value *, 4> all{temporary(scalar)};
    all.append(operands);
    b.call(op, all);
    return all[0];
  };
  Value *cosine = temporary(scalar);
  b.call(Op::float_from_test, {cosine, b.call(Op::eq_string, {distribution, text("cosine")})});
  Value *count = apply(Op::floor, {apply(Op::add_float, {samples, number(0.5)})});
  Value *index = temporary(scalar, "sample");
  copy(scalar, index, number(0));

  BasicBlock *head = b.block("samples"), *sample = b.block("sample.ray"),
             *hit = b.block("sample.hit"), *miss = b.block("sample.miss"),
             *step = b.block("sample.next"), *end = b.block("samples.end");
  branchTo(head);
  continueIn(head);
  branchIf(b.call(Op::lt_float, {index, count}), sample, end);
  continueIn(sample);
  Value *direction = temporary(vector, "direction");
  b.call(Op::cone_direction, {direction, b.context(), axis, angle, index, count, cosine});
  Value *distance = temporary(scalar, "distance"), *N = temporary(vector), *Ng = temporary(vector),
        *Ci = temporary(color), *Oi = temporary(color), *P = temporary(vector);
  auto give = [&](bool onMiss) {
    for (const GatherStmt::Output &output : stmt.outputs) {
      if (isKnownOnMiss(output.value) != onMiss)
        continue;
      Value *value = nullptr;
      switch (output.value) {
      case GatherValue::RayOrigin:
        value = position;
        break;
      case GatherValue::RayDirection:
        value = direction;
        break;
      case GatherValue::RayLength:
        value = distance;
        break;
      case GatherValue::SurfaceP:
      case GatherValue::PrimitiveP:
        value = P;
        break;
      case GatherValue::SurfaceN:
      case GatherValue::PrimitiveN:
        value = N;
        break;
      case GatherValue::SurfaceNg:
      case GatherValue::PrimitiveNg:
        value = Ng;
        break;
      case GatherValue::SurfaceCi:
        value = Ci;
        break;
      case GatherValue::SurfaceOi:
        value = Oi;
        break;
      }
      Place target = place(output.target);
      at(stmt.loc);
      store(target, convert(value, {output.type, true}, output.target->type));
    }
  };
  auto run = [&](const Stmt *body) {
    loops.push_back({end, step});
    lower(body);
    loops.pop_back();
    at(stmt.loc);
    branchTo(step);
  };
  give(true);
  if (traces) {
    Value *start = position, *left = reach;
    if (bias) {
      Value *skipped = temporary(vector);
      b.call(Op::scale_vector, {skipped, direction, bias});
      start = temporary(vector);
      b.call(Op::add_vector, {start, position, skipped});
      left = apply(Op::sub_float, {reach, bias});
    }
    Message message;
    Value *asked = packAsked(stmt, message);
    bool shades = any_of(stmt.outputs, [](const GatherStmt::Output &output) {
      return output.value == GatherValue::SurfaceCi || output.value == GatherValue::SurfaceOi;
    });
    SmallVector<Value *, 17> operands{b.context(), start, direction, left, kind, subset, sides};
    if (asked) {
      operands.push_back(asked);
      appendOperands(message, operands);
    }
    operands.append({distance, N, Ng});
    if (asked || shades)
      operands.append({Ci, Oi});
    branchIf(b.call(asked    ? Op::trace_values
                    : shades ? Op::trace_shade
                             : Op::trace_hit,
                    operands),
             hit, miss);
    continueIn(hit);
    if (bias)
      copy(scalar, distance, apply(Op::add_float, {distance, bias}));
    for (unsigned i = 0; asked && i < message.items.size(); ++i)
      store(place(stmt.asked[i].value), unpack(message, i));
    at(stmt.loc);
    Value *way = temporary(vector);
    b.call(Op::scale_vector, {way, direction, distance});
    b.call(Op::add_vector, {P, position, way});
    give(false);
    run(stmt.body);
  } else {
    branchTo(miss);
    hit->eraseFromParent();
  }
  continueIn(miss);
  run(stmt.elseBody);
  continueIn(step);
  copy(scalar, index, apply(Op::add_float, {index, number(1)}));
  branchTo(head);
  continueIn(end);
}

} // namespace anysl::rsl
