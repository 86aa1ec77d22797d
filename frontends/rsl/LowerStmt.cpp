//===-- frontends/rsl/LowerStmt.cpp - statements ----------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

static constexpr WarningGroup LightCategory{"light-category", true};

void Lowering::branchTo(BasicBlock *block) {
  if (isOpen())
    builder().CreateBr(block);
}

void Lowering::branchIf(Value *condition, BasicBlock *whenTrue, BasicBlock *whenFalse) {
  builder().CreateCondBr(condition, whenTrue, whenFalse);
}

/// Blocks stand in the order in which they are written.
void Lowering::continueIn(BasicBlock *block) {
  if (!block->isEntryBlock())
    block->moveAfter(&block->getParent()->back());
  builder().SetInsertPoint(block);
}

void Lowering::lowerBody(const BlockStmt &block) {
  for (const Stmt *stmt : block.body)
    lower(stmt);
}

void Lowering::lower(const Stmt *stmt) {
  // Behind a return, break or continue nothing is reached.
  if (!stmt || !isOpen())
    return;
  at(stmt->loc);
  switch (stmt->kind) {
  case StmtKind::Empty:
  case StmtKind::Extern:
  case StmtKind::Function:
  case StmtKind::Struct:
    break;
  case StmtKind::Block:
    lowerBody(*cast<BlockStmt>(stmt));
    break;
  case StmtKind::Declaration:
    for (const VarDecl *decl : cast<DeclarationStmt>(stmt)->variables)
      lowerVariable(*decl);
    break;
  case StmtKind::Expression:
    lower(cast<ExpressionStmt>(stmt)->expr);
    break;
  case StmtKind::If:
    lowerIf(*cast<IfStmt>(stmt));
    break;
  case StmtKind::While:
  case StmtKind::For:
    lowerLoop(*cast<LoopStmt>(stmt));
    break;
  case StmtKind::Break:
  case StmtKind::Continue: {
    const Loop &loop = loops[loops.size() - cast<JumpStmt>(stmt)->levels];
    branchTo(stmt->kind == StmtKind::Break ? loop.onBreak : loop.onContinue);
    break;
  }
  case StmtKind::Return:
    lowerReturn(*cast<ReturnStmt>(stmt));
    break;
  case StmtKind::Illuminance:
    lowerIlluminance(*cast<LightStmt>(stmt));
    break;
  case StmtKind::Gather:
    lowerGather(*cast<GatherStmt>(stmt));
    break;
  case StmtKind::Illuminate:
  case StmtKind::Solar:
    lowerIlluminate(*cast<LightStmt>(stmt));
    break;
  }
}

void Lowering::lowerVariable(const VarDecl &decl) {
  at(decl.range.Start);
  if (decl.type.structure) {
    for (const VarDecl *member : decl.members)
      lowerVariable(*member);
    if (decl.init)
      lower(decl.init); // an assignment
    return;
  }
  // The value is computed before the name means the new slot: `float s = s`.
  Value *value = nullptr;
  auto *list = dyn_cast_or_null<ListExpr>(decl.init);
  if (decl.init && !list)
    value = lower(decl.init);
  at(decl.range.Start);
  Value *slot = temporary(decl.type, decl.name);
  if (lengths.count(slot)) {
    if (decl.length) {
      Value *count = lower(decl.length);
      at(decl.range.Start);
      setLength(slot, count);
    } else {
      b.call(Op::const_float, {lengths.lookup(slot), b.number(0)});
    }
  }
  if (list)
    lowerListInto(*list, slot);
  else if (value && decl.type.isArray() && !decl.init->type.isArray())
    // A member of structures in an array: each has the default.
    for (int i = 0; i < decl.type.length; ++i)
      copy(decl.type.element(), elementOf(slot, unsigned(i)), value);
  else if (value)
    copy(decl.type, slot, value);
  slots[&decl] = slot;
}

void Lowering::lowerIf(const IfStmt &stmt) {
  Value *condition = lowerCondition(stmt.condition);
  BasicBlock *whenTrue = b.block("then"), *join = b.block("endif");
  BasicBlock *whenFalse = stmt.elseBody ? b.block("else") : join;
  branchIf(condition, whenTrue, whenFalse);
  continueIn(whenTrue);
  lower(stmt.thenBody);
  branchTo(join);
  if (stmt.elseBody) {
    continueIn(whenFalse);
    lower(stmt.elseBody);
    branchTo(join);
  }
  continueIn(join);
}

void Lowering::lowerLoop(const LoopStmt &stmt) {
  lower(stmt.init);
  BasicBlock *head = b.block("loop"), *body = b.block("loop.body"), *step = b.block("loop.step"),
             *end = b.block("loop.end");
  branchTo(head);
  continueIn(head);
  if (stmt.condition) {
    at(stmt.condition->loc);
    branchIf(lowerCondition(stmt.condition), body, end);
  } else {
    branchTo(body);
  }
  continueIn(body);
  loops.push_back({end, step});
  lower(stmt.body);
  loops.pop_back();
  branchTo(step);
  continueIn(step);
  if (stmt.step) {
    at(stmt.step->loc);
    lower(stmt.step);
  }
  branchTo(head);
  continueIn(end);
}

void Lowering::lowerReturn(const ReturnStmt &stmt) {
  if (stmt.value) {
    Value *value = lower(stmt.value);
    at(stmt.loc);
    if (resultSlot) // a structure has been assigned to the function's result variable
      copy(resultType, resultSlot, value);
  }
  branchTo(returnBlock);
}

/// illuminance runs its body for each light that reaches the point, inside of the cone if there is
/// one:
///
///     for (i = 0; i < light_count(); ++i)
///       if (light_sample(i, P, L, Cl) & in_cone(L, axis, angle)) { light_shadow(i, P, Cl); body }
void Lowering::lowerIlluminance(const LightStmt &stmt) {
  if (!hasContext(stmt.loc))
    return;
  BasicBlock *skip = nullptr;
  if (stmt.category) {
    // The lights that a runtime gives belong to no category: "" and "-anything" fit them.
    if (auto *name = dyn_cast<StringExpr>(stmt.category)) {
      if (!name->value.empty() && !name->value.starts_with("-")) {
        diags
            .warning(name->loc, LightCategory,
                     "no light belongs to a category; the body never runs")
            .range(name->range);
        return;
      }
    } else {
      BasicBlock *run = b.block("anycategory");
      skip = b.block("category.end");
      branchIf(b.call(Op::eq_string, {lower(stmt.category), text("")}), run, skip);
      continueIn(run);
    }
  }
  Value *position = lowerLasting(stmt.position);
  Value *axis = lowerLasting(stmt.axis);
  Value *angle = lowerLasting(stmt.angle);
  at(stmt.loc);
  Value *count = b.call(Op::light_count, {b.context()});
  Value *direction = temporary({TypeKind::Vector, true}, "L");
  Value *light = temporary({TypeKind::Color, true}, "Cl");

  BasicBlock *before = builder().GetInsertBlock();
  BasicBlock *head = b.block("lights"), *sample = b.block("light.sample"),
             *body = b.block("light.body"), *step = b.block("light.next"),
             *end = b.block("lights.end");
  branchTo(head);
  continueIn(head);
  PHINode *index = builder().CreatePHI(builder().getInt32Ty(), 2, "light");
  index->addIncoming(b.index(0), before);
  branchIf(builder().CreateICmpULT(index, count), sample, end);
  continueIn(sample);
  Value *reaches = b.call(Op::light_sample, {b.context(), index, position, direction, light});
  if (axis)
    reaches = builder().CreateAnd(reaches, b.call(Op::in_cone, {direction, axis, angle}));
  branchIf(reaches, body, step);

  continueIn(body);
  b.call(Op::light_shadow, {b.context(), index, position, light});
  std::map<unsigned, Value *> outerGlobals = lightGlobals;
  for (const stc::GlobalVariableInfo &global : stc::allGlobals()) {
    if (global.name == "L")
      lightGlobals[global.id] = direction;
    if (global.name == "Cl")
      lightGlobals[global.id] = light;
  }
  Value *outerIndex = std::exchange(lightIndex, index);
  loops.push_back({end, step});
  lower(stmt.body);
  loops.pop_back();
  lightIndex = outerIndex;
  lightGlobals = std::move(outerGlobals);
  at(stmt.loc);
  branchTo(step);
  continueIn(step);
  index->addIncoming(builder().CreateAdd(index, b.index(1)), step);
  branchTo(head);
  continueIn(end);
  if (skip) {
    branchTo(skip);
    continueIn(skip);
  }
}

/// illuminate and solar set L and run their body where the light goes; elsewhere there is none.
void Lowering::lowerIlluminate(const LightStmt &stmt) {
  auto globalNumber = [](StringRef name) {
    for (const stc::GlobalVariableInfo &global : stc::allGlobals())
      if (global.name == name)
        return global.id;
    llvm_unreachable("Globals.def lacks a light's variable");
  };
  Type vector{TypeKind::Vector, true}, color{TypeKind::Color, true};
  unsigned direction = globalNumber("L"), light = globalNumber("Cl");
  writtenGlobals.insert(direction);
  writtenGlobals.insert(light);
  Value *axis = lowerLasting(stmt.axis);
  Value *angle = lowerLasting(stmt.angle);
  Value *to = temporary(vector);
  if (stmt.kind == StmtKind::Illuminate)
    b.call(Op::sub_vector, {to, globalSlot(globalNumber("Ps")), lower(stmt.position)});
  else if (axis)
    copy(vector, to, axis);
  else
    b.call(Op::neg_vector, {to, globalSlot(globalNumber("Ns"))});
  at(stmt.loc);
  copy(vector, globalSlot(direction), to);
  if (stmt.kind == StmtKind::Solar || !axis) {
    lower(stmt.body);
    return;
  }
  BasicBlock *inside = b.block("lit"), *outside = b.block("unlit"), *join = b.block("lit.end");
  branchIf(b.call(Op::in_cone, {to, axis, angle}), inside, outside);
  continueIn(inside);
  lower(stmt.body);
  branchTo(join);
  continueIn(outside);
  setZero(color, globalSlot(light));
  branchTo(join);
  continueIn(join);
}

} // namespace anysl::rsl
