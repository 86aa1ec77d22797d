//===-- frontends/rsl/SemaStmt.cpp - statements -----------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

using namespace llvm;

namespace anysl::rsl {

bool alwaysReturns(const Stmt *stmt) {
  if (!stmt)
    return false;
  if (stmt->kind == StmtKind::Return)
    return true;
  if (auto *block = dyn_cast<BlockStmt>(stmt))
    return llvm::any_of(block->body, alwaysReturns);
  if (auto *branch = dyn_cast<IfStmt>(stmt))
    return alwaysReturns(branch->thenBody) && alwaysReturns(branch->elseBody);
  return false;
}

void Sema::checkBlock(BlockStmt &block) {
  pushScope();
  for (Stmt *stmt : block.body)
    checkStmt(stmt);
  popScope();
}

void Sema::checkStmt(Stmt *stmt) {
  if (!stmt)
    return;
  switch (stmt->kind) {
  case StmtKind::Empty:
    break;
  case StmtKind::Block:
    checkBlock(*cast<BlockStmt>(stmt));
    break;
  case StmtKind::Declaration:
    for (VarDecl *decl : cast<DeclarationStmt>(stmt)->variables)
      checkVariable(*decl);
    break;
  case StmtKind::Extern:
    checkExtern(*cast<ExternStmt>(stmt));
    break;
  case StmtKind::Expression: {
    auto *statement = cast<ExpressionStmt>(stmt);
    statement->expr = check(statement->expr);
    if (!statement->expr->hasEffects && !isa<CallExpr>(statement->expr) &&
        !statement->expr->type.isError())
      diags
          .warning(statement->expr->loc, warn::UnusedValue,
                   "the value of this expression is not used")
          .range(statement->expr->range);
    break;
  }
  case StmtKind::If: {
    auto *branch = cast<IfStmt>(stmt);
    branch->condition = checkCondition(branch->condition);
    enterBranch(branch->condition);
    checkStmt(branch->thenBody);
    checkStmt(branch->elseBody);
    leaveBranch(branch->condition);
    break;
  }
  case StmtKind::While:
  case StmtKind::For:
    checkLoop(*cast<LoopStmt>(stmt));
    break;
  case StmtKind::Break:
  case StmtKind::Continue:
    checkJump(*cast<JumpStmt>(stmt));
    break;
  case StmtKind::Return:
    checkReturn(*cast<ReturnStmt>(stmt));
    break;
  case StmtKind::Illuminance:
  case StmtKind::Illuminate:
  case StmtKind::Solar:
    checkLight(*cast<LightStmt>(stmt));
    break;
  case StmtKind::Struct:
    checkStruct(*cast<StructStmt>(stmt)->structure);
    break;
  case StmtKind::Gather:
    checkGather(*cast<GatherStmt>(stmt));
    break;
  case StmtKind::Function:
    checkFunction(*cast<FunctionStmt>(stmt)->function);
    break;
  }
}

void Sema::checkLoop(LoopStmt &loop) {
  pushScope(); // of a variable declared in the head
  checkStmt(loop.init);
  if (loop.condition)
    loop.condition = checkCondition(loop.condition);
  enterBranch(loop.condition);
  if (loop.step)
    loop.step = check(loop.step);
  ++loops;
  checkStmt(loop.body);
  --loops;
  leaveBranch(loop.condition);
  popScope();
}

/// What follows runs where the condition, which may be null, holds.
void Sema::enterBranch(const Expr *condition) {
  if (condition && condition->type.varying)
    varyingConditions.push_back(condition);
}

void Sema::leaveBranch(const Expr *condition) {
  if (condition && condition->type.varying)
    varyingConditions.pop_back();
}

void Sema::checkJump(JumpStmt &jump) {
  StringRef word = jump.kind == StmtKind::Break ? "break" : "continue";
  if (jump.count) {
    jump.count = check(jump.count, TypeKind::Float);
    std::optional<double> levels = constant(jump.count);
    if (!levels || *levels < 1 || *levels > 1000 || *levels != static_cast<unsigned>(*levels)) {
      if (!jump.count->type.isError())
        diags.error(jump.count->loc, "'" + word + "' takes a constant positive number of loops")
            .range(jump.count->range);
      return;
    }
    jump.levels = static_cast<unsigned>(*levels);
  }
  if (!loops)
    diags.error(jump.loc, "'" + word + "' outside of a loop");
  else if (jump.levels > loops)
    diags.error(jump.loc, "'" + word + " " + Twine(jump.levels) + "' inside of only " +
                              Twine(loops) + (loops == 1 ? " loop" : " loops"));
}

void Sema::checkReturn(ReturnStmt &stmt) {
  Type result = function ? function->result : Type{TypeKind::Void};
  if (!stmt.value) {
    if (result.kind != TypeKind::Void)
      diags
          .error(stmt.loc, "function '" + function->name + "' must return a value of type '" +
                               toString(result) + "'")
          .note(function->range.Start, "declared here", function->range);
    return;
  }
  if (result.kind == TypeKind::Void) {
    auto error = diags.error(stmt.value->loc,
                             function ? ("function '" + function->name + "' returns no value").str()
                                      : std::string("a shader returns no value"));
    error.range(stmt.value->range);
    if (function)
      error.note(function->range.Start, "declared here", function->range);
    check(stmt.value);
    return;
  }
  if (result.structure) {
    stmt.value = checkWhole(stmt.value, result, "returning from '" + function->name + "'");
    if (!stmt.value->type.isError())
      stmt.value = assignStruct(reference(*function->resultVariable, stmt.value->range), stmt.value,
                                stmt.loc, stmt.value->range);
    return;
  }
  if (result.isArray()) {
    stmt.value = checkArrayReturn(stmt.value, stmt.loc);
    return;
  }
  stmt.value = checkAs(stmt.value, result, "returning from '" + function->name + "'");
  if (function->resultHasStorage && !function->result.varying)
    checkStorage(stmt.value, false, "returning from uniform function '" + function->name + "'");
}

} // namespace anysl::rsl
