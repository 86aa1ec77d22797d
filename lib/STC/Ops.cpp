//===-- lib/STC/Ops.cpp - the operators of subroutine-threaded code -----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Ops.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/SmallVectorExtras.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/Twine.h"
#include "llvm/IR/DerivedTypes.h"
#include "llvm/Support/ErrorHandling.h"

using namespace llvm;

namespace anysl::stc {
namespace {

/// The table's parameter lists. The names are the table's own, hence a scope of their own.
namespace table {
#define In(T)                                                                                      \
  OpParam { ParamKind::In, stc::Type::T##Ty }
#define Out(T)                                                                                     \
  OpParam { ParamKind::Out, stc::Type::T##Ty }
#define InOut(T)                                                                                   \
  OpParam { ParamKind::InOut, stc::Type::T##Ty }
#define Array(T)                                                                                   \
  OpParam { ParamKind::Array, stc::Type::T##Ty }
constexpr OpParam Ctx{ParamKind::Ctx}, Type{ParamKind::Type}, Slot{ParamKind::Slot},
    Bool{ParamKind::Bool}, Index{ParamKind::Index}, Length{ParamKind::Length}, Id{ParamKind::Id},
    Number{ParamKind::Number}, Text{ParamKind::Text};

#define ANYSL_LIST(...) {__VA_ARGS__}
#define STC_OP(id, name, result, params, purity, rule, effect, service, doc)                       \
  constexpr OpParam name##Params[] = ANYSL_LIST params;
#include "lib/STC/StcOps.def"
#undef ANYSL_LIST
#undef In
#undef Out
#undef InOut
#undef Array
} // namespace table

const OpInfo ops[] = {
#define STC_OP(id, name, result, params, purity, rule, effect, service, doc)                       \
  {Op::name,                                                                                       \
   #name,                                                                                          \
   ResultKind::result,                                                                             \
   table::name##Params,                                                                            \
   Purity::purity,                                                                                 \
   Rule::rule,                                                                                     \
   Effect::effect,                                                                                 \
   Service::service,                                                                               \
   doc},
#include "lib/STC/StcOps.def"
};

const StringMap<const OpInfo *> &opsByName() {
  static const StringMap<const OpInfo *> map = [] {
    StringMap<const OpInfo *> result;
    for (const OpInfo &op : ops)
      result[op.name] = &op;
    return result;
  }();
  return map;
}

} // namespace

bool OpInfo::takesContext() const {
  return any_of(params, [](const OpParam &param) { return param.kind == ParamKind::Ctx; });
}

ArrayRef<OpInfo> allOps() { return ops; }

const OpInfo &info(Op op) {
  auto found = partition_point(ops, [&](const OpInfo &entry) { return entry.op < op; });
  assert(found != std::end(ops) && found->op == op && "no such operator");
  return *found;
}

std::optional<IdKind> idKind(const OpInfo &op) {
  if (none_of(op.params, [](const OpParam &param) { return param.kind == ParamKind::Id; }))
    return std::nullopt;
  if (op.name.starts_with("query_"))
    return IdKind::Query;
  if (op.name.contains("_global_"))
    return IdKind::Global;
  if (op.name.starts_with("load_param_") || op.name.starts_with("store_param_"))
    return IdKind::Cell;
  return IdKind::Param;
}

ArrayRef<QueryKind> allQueryKinds() {
  static constexpr bool uniform = false, varying = true;
  static constexpr QueryKind kinds[] = {
#define ANYSL_QUERY(id, name, storage, doc) {id, #name, storage, doc},
#include <anysl/QueryKinds.def>
  };
  return kinds;
}

const QueryKind *queryKindNamed(StringRef name) {
  auto found = find_if(allQueryKinds(), [&](const QueryKind &kind) { return kind.name == name; });
  return found == allQueryKinds().end() ? nullptr : found;
}

const OpInfo *opNamed(StringRef name) { return opsByName().lookup(name); }

const OpInfo *opOfSymbol(StringRef symbol) {
  return symbol.consume_front(opPrefix) ? opNamed(symbol) : nullptr;
}

FunctionType *functionType(LLVMContext &context, ResultKind result, ArrayRef<OpParam> params) {
  auto *pointer = PointerType::getUnqual(context);
  auto lower = [&](const OpParam &param) -> llvm::Type * {
    switch (param.kind) {
    case ParamKind::Bool:
      return llvm::Type::getInt1Ty(context);
    case ParamKind::Index:
    case ParamKind::Length:
    case ParamKind::Id:
      return llvm::Type::getInt32Ty(context);
    case ParamKind::Number:
      return llvm::Type::getDoubleTy(context);
    default:
      return pointer;
    }
  };
  llvm::Type *type = nullptr;
  switch (result) {
  case ResultKind::None:
    type = llvm::Type::getVoidTy(context);
    break;
  case ResultKind::Test:
    type = llvm::Type::getInt1Ty(context);
    break;
  case ResultKind::Index:
    type = llvm::Type::getInt32Ty(context);
    break;
  case ResultKind::Slot:
    type = pointer;
    break;
  }
  return FunctionType::get(type, map_to_vector(params, lower), false);
}

FunctionType *functionType(LLVMContext &context, const OpInfo &op) {
  return functionType(context, op.result, op.params);
}

StringRef nameOf(ResultKind kind) {
  static constexpr StringLiteral names[] = {"None", "Test", "Index", "Slot"};
  return names[unsigned(kind)];
}

StringRef nameOf(ParamKind kind) {
  static constexpr StringLiteral names[] = {"In",   "Out",   "InOut",  "Array", "Ctx", "Type",   "Slot",
                                            "Bool", "Index", "Length", "Id",  "Number", "Text"};
  return names[unsigned(kind)];
}

StringRef nameOf(Purity purity) {
  static constexpr StringLiteral names[] = {"Structural", "Pure", "Reads", "Writes", "Stateful"};
  return names[unsigned(purity)];
}

StringRef nameOf(Rule rule) {
  static constexpr StringLiteral names[] = {"Propagate", "Uniform", "Varying"};
  return names[unsigned(rule)];
}

StringRef nameOf(Effect effect) {
  switch (effect) {
#define STC_EFFECT(id, name, doc)                                                                  \
  case Effect::name:                                                                               \
    return #name;
#include "lib/STC/Effects.def"
  }
  llvm_unreachable("no such effect");
}

StringRef docOf(Effect effect) {
  switch (effect) {
#define STC_EFFECT(id, name, doc)                                                                  \
  case Effect::name:                                                                               \
    return doc;
#include "lib/STC/Effects.def"
  }
  llvm_unreachable("no such effect");
}

StringRef nameOf(Service service) {
  switch (service) {
#define STC_SERVICE(id, name, doc)                                                                 \
  case Service::name:                                                                              \
    return #name;
#include "lib/STC/Services.def"
  }
  llvm_unreachable("no such service");
}

StringRef docOf(Service service) {
  switch (service) {
#define STC_SERVICE(id, name, doc)                                                                 \
  case Service::name:                                                                              \
    return doc;
#include "lib/STC/Services.def"
  }
  llvm_unreachable("no such service");
}

std::string toString(const OpParam &param) {
  if (!param.isValue())
    return nameOf(param.kind).str();
  std::string length = param.arrayLength ? "[" + std::to_string(param.arrayLength) + "]" : "";
  return (Twine(nameOf(param.kind)) + "(" + info(param.type).name + length + ")").str();
}

} // namespace anysl::stc
