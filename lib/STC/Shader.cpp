//===-- lib/STC/Shader.cpp - what an STC file says about its shaders ----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Shader.h"
#include "lib/STC/MetadataNames.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/DebugInfoMetadata.h"
#include "llvm/IR/Function.h"
#include "llvm/IR/Instruction.h"
#include "llvm/IR/Metadata.h"

using namespace llvm;

namespace anysl::stc {
namespace {

constexpr StringLiteral kindNames[] = {"surface", "displacement", "light",
                                       "volume",  "imager",       "method"};

#define ANYSL_STORAGE_varying Storage::Varying
#define ANYSL_STORAGE_uniform Storage::Uniform
const GlobalVariableInfo globals[] = {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc)                                     \
  {id, #name, Type::type##Ty, components, ANYSL_STORAGE_##storage, doc, false},
#define ANYSL_HIDDEN_GLOBAL(id, name, type, components, storage, doc)                              \
  {id, #name, Type::type##Ty, components, ANYSL_STORAGE_##storage, doc, true},
#include <anysl/Globals.def>
};

namespace number {
enum : unsigned {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) name = id,
#include <anysl/Globals.def>
};
} // namespace number

/// Reads back what `toString(OpParam)` writes.
std::optional<OpParam> parseParam(StringRef text) {
  auto [kindName, rest] = text.split('(');
  static constexpr ParamKind kinds[] = {ParamKind::In,  ParamKind::Out,  ParamKind::InOut,
                                        ParamKind::Ctx, ParamKind::Bool, ParamKind::Index};
  const ParamKind *kind = find_if(kinds, [&](ParamKind k) { return nameOf(k) == kindName; });
  if (kind == std::end(kinds))
    return std::nullopt;
  OpParam param{*kind};
  if (!param.isValue())
    return kindName == text ? std::optional(param) : std::nullopt;

  if (!rest.consume_back(")"))
    return std::nullopt;
  auto [typeName, length] = rest.split('[');
  auto type = typeNamed(typeName);
  if (!type)
    return std::nullopt;
  param.type = *type;
  if (typeName != rest &&
      (!length.consume_back("]") || length.getAsInteger(10, param.arrayLength) ||
       param.arrayLength == 0 || param.arrayLength > maxArrayLength))
    return std::nullopt;
  return param;
}

} // namespace

StringRef nameOf(ShaderKind kind) { return kindNames[unsigned(kind) - 1]; }

std::optional<ShaderKind> shaderKindNamed(StringRef name) {
  const StringLiteral *found = find(kindNames, name);
  if (found == std::end(kindNames))
    return std::nullopt;
  return ShaderKind(found - kindNames + 1);
}

const ParamInfo *ShaderInfo::paramOfCell(unsigned cell) const {
  auto found = find_if(params, [&](const ParamInfo &param) {
    return cell >= param.firstCell && cell - param.firstCell < param.cellCount();
  });
  return found == params.end() ? nullptr : &*found;
}

unsigned ShaderInfo::cellCount() const {
  unsigned count = 0;
  for (const ParamInfo &param : params)
    count = std::max(count, param.firstCell + param.cellCount());
  return count;
}

ArrayRef<GlobalVariableInfo> allGlobals() { return globals; }

const GlobalVariableInfo *globalNumbered(unsigned id) {
  const GlobalVariableInfo *found =
      find_if(globals, [&](const GlobalVariableInfo &entry) { return entry.id == id; });
  return found == std::end(globals) ? nullptr : found;
}

ArrayRef<unsigned> derivativesOf(unsigned id) {
  switch (id) {
#define ANYSL_DERIVATIVE(name, byU, byV)                                                           \
  case number::name: {                                                                             \
    static constexpr unsigned ids[] = {number::byU, number::byV};                                  \
    return ids;                                                                                    \
  }
#include <anysl/Globals.def>
  default:
    return {};
  }
}

FilePosition positionOf(const Instruction &instruction) {
  const DILocation *location = instruction.getDebugLoc().get();
  if (!location)
    return {};
  return {location->getFilename().str(), location->getLine(), location->getColumn()};
}

FilePosition shaderPositionOf(const Instruction &instruction) {
  const DILocation *location = instruction.getDebugLoc().get();
  if (!location)
    return {};
  while (const DILocation *caller = location->getInlinedAt())
    location = caller;
  return {location->getFilename().str(), location->getLine(), location->getColumn()};
}

std::optional<SmallVector<OpParam>> signatureOf(const Function &function) {
  if (const OpInfo *op = opOfSymbol(function.getName()))
    return SmallVector<OpParam>(op->params);
  const MDNode *node = function.getMetadata(metadata::signature);
  if (!node) {
    if (function.arg_size() != 1)
      return std::nullopt;
    return SmallVector<OpParam>{OpParam{ParamKind::Ctx}};
  }
  SmallVector<OpParam> result;
  for (const MDOperand &operand : node->operands()) {
    auto *text = dyn_cast_or_null<MDString>(operand.get());
    auto param = text ? parseParam(text->getString()) : std::nullopt;
    if (!param)
      return std::nullopt;
    result.push_back(*param);
  }
  return result;
}

} // namespace anysl::stc
