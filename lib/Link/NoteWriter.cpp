//===-- lib/Link/NoteWriter.cpp - calls that tell a host of something
//-----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/NoteWriter.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SetVector.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"

using namespace llvm;

namespace anysl::link {

NoteWriter::NoteWriter(Session &session, const Shader &shader, Value *context)
    : session(session), shader(shader), context(context) {
  Type *number = Type::getInt32Ty(session.context), *pointer = PointerType::get(session.context, 0);
  type = StructType::get(
      session.context, {number, number, number, number, number, number, pointer, pointer, pointer});
}

void NoteWriter::write(IRBuilder<> &builder, const FilePosition &position, uint32_t kind,
                       StringRef name, ArrayRef<Value *> results, ArrayRef<Value *> operands) {
  results = results.take_front(ANYSL_NOTE_RESULTS);
  operands = operands.take_front(ANYSL_NOTE_OPERANDS);
  Constant *value = ConstantStruct::get(
      type,
      {builder.getInt32(kind), builder.getInt32(position.line), builder.getInt32(position.column),
       builder.getInt32(unsigned(results.size())), builder.getInt32(unsigned(operands.size())),
       builder.getInt32(0), text(shader.info.name), text(position.file), text(name)});
  auto *site = new GlobalVariable(*session.module, type, true, GlobalValue::PrivateLinkage, value,
                                  "anysl.site");
  SmallVector<Value *, 16> arguments = {context, site};
  auto append = [&](ArrayRef<Value *> numbers, unsigned count) {
    arguments.append(numbers.begin(), numbers.end());
    arguments.append(count - numbers.size(), ConstantFP::get(builder.getDoubleTy(), 0));
  };
  append(results, ANYSL_NOTE_RESULTS);
  append(operands, ANYSL_NOTE_OPERANDS);
  builder.CreateCall(session.module->getFunction(noteName), arguments);
}

Constant *NoteWriter::text(StringRef value) {
  GlobalVariable *&global = texts[value];
  if (!global) {
    auto *data = ConstantDataArray::getString(session.context, value);
    global = new GlobalVariable(*session.module, data->getType(), true, GlobalValue::PrivateLinkage,
                                data, "anysl.text");
  }
  return global;
}

/// A function's parameter that is the shading context; null if it has none.
static Value *contextOf(Function &function) {
  auto signature = stc::signatureOf(function);
  for (auto [i, param] : enumerate(signature.value_or(SmallVector<stc::OpParam>())))
    if (param.kind == stc::ParamKind::Ctx)
      return function.getArg(unsigned(i));
  return nullptr;
}

void forEachWithContext(const Shader &shader,
                        function_ref<void(Function &, Value *context)> visit) {
  SmallSetVector<Function *, 8> functions;
  functions.insert(shader.info.body);
  for (unsigned i = 0; i < functions.size(); ++i)
    for (Instruction &instruction : instructions(functions[i]))
      if (auto *call = dyn_cast<CallBase>(&instruction))
        if (Function *callee = call->getCalledFunction();
            callee && !callee->isDeclaration() && !stc::opOfSymbol(callee->getName()))
          functions.insert(callee);
  for (Function *function : functions)
    if (Value *context = function == shader.info.body ? function->getArg(0) : contextOf(*function))
      visit(*function, context);
}

} // namespace anysl::link
