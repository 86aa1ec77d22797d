//===-- tools/anysl-info/DescribeStc.cpp - reads an STC file ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Asking.h"
#include "tools/anysl-info/Description.h"
#include "llvm/ADT/SmallPtrSet.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/LLVMContext.h"
#include <set>

using namespace llvm;

namespace anysl::info {
namespace {

/// What a shader asks for, by following its calls. Operators that the shading library defines may
/// ask for more once linked.
class Needs {
public:
  explicit Needs(const Function *body) { visit(body); }

  std::vector<std::string> services() const {
    std::vector<std::string> names;
    for (stc::Service service : foundServices)
      if (service != stc::Service::NoService)
        names.push_back(stc::nameOf(service).str());
    return names;
  }
  std::vector<std::string> effects() const {
    std::vector<std::string> names;
    for (stc::Effect effect : foundEffects)
      names.push_back(stc::nameOf(effect).str());
    return names;
  }

private:
  void visit(const Function *function) {
    if (!function || !visited.insert(function).second)
      return;
    if (const stc::OpInfo *op = stc::opOfSymbol(function->getName())) {
      foundServices.insert(op->service);
      foundEffects.insert(op->effect);
    }
    for (const Instruction &instruction : instructions(*function))
      if (const auto *call = dyn_cast<CallInst>(&instruction))
        visit(call->getCalledFunction());
  }

  SmallPtrSet<const Function *, 32> visited;
  std::set<stc::Service> foundServices;
  std::set<stc::Effect> foundEffects;
};

Shader describeShader(const stc::ShaderInfo &info) {
  Shader shader;
  shader.name = info.name;
  shader.kind = stc::nameOf(info.kind).str();
  for (const stc::GlobalInfo &global : info.globals) {
    std::string name = stc::globalNumbered(global.id)->name.str();
    if (global.read)
      shader.globalsRead.push_back(name);
    if (global.written)
      shader.globalsWritten.push_back(name);
  }
  for (const stc::ParamInfo &found : info.params) {
    Param param;
    param.name = found.name;
    param.type = stc::info(found.type).name.str();
    param.components = stc::info(found.type).components;
    param.arrayLength = found.arrayLength;
    param.varying = found.storage == stc::Storage::Varying;
    param.output = found.output;
    shader.params.push_back(std::move(param));
  }
  Needs needs(info.body);
  shader.services = needs.services();
  shader.effects = needs.effects();
  return shader;
}

} // namespace

std::optional<Description> describeStc(DiagnosticEngine &diags, const std::string &path) {
  LLVMContext context;
  std::optional<stc::StcModule> file = stc::readFile(diags, context, path);
  if (!file)
    return std::nullopt;
  Description description = {path, file->producer, std::nullopt, Asking(), {}};
  if (auto names = stc::askedNames(*file->module))
    description.asking->names.emplace(names->begin(), names->end());
  description.asking->tracesForOthers = stc::tracesForOthers(*file);
  for (const stc::ShaderInfo &shader : file->shaders)
    description.shaders.push_back(describeShader(shader));
  return description;
}

} // namespace anysl::info
