//===-- lib/STC/Metadata.cpp - reads back what a module says about its shaders ------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/MetadataNames.h"
#include "lib/STC/Verifier.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/IR/Constants.h"

using namespace llvm;

namespace anysl::stc {
namespace {

/// Reads the operands of one metadata node in order. The first operand that is missing or of
/// another kind than expected spoils the whole; `ok` is asked once at the end.
class NodeReader {
public:
  explicit NodeReader(const Metadata *metadata, unsigned operands)
      : node(dyn_cast_or_null<MDNode>(metadata)) {
    good = node && node->getNumOperands() == operands;
  }

  StringRef text() {
    auto *value = dyn_cast_or_null<MDString>(next());
    good &= value != nullptr;
    return value ? value->getString() : StringRef();
  }
  unsigned integer(unsigned bits = 32) {
    auto *value = mdconst::dyn_extract_or_null<ConstantInt>(next());
    good &= value && value->getType()->isIntegerTy(bits);
    return good ? unsigned(value->getZExtValue()) : 0;
  }
  bool flag() { return integer(1); }
  Function *function() {
    auto *value = mdconst::dyn_extract_or_null<Function>(next());
    good &= value != nullptr;
    return value;
  }
  ArrayRef<MDOperand> list() {
    auto *value = dyn_cast_or_null<MDNode>(next());
    good &= value != nullptr;
    return value ? value->operands() : ArrayRef<MDOperand>();
  }
  bool ok() const { return good; }

private:
  const Metadata *next() {
    return good && position < node->getNumOperands() ? node->getOperand(position++).get() : nullptr;
  }

  const MDNode *node;
  unsigned position = 0;
  bool good;
};

Error malformed(const Twine &what) { return createStringError("malformed STC metadata: " + what); }

Error readParam(const Metadata *metadata, ShaderInfo &shader) {
  NodeReader node(metadata, 6);
  ParamInfo param;
  param.name = node.text().str();
  auto type = typeNamed(node.text());
  StringRef storage = node.text();
  param.output = node.flag();
  param.arrayLength = node.integer();
  param.firstCell = node.integer();
  if (!node.ok() || !type || (storage != "uniform" && storage != "varying"))
    return malformed("a parameter of shader '" + shader.name + "'");
  param.type = *type;
  param.storage = storage == "uniform" ? Storage::Uniform : Storage::Varying;
  if (param.arrayLength > maxArrayLength || param.firstCell > maxCells)
    return malformed("parameter '" + param.name + "' of shader '" + shader.name +
                     "' has an absurd size");
  for (const ParamInfo &other : shader.params) {
    if (other.name == param.name)
      return malformed("shader '" + shader.name + "' has two parameters '" + param.name + "'");
    if (param.firstCell < other.firstCell + other.cellCount() &&
        other.firstCell < param.firstCell + param.cellCount())
      return malformed("parameters '" + other.name + "' and '" + param.name + "' of shader '" +
                       shader.name + "' overlap");
  }
  shader.params.push_back(param);
  return Error::success();
}

Error readGlobal(const Metadata *metadata, ShaderInfo &shader) {
  NodeReader node(metadata, 3);
  GlobalInfo global;
  global.id = node.integer();
  global.read = node.flag();
  global.written = node.flag();
  if (!node.ok() || !globalNumbered(global.id))
    return malformed("a shader global of shader '" + shader.name + "'");
  shader.globals.push_back(global);
  return Error::success();
}

bool isShaderFunction(const Function *function) {
  return function && !function->isDeclaration() && !function->isVarArg() &&
         function->getReturnType()->isVoidTy() && function->arg_size() == 1 &&
         function->getArg(0)->getType() == PointerType::getUnqual(function->getContext()) &&
         !function->hasMetadata(metadata::signature) && !opOfSymbol(function->getName());
}

Expected<ShaderInfo> readShader(const Metadata *metadata) {
  NodeReader node(metadata, 6);
  ShaderInfo shader;
  shader.name = node.text().str();
  auto kind = shaderKindNamed(node.text());
  shader.body = node.function();
  shader.init = node.function();
  ArrayRef<MDOperand> params = node.list();
  ArrayRef<MDOperand> globals = node.list();
  if (!node.ok() || !kind || shader.name.empty() || StringRef(shader.name).contains('\0'))
    return malformed("a node of 'anysl.shaders'");
  if (!isShaderFunction(shader.body) || !isShaderFunction(shader.init) ||
      shader.body == shader.init)
    return malformed("shader '" + shader.name + "' needs two functions 'void (ptr ctx)'");
  shader.kind = *kind;
  for (const MDOperand &param : params)
    if (Error error = readParam(param.get(), shader))
      return error;
  for (const MDOperand &global : globals)
    if (Error error = readGlobal(global.get(), shader))
      return error;
  return shader;
}

} // namespace

std::string readProducer(const Module &module) {
  NamedMDNode *named = module.getNamedMetadata(metadata::stc);
  if (!named || named->getNumOperands() != 1)
    return "";
  NodeReader node(named->getOperand(0), 2);
  node.integer();
  return node.text().str();
}

Expected<std::vector<ShaderInfo>> readShaders(const Module &module) {
  NamedMDNode *named = module.getNamedMetadata(metadata::stc);
  if (!named || named->getNumOperands() != 1)
    return createStringError("not subroutine-threaded code: the metadata '" + metadata::stc +
                             "' is missing");
  NodeReader node(named->getOperand(0), 2);
  unsigned version = node.integer();
  node.text();
  if (!node.ok())
    return malformed("'anysl.stc' is not a version and a producer");
  if (version != stcVersion)
    return createStringError("subroutine-threaded code of version " + Twine(version) +
                             "; this program reads version " + Twine(stcVersion));

  std::vector<ShaderInfo> shaders;
  StringSet<> names;
  SmallPtrSet<Function *, 8> functions;
  if (NamedMDNode *nodes = module.getNamedMetadata(metadata::shaders))
    for (const MDNode *operand : nodes->operands()) {
      auto shader = readShader(operand);
      if (!shader)
        return shader.takeError();
      // The shaders of a class have one name and different kinds.
      if (!names.insert((nameOf(shader->kind) + ":" + shader->name).str()).second)
        return malformed("two " + nameOf(shader->kind) + " shaders '" + shader->name + "'");
      if (!functions.insert(shader->body).second || !functions.insert(shader->init).second)
        return malformed("shader '" + shader->name + "' shares a function with another");
      shaders.push_back(std::move(*shader));
    }
  return shaders;
}

} // namespace anysl::stc
