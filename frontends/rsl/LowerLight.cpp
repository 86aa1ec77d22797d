//===-- frontends/rsl/LowerLight.cpp - illuminance, illuminate, solar, lightsource ------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A light shader says where its light goes by what L is at its end: from the light to Ps, or the
// zero vector where no light arrives. L is zero until an illuminate or solar statement whose cone
// holds Ps, or an assignment, sets it; of several the last counts. A light shader that never does,
// or only to 0, is an ambient light.
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"
#include "frontends/rsl/Sema.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

static constexpr Type vectorType{TypeKind::Vector, true}, colorType{TypeKind::Color, true};

unsigned Lowering::globalNumber(StringRef name) {
  for (const stc::GlobalVariableInfo &global : stc::allGlobals())
    if (global.name == name)
      return global.id;
  llvm_unreachable("Globals.def lacks a light's variable");
}

/// illuminance runs its body for each light that reaches the point, inside of the cone if there is
/// one:
///
///     for (i = 0; i < light_count(); ++i)
///       if (light_in_category(i, category))
///         if (light_sample(i, P, axis or N, [what is sent,] L, Cl, Ol) & in_cone(L, axis, angle))
///         {
///           light_shadow(i, P, L, Cl);
///           body
///         }
void Lowering::lowerIlluminance(const LightStmt &stmt) {
  if (!hasContext(stmt.loc))
    return;
  Value *category = lowerLasting(stmt.category);
  Value *position = lowerLasting(stmt.position);
  Value *axis = lowerLasting(stmt.axis);
  Value *angle = lowerLasting(stmt.angle);
  at(stmt.loc);
  // A light sees the surface as this loop does: lit are those sides that the cone is about.
  Value *normal = axis;
  if (!normal) {
    normal = temporary(vectorType);
    copy(vectorType, normal, globalSlot(globalNumber("N")));
  }
  Value *count = b.call(Op::light_count, {b.context()});
  CurrentLight current;
  current.position = position, current.normal = normal;
  packSent(stmt, current);
  at(stmt.loc);
  Value *direction = temporary(vectorType, "L");
  Value *light = temporary(colorType, "Cl");
  Value *opacity = temporary(colorType, "Ol");

  BasicBlock *before = builder().GetInsertBlock();
  BasicBlock *head = b.block("lights"), *belongs = category ? b.block("light.belongs") : nullptr,
             *sample = b.block("light.sample"), *body = b.block("light.body"),
             *step = b.block("light.next"), *end = b.block("lights.end");
  branchTo(head);
  continueIn(head);
  PHINode *index = builder().CreatePHI(builder().getInt32Ty(), 2, "light");
  index->addIncoming(b.index(0), before);
  branchIf(builder().CreateICmpULT(index, count), category ? belongs : sample, end);
  if (category) {
    continueIn(belongs);
    branchIf(b.call(Op::light_in_category, {b.context(), index, category}), sample, step);
  }
  continueIn(sample);
  SmallVector<Value *, 16> operands{b.context(), index, position, normal};
  if (current.sentNames) {
    operands.push_back(current.sentNames);
    appendOperands(current.sent, operands);
  }
  operands.append({direction, light, opacity});
  Value *reaches = b.call(current.sentNames ? Op::light_sample_sent : Op::light_sample, operands);
  if (axis)
    reaches = builder().CreateAnd(reaches, b.call(Op::in_cone, {direction, axis, angle}));
  branchIf(reaches, body, step);

  continueIn(body);
  b.call(Op::light_shadow, {b.context(), index, position, direction, light});
  std::map<unsigned, Value *> outerGlobals = lightGlobals;
  lightGlobals[globalNumber("L")] = direction;
  lightGlobals[globalNumber("Cl")] = light;
  lightGlobals[globalNumber("Ol")] = opacity;
  current.index = index;
  CurrentLight outer = std::exchange(currentLight, current);
  loops.push_back({end, step});
  for (const LightMessage &message : stmt.asked)
    askLight(text(message.name), message.value, stmt.loc);
  lower(stmt.body);
  loops.pop_back();
  currentLight = outer;
  lightGlobals = std::move(outerGlobals);
  at(stmt.loc);
  branchTo(step);
  continueIn(step);
  index->addIncoming(builder().CreateAdd(index, b.index(1)), step);
  branchTo(head);
  continueIn(end);
}

/// "send:light:NAME", value: the values are those before the loop, the same for each light.
void Lowering::packSent(const LightStmt &stmt, CurrentLight &light) {
  if (stmt.sent.empty())
    return;
  SmallVector<Value *, 4> values;
  std::string names;
  for (const LightMessage &message : stmt.sent) {
    values.push_back(lowerLasting(message.value));
    names += names.empty() ? "" : ",";
    names += (message.name + ":").str() + addItem(light.sent, message.value->type, values.back());
  }
  at(stmt.loc);
  makeArrays(light.sent, stmt.loc);
  for (unsigned i = 0; i < values.size(); ++i)
    pack(light.sent, i, values[i]);
  light.sentNames = text(names);
}

/// illuminate and solar set L and run their body where the light goes.
void Lowering::lowerIlluminate(const LightStmt &stmt) {
  unsigned L = globalNumber("L");
  writtenGlobals.insert(L);
  writtenGlobals.insert(globalNumber("Cl"));
  Value *axis = lowerLasting(stmt.axis);
  Value *angle = lowerLasting(stmt.angle);
  Value *to = temporary(vectorType);
  if (stmt.kind == StmtKind::Illuminate) {
    b.call(Op::sub_vector, {to, globalSlot(globalNumber("Ps")), lower(stmt.position)});
  } else if (axis) {
    b.call(Op::solar_direction, {to, axis});
  } else {
    Value *down = temporary(vectorType);
    b.call(Op::neg_vector, {down, globalSlot(globalNumber("Ns"))});
    b.call(Op::solar_direction, {to, down});
  }
  at(stmt.loc);
  bool hasCone = stmt.kind == StmtKind::Illuminate && axis;
  BasicBlock *inside = hasCone ? b.block("lit") : nullptr, *join = b.block("lit.end");
  if (hasCone) {
    branchIf(b.call(Op::in_cone, {to, axis, angle}), inside, join);
    continueIn(inside);
  }
  copy(vectorType, globalSlot(L), to);
  bool outer = std::exchange(isSolar, stmt.kind == StmtKind::Solar);
  lower(stmt.body);
  isSolar = outer;
  branchTo(join);
  continueIn(join);
}

/// What a light shader gives starts as no light, of full opacity.
bool Lowering::startLightResult(unsigned id, Value *slot) {
  if (id == globalNumber("L"))
    setZero(vectorType, slot);
  else if (id == globalNumber("Cl"))
    setZero(colorType, slot);
  else if (id == globalNumber("Ol"))
    copy(colorType, slot, convert(number(1), {TypeKind::Float}, colorType));
  else
    return false;
  return true;
}

/// Where no light arrives its colour is black.
void Lowering::finishLight() {
  unsigned L = globalNumber("L"), Cl = globalNumber("Cl");
  if (!writtenGlobals.count(L) || !writtenGlobals.count(Cl))
    return;
  BasicBlock *unlit = b.block("unlit"), *join = b.block("unlit.end");
  branchIf(b.call(Op::eq_vector, {globalSlot(L), zero(vectorType)}), unlit, join);
  continueIn(unlit);
  setZero(colorType, globalSlot(Cl));
  branchTo(join);
  continueIn(join);
}

/// Sets a variable to the parameter of that name of the light that illuminance is at, if it has
/// one: an i1 says so.
Value *Lowering::askLight(Value *name, const Expr *variable, SMLoc loc) {
  Place target = place(variable);
  at(loc);
  Type type = variable->type.element();
  Op op = type.is(TypeKind::Matrix) ? Op::light_matrix
          : isTextual(type.kind)
              ? Op::light_string
              : opFor(type.kind, Op::light_float, Op::light_color, Op::light_vector);
  CurrentLight light = currentLight;
  if (!light.sentNames) {
    light.sentNames = text("");
    makeArrays(light.sent, loc);
  }
  auto ask = [&](Value *slot, unsigned length, unsigned element) {
    SmallVector<Value *, 16> operands{b.context(), light.index, light.position, light.normal,
                                      light.sentNames};
    appendOperands(light.sent, operands);
    operands.append({name, b.length(length), b.length(element), slot});
    return b.call(op, operands);
  };
  unsigned length = variable->type.isArray() ? capacityOf(target.slot) : 0;
  if (!length) {
    Value *value = temporary(type);
    copy(type, value, load(target, type));
    Value *found = ask(value, 0, 0);
    store(target, value);
    return found;
  }
  Value *found = nullptr;
  for (unsigned i = 0; i < length; ++i) {
    Value *known = ask(elementOf(target.slot, i), length, i);
    found = found ? builder().CreateAnd(found, known) : known;
  }
  return found;
}

Value *Lowering::callLightSource(const CallExpr &call) {
  Value *name = lowerLasting(call.args[0]);
  at(call.loc);
  if (!currentLight.index)
    return number(0);
  Value *result = temporary({TypeKind::Float, true});
  b.call(Op::float_from_test, {result, askLight(name, call.args[1], call.loc)});
  return result;
}

} // namespace anysl::rsl
