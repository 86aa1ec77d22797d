//===-- lib/Link/Entries.cpp - makes the functions that a renderer calls ------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
//   void glass.w8(ptr args, i32 first, i32 last) {
//     for (i = first; last - i >= 8; i += 8)      // unsigned, and not at all if last <= first
//       glass.all8(args, i);                      // inlined: what is uniform moves out of the loop
//     if (i < last)
//       glass.masked8(args, i, lane < last - i);
//   }
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "lib/Link/WideForms.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/Module.h"
#include "llvm/Target/TargetMachine.h"

using namespace llvm;

namespace anysl::link {
namespace {

class EntryBuilder {
public:
  EntryBuilder(Session &session, Shader &shader, unsigned width)
      : shader(shader), width(width), builder(session.context) {
    Type *integer = builder.getInt32Ty();
    auto *type =
        FunctionType::get(builder.getVoidTy(), {builder.getPtrTy(), integer, integer}, false);
    function = Function::Create(type, GlobalValue::InternalLinkage,
                                shader.symbol + ".w" + std::to_string(width), *session.module);
    args = function->getArg(0);
    first = function->getArg(1);
    last = function->getArg(2);
    args->setName("args");
    first->setName("first");
    last->setName("last");
    function->copyAttributesFrom(shader.point);
    function->setAttributes(
        AttributeList::get(session.context, shader.point->getAttributes().getFnAttrs(),
                           AttributeSet(), {shader.point->getAttributes().getParamAttrs(0)}));
    function->setLinkage(GlobalValue::InternalLinkage);
  }

  Function *build() {
    BasicBlock *entry = block("entry"), *loop = block("loop"), *tail = block("tail"),
               *end = block("end");
    Constant *step = builder.getInt32(width);

    // A loop that runs at least once, which is what lets uniform loads move out of it.
    builder.SetInsertPoint(entry);
    Value *any = builder.CreateICmpULT(first, last);
    Value *full = builder.CreateICmpUGE(builder.CreateSub(last, first), step);
    builder.CreateCondBr(builder.CreateAnd(any, full), loop, tail);

    builder.SetInsertPoint(loop);
    PHINode *index = builder.CreatePHI(builder.getInt32Ty(), 2, "index");
    Function *form = width == 1 ? shader.point : wideForm(shader, width, /*masked=*/false);
    builder.CreateCall(form, {args, index})->addFnAttr(Attribute::AlwaysInline);
    Value *next = builder.CreateAdd(index, step, "next");
    Value *more = builder.CreateICmpUGE(builder.CreateSub(last, next), step);
    builder.CreateCondBr(more, loop, tail);
    index->addIncoming(first, entry);
    index->addIncoming(next, loop);

    builder.SetInsertPoint(tail);
    PHINode *rest = builder.CreatePHI(builder.getInt32Ty(), 2, "rest");
    rest->addIncoming(first, entry);
    rest->addIncoming(next, loop);
    if (width == 1) {
      builder.CreateBr(end);
    } else {
      BasicBlock *partial = block("partial");
      builder.CreateCondBr(builder.CreateICmpULT(rest, last), partial, end);
      builder.SetInsertPoint(partial);
      builder.CreateCall(wideForm(shader, width, /*masked=*/true), {args, rest, tailMask(rest)});
      builder.CreateBr(end);
    }
    builder.SetInsertPoint(end);
    builder.CreateRetVoid();
    return function;
  }

private:
  BasicBlock *block(StringRef name) {
    return BasicBlock::Create(builder.getContext(), name, function);
  }

  /// One bit a lane, set where the lane's point is before `last`.
  Value *tailMask(Value *rest) {
    SmallVector<Constant *> lanes;
    for (unsigned lane = 0; lane < width; ++lane)
      lanes.push_back(builder.getInt32(lane));
    Value *count = builder.CreateVectorSplat(width, builder.CreateSub(last, rest));
    return builder.CreateICmpULT(ConstantVector::get(lanes), count, "mask");
  }

  Shader &shader;
  unsigned width;
  IRBuilder<> builder;
  Function *function;
  Argument *args, *first, *last;
};

} // namespace

bool makeEntries(Session &session) {
  for (Shader &shader : session.shaders)
    for (unsigned width : widthsOf(session, shader)) {
      shader.entries.push_back({width, EntryBuilder(session, shader, width).build()});
      shader.report.widths.push_back(width);
    }
  return true;
}

} // namespace anysl::link
