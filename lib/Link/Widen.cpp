//===-- lib/Link/Widen.cpp - asks for wide forms of the shaders ---------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Widening itself is passes/Vectorize. Here each shader asks for two forms a width: for groups in
// which every point counts, and for the last group, in which only some do.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "lib/Link/WideForms.h"
#include "lib/Support/Tool.h"
#include "passes/Vectorize/Vectorize.h"
#include "llvm/Demangle/Demangle.h"
#include "llvm/IR/DebugInfoMetadata.h"
#include "llvm/IR/GlobalVariable.h"
#include "llvm/IR/Module.h"

using namespace llvm;

namespace anysl::link {
namespace {

std::string formName(const Shader &shader, unsigned width, bool masked) {
  return shader.symbol + (masked ? ".masked" : ".all") + std::to_string(width);
}

/// `_ZGV_LLVM_N8ul_glass.point(glass.all8)`: the batch is the same for all lanes, the point's
/// number grows by one from lane to lane.
std::string mangledName(const Shader &shader, unsigned width, bool masked) {
  return std::string("_ZGV_LLVM_") + (masked ? "M" : "N") + std::to_string(width) + "ul_" +
         shader.point->getName().str() + "(" + formName(shader, width, masked) + ")";
}

StringRef nameOf(VectorizeRemark::Kind kind) {
  switch (kind) {
  case VectorizeRemark::Kind::Widened:
    return "widened";
  case VectorizeRemark::Kind::Refused:
    return "refused";
  case VectorizeRemark::Kind::LaneByLane:
    return "lane by lane";
  case VectorizeRemark::Kind::Gather:
    return "gather";
  case VectorizeRemark::Kind::DivergentLoop:
    return "divergent loop";
  }
  llvm_unreachable("no such kind of remark");
}

/// Notes a remark with every shader that it concerns: the one widened, or those that call a
/// function which the runtime keeps apart and which had to be widened with them.
void noteRemark(Session &session, unsigned width, const VectorizeRemark &remark) {
  if (remark.kind == VectorizeRemark::Kind::Widened)
    return;
  for (Shader &shader : session.shaders) {
    if (none_of(reachableFrom(shader.point),
                [&](Function *function) { return function->getName() == remark.function; }))
      continue;
    bool isShader = remark.function == shader.point->getName();
    WideningRemark noted{width,
                         isShader ? shader.info.name : demangle(remark.function),
                         nameOf(remark.kind).str(),
                         remark.message,
                         {}};
    if (DILocation *location = remark.location.get())
      noted.position = {location->getFilename().str(), location->getLine(), location->getColumn()};
    // The two forms of a width say the same.
    auto same = [&](const WideningRemark &other) {
      return other.width == noted.width && other.function == noted.function &&
             other.message == noted.message && other.position.file == noted.position.file &&
             other.position.line == noted.position.line &&
             other.position.column == noted.position.column;
    };
    if (none_of(shader.report.remarks, same))
      shader.report.remarks.push_back(noted);
  }
}

} // namespace

Function *wideForm(const Shader &shader, unsigned width, bool masked) {
  return shader.point->getParent()->getFunction(formName(shader, width, masked));
}

bool widen(Session &session) {
  Module &module = *session.module;
  for (unsigned width : session.widths) {
    if (width == 1)
      continue;
    SmallVector<Shader *> shaders;
    for (Shader &shader : session.shaders)
      if (is_contained(widthsOf(session, shader), width))
        shaders.push_back(&shader);
    for (Shader *shader : shaders)
      for (bool masked : {false, true})
        addVectorVariant(*shader->point, mangledName(*shader, width, masked));
    VectorizeOptions options;
    options.width = width;
    std::string refusal;
    options.onRemark = [&](const VectorizeRemark &remark) {
      noteRemark(session, width, remark);
      if (remark.kind == VectorizeRemark::Kind::Refused)
        refusal = remark.message;
    };
    defineVectorVariants(module, options, &session.target);
    for (Shader *shader : shaders)
      for (bool masked : {false, true}) {
        Function *form = wideForm(*shader, width, masked);
        if (!form || form->isDeclaration())
          reportInternalError("shader '" + shader->info.name + "' cannot be widened to " +
                              Twine(width) + (refusal.empty() ? "" : ": " + refusal));
        form->setLinkage(GlobalValue::InternalLinkage);
      }
  }

  // Variants' names have done their work, and what nobody calls by now nobody will.
  for (Function &function : module)
    removeVectorVariants(function);
  if (GlobalVariable *used = module.getNamedGlobal("llvm.compiler.used"))
    used->eraseFromParent();
  return true;
}

} // namespace anysl::link
