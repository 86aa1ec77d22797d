//===-- lib/Link/OperatorWriter.cpp - writes operators into threaded code -----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/OperatorWriter.h"
#include "lib/Link/SlotConstants.h"
#include "lib/STC/MetadataNames.h"

using namespace llvm;

namespace anysl::link {

void OperatorWriter::construct(Value *slot, stc::Type type, ArrayRef<double> numbers,
                               StringRef text) {
  auto number = [&](double value) { return ConstantFP::get(builder.getDoubleTy(), value); };
  switch (type) {
  case stc::Type::floatTy:
    call(stc::Op::const_float, {slot, number(numbers[0])});
    return;
  case stc::Type::stringTy: {
    // Goes into the module as the shader's own text would.
    auto *data = ConstantDataArray::getString(module.getContext(), text);
    auto *global = new GlobalVariable(module, data->getType(), true, GlobalValue::PrivateLinkage,
                                      data, "param");
    call(stc::Op::const_string, {slot, global});
    return;
  }
  default:
    break;
  }
  SmallVector<Value *> operands{slot};
  for (double component : numbers) {
    operands.push_back(alloc(stc::Type::floatTy));
    call(stc::Op::const_float, {operands.back(), number(component)});
  }
  call(type == stc::Type::colorTy    ? stc::Op::make_color
       : type == stc::Type::matrixTy ? stc::Op::make_matrix
                                     : stc::Op::make_vector,
       operands);
}

Value *OperatorWriter::alloc(stc::Type type) {
  IRBuilderBase::InsertPointGuard guard(builder);
  DebugLoc location = builder.getCurrentDebugLocation();
  BasicBlock &entry = builder.GetInsertBlock()->getParent()->getEntryBlock();
  builder.SetInsertPoint(&entry, entry.begin());
  builder.SetCurrentDebugLocation(location);
  std::string symbol = (Twine(stc::typeSymbolPrefix) + info(type).name).str();
  return call(stc::Op::alloc, {module.getOrInsertGlobal(symbol, builder.getInt8Ty())});
}

CallInst *OperatorWriter::call(stc::Op op, ArrayRef<Value *> operands) {
  const stc::OpInfo &operation = info(op);
  CallInst *made = builder.CreateCall(
      module.getOrInsertFunction(operation.symbol(), functionType(module.getContext(), operation)),
      operands);
  if (!cause.empty())
    made->setMetadata(causeMetadata,
                      MDNode::get(module.getContext(), MDString::get(module.getContext(), cause)));
  return made;
}

} // namespace anysl::link
