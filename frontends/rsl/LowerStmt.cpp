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
      setLength(slot, count, decl.name, decl.range.Start);
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

} // namespace anysl::rsl
