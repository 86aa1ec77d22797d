//===-- frontends/rsl/LowerTraced.cpp - lookups in "raytrace" ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Where the name of an environment or shadow map is "raytrace", rays take the place of the file. It
// is commonly a parameter, and then known when the shader runs:
//
//     if (name == "raytrace") rays else the lookup
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

static bool isShadow(Op op) { return op == Op::shadow || op == Op::shadow_corners; }

static bool isEnvironment(Op op) {
  return is_contained({Op::environment_float, Op::environment_color, Op::environment_corners_float,
                       Op::environment_corners_color},
                      op);
}

bool Lowering::mayBeTraced(const CallExpr &call) const {
  if (!shaderType || initOf)
    return false;
  auto *constant = dyn_cast_or_null<StringExpr>(call.args.empty() ? nullptr : call.args[0]);
  if (constant && constant->value != "raytrace")
    return false;
  Op op = call.builtin->op;
  return isEnvironment(op) || isShadow(op);
}

/// The value of an argument by name that no operand takes.
Value *Lowering::rayField(const CallExpr &call, StringRef name) {
  const NamedGroup &group = *call.builtin->named;
  for (auto [i, field] : enumerate(group.fields))
    if (field.name == name)
      return call.named[i]                    ? lower(call.named[i])
             : field.type == TypeKind::String ? text("")
                                              : number(field.number);
  llvm_unreachable("NamedArguments.def lacks a field");
}

/// What of a light passes on its way to a place: of the light whose shader asks, or else of the one
/// that illuminance is at. Elsewhere there is none, and no shadow.
void Lowering::lowerTracedShadow(Value *passing, Value *place, ArrayRef<Value *> cone, SMLoc loc) {
  Type vector{TypeKind::Vector, true}, color{TypeKind::Color, true};
  bool inLight = *shaderType == ShaderType::Light;
  Value *to = temporary(vector);
  if (inLight) {
    // L is the way from the light to the point that it shines on.
    Value *way = globalSlot(globalNumber("L"));
    if (isSolar) {
      Value *unit = temporary(vector), *far = temporary(vector);
      b.call(Op::normalize, {unit, way});
      b.call(Op::scale_vector, {far, unit, number(1e12)});
      way = far;
    }
    b.call(Op::sub_vector, {to, place, way});
  } else if (currentLight.index) {
    b.call(Op::light_end, {to, b.context(), currentLight.index, currentLight.position,
                           lightGlobals[globalNumber("L")]});
  } else {
    copy(color, passing, convert(number(1), {TypeKind::Float}, color));
    warnWhenRun("there is no light here that shadow(\"raytrace\") could be of, outside of light "
                "shaders and illuminance",
                loc);
    return;
  }
  SmallVector<Value *, 8> operands{passing, b.context(), place, to};
  llvm::append_range(operands, cone);
  b.call(cone.empty() ? Op::transmission : Op::transmission_cone, operands);
}

Value *Lowering::lowerTraced(const CallExpr &call, ArrayRef<Value *> operands, Op op) {
  Type vector{TypeKind::Vector, true}, color{TypeKind::Color, true}, scalar{TypeKind::Float, true};
  bool shadow = isShadow(op);
  // (result, context, name, place or four of them, …)
  Value *result = operands[0], *place = operands[3];
  if (op == Op::shadow_corners || op == Op::environment_corners_float ||
      op == Op::environment_corners_color) {
    for (unsigned i = 1; i < 4; ++i) {
      Value *sum = temporary(vector);
      b.call(Op::add_vector, {sum, place, operands[3 + i]});
      place = sum;
    }
    Value *mean = temporary(vector);
    b.call(Op::scale_vector, {mean, place, number(0.25)});
    place = mean;
  }
  // A cone of rays only where an argument asks for one.
  bool isCone = false;
  for (auto [i, field] : enumerate(call.builtin->named->fields))
    isCone |= field.isForRays && call.named[i];
  SmallVector<Value *, 5> cone;
  if (isCone && !shadow)
    cone.push_back(rayField(call, "maxdist"));
  if (isCone)
    cone.append({rayField(call, shadow ? "raysamples" : "samples"), rayField(call, "samplecone"),
                 rayField(call, "subset"), rayField(call, "hitsides")});
  at(call.loc);
  BasicBlock *rays = b.block("rays"), *file = b.block("file"), *join = b.block("looked.up");
  branchIf(b.call(Op::eq_string, {operands[2], text("raytrace")}), rays, file);

  continueIn(rays);
  Value *light = temporary(color);
  if (shadow) {
    lowerTracedShadow(light, place, cone, call.loc);
  } else {
    Value *from = globalSlot(globalNumber(*shaderType == ShaderType::Light ? "Ps" : "P"));
    SmallVector<Value *, 9> rayOperands{light, b.context(), from, place};
    rayOperands.append(cone);
    b.call(isCone ? Op::trace_cone : Op::trace_color, rayOperands);
  }
  if (shadow) {
    Value *third = temporary(color), *sum = number(0);
    b.call(Op::scale_color, {third, light, number(1. / 3)});
    for (unsigned i = 0; i < 3; ++i) {
      Value *component = temporary(scalar), *total = temporary(scalar);
      b.call(Op::get_color, {component, third, number(i)});
      b.call(Op::add_float, {total, sum, component});
      sum = total;
    }
    b.call(Op::sub_float, {result, number(1), sum});
  } else if (op == Op::environment_float || op == Op::environment_corners_float) {
    b.call(Op::get_color, {result, light, rayField(call, "channel")});
  } else {
    copy(color, result, light);
  }
  branchTo(join);

  continueIn(file);
  b.call(op, operands);
  branchTo(join);
  continueIn(join);
  return nullptr;
}

} // namespace anysl::rsl
