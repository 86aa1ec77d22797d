//===-- lib/STC/Types.cpp - the abstract types of subroutine-threaded code ----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Types.h"
#include "lib/STC/Shader.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/GlobalVariable.h"
#include "llvm/IR/InstrTypes.h"

using namespace llvm;

namespace anysl::stc {
namespace {

const TypeInfo types[] = {
#define STC_TYPE(id, name, components, doc) {Type::name##Ty, #name, components, doc},
#include "lib/STC/Types.def"
};

bool isGeometric(Type type) {
  return type == Type::pointTy || type == Type::vectorTy || type == Type::normalTy;
}

} // namespace

ArrayRef<TypeInfo> allTypes() { return types; }

const TypeInfo &info(Type type) {
  const TypeInfo *found = find_if(types, [&](const TypeInfo &entry) { return entry.type == type; });
  assert(found != std::end(types) && "no such type");
  return *found;
}

std::optional<Type> typeNamed(StringRef name) {
  const TypeInfo *found = find_if(types, [&](const TypeInfo &entry) { return entry.name == name; });
  if (found == std::end(types))
    return std::nullopt;
  return found->type;
}

bool sameRepresentation(Type a, Type b) { return a == b || (isGeometric(a) && isGeometric(b)); }

std::optional<Type> typeOfSymbol(const Value *value) {
  auto *global = dyn_cast_or_null<GlobalVariable>(value);
  if (!global)
    return std::nullopt;
  StringRef name = global->getName();
  if (!name.consume_front(typeSymbolPrefix))
    return std::nullopt;
  return typeNamed(name);
}

StringRef nameOf(Storage storage) {
  return storage == Storage::Uniform ? StringRef("uniform") : StringRef("varying");
}

std::optional<SlotInfo> slotInfo(const Value *value) {
  if (auto *argument = dyn_cast<Argument>(value)) {
    auto signature = signatureOf(*argument->getParent());
    if (!signature || argument->getArgNo() >= signature->size())
      return std::nullopt;
    const OpParam &param = (*signature)[argument->getArgNo()];
    if (!param.isValue())
      return std::nullopt;
    return SlotInfo{param.type, param.arrayLength};
  }

  auto *call = dyn_cast<CallBase>(value);
  auto *callee = call ? dyn_cast<Function>(call->getCalledOperand()) : nullptr;
  const OpInfo *op = callee ? opOfSymbol(callee->getName()) : nullptr;
  if (!op || op->result != ResultKind::Slot || call->arg_size() != op->params.size())
    return std::nullopt;
  for (auto [param, operand] : zip(op->params, call->args())) {
    if (param.kind != ParamKind::Type)
      continue;
    auto type = typeOfSymbol(operand);
    if (!type)
      return std::nullopt;
    unsigned length = 0;
    if (op->op == Op::alloc_array) {
      auto *constant = dyn_cast<ConstantInt>(call->getArgOperand(1));
      if (!constant || constant->getValue().ugt(maxArrayLength))
        return std::nullopt;
      length = unsigned(constant->getZExtValue());
    }
    return SlotInfo{*type, length};
  }
  return std::nullopt;
}

} // namespace anysl::stc
