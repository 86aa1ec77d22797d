//===-- lib/Link/LoopLimit.cpp - loops that end
//--------------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// With a limit, every loop of a shader counts its rounds and is left when there are too many, by
// the way by which it is left otherwise; the host is told (<anysl/notes.h>). Without one this stage
// does nothing.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/NoteWriter.h"
#include "llvm/Analysis/LoopInfo.h"
#include "llvm/IR/Dominators.h"
#include "llvm/IR/Instructions.h"
#include "llvm/Transforms/Utils/BasicBlockUtils.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// What there is to be changed of a loop.
struct LimitedLoop {
  BasicBlock *header;
  SmallVector<BasicBlock *> inside; ///< from where it is entered again
  /// Branches out of it, and whether the loop goes on where the condition holds.
  SmallVector<std::pair<BranchInst *, bool>> exits;
};

/// The place of a loop: that of its first instruction which has one.
FilePosition positionOf(const BasicBlock &header) {
  for (const Instruction &instruction : header)
    if (FilePosition position = stc::positionOf(instruction); position && position.line)
      return position;
  return {};
}

std::vector<LimitedLoop> loopsOf(Function &function) {
  DominatorTree dominators(function);
  LoopInfo loops(dominators);
  std::vector<LimitedLoop> result;
  for (Loop *loop : loops.getLoopsInPreorder()) {
    LimitedLoop &limited = result.emplace_back();
    limited.header = loop->getHeader();
    for (BasicBlock *predecessor : predecessors(limited.header))
      if (loop->contains(predecessor))
        limited.inside.push_back(predecessor);
    SmallVector<BasicBlock *> exiting;
    loop->getExitingBlocks(exiting);
    for (BasicBlock *block : exiting)
      if (auto *branch = dyn_cast<BranchInst>(block->getTerminator()))
        limited.exits.push_back({branch, loop->contains(branch->getSuccessor(0))});
  }
  return result;
}

void limit(const LimitedLoop &loop, unsigned rounds, NoteWriter &writer) {
  IRBuilder<> builder(&loop.header->front());
  PHINode *count = builder.CreatePHI(builder.getInt32Ty(), 2, "rounds");
  builder.SetInsertPoint(&*loop.header->getFirstInsertionPt());
  Value *next = builder.CreateAdd(count, builder.getInt32(1));
  for (BasicBlock *predecessor : predecessors(loop.header))
    count->addIncoming(is_contained(loop.inside, predecessor) ? next : builder.getInt32(0),
                       predecessor);
  Value *isTooLong = builder.CreateICmpUGT(next, builder.getInt32(rounds));
  FilePosition position = positionOf(*loop.header);
  for (auto [branch, goesOnIfTrue] : loop.exits) {
    builder.SetInsertPoint(branch);
    builder.SetCurrentDebugLocation(branch->getDebugLoc());
    Value *condition = branch->getCondition();
    Value *goesOn = goesOnIfTrue ? condition : builder.CreateNot(condition);
    Value *isStopped = builder.CreateAnd(goesOn, isTooLong);
    branch->setCondition(goesOnIfTrue ? builder.CreateAnd(condition, builder.CreateNot(isTooLong))
                                      : builder.CreateOr(condition, isTooLong));
    Instruction *then = SplitBlockAndInsertIfThen(isStopped, branch->getIterator(),
                                                  /*Unreachable=*/false);
    builder.SetInsertPoint(then);
    writer.write(builder, position, ANYSL_NOTE_LOOP_LIMIT, "loop",
                 {ConstantFP::get(builder.getDoubleTy(), rounds)}, {});
  }
}

} // namespace

bool limitLoops(Session &session) {
  if (!session.options.maxLoop)
    return true;
  for (Shader &shader : session.shaders)
    forEachWithContext(shader, [&](Function &function, Value *context) {
      NoteWriter writer(session, shader, context);
      for (const LimitedLoop &loop : loopsOf(function))
        limit(loop, session.options.maxLoop, writer);
    });
  return true;
}

} // namespace anysl::link
