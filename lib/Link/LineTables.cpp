//===-- lib/Link/LineTables.cpp - keeps sources' lines in native code ---------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What is left after linking are functions that the linker has made, into which shaders were
// inlined; LLVM writes line tables only for functions that the debug information knows. Each is
// entered there under its own name, at its shader's place, and all it holds counts as inlined into
// it. Debuggers and profilers then show the shader's lines, whichever width runs.
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Link/Session.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/IR/DIBuilder.h"
#include "llvm/IR/DebugInfoMetadata.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/Instructions.h"

using namespace llvm;

namespace anysl::link {
namespace {

/// Where the outermost code of a function comes from: the first location's subprogram, looking out
/// of everything inlined.
DISubprogram *sourceOf(const Function &function) {
  for (const Instruction &instruction : instructions(function))
    if (const DILocation *location = instruction.getDebugLoc()) {
      while (location->getInlinedAt())
        location = location->getInlinedAt();
      return location->getScope()->getSubprogram();
    }
  return nullptr;
}

void describe(Function &function, DISubprogram &source) {
  LLVMContext &context = function.getContext();
  DIBuilder builder(*function.getParent(), /*AllowUnresolved=*/true, source.getUnit());
  DISubprogram *subprogram = builder.createFunction(
      source.getFile(), function.getName(), function.getName(), source.getFile(), source.getLine(),
      source.getType(), source.getLine(), DINode::FlagArtificial,
      DISubprogram::SPFlagDefinition | DISubprogram::SPFlagOptimized |
          DISubprogram::SPFlagLocalToUnit);
  builder.finalizeSubprogram(subprogram);
  function.setSubprogram(subprogram);

  auto *place = DILocation::getDistinct(context, source.getLine(), 0, subprogram);
  DenseMap<const MDNode *, MDNode *> cache;
  for (Instruction &instruction : instructions(function))
    if (const DebugLoc &location = instruction.getDebugLoc())
      instruction.setDebugLoc(
          DILocation::get(context, location.getLine(), location.getCol(), location.getScope(),
                          DebugLoc::appendInlinedAt(location, place, context, cache)));
    else if (isa<CallBase>(instruction))
      instruction.setDebugLoc(DILocation::get(context, 0, 0, subprogram));
}

} // namespace

void keepLines(Module &module) {
  bool wanted = any_of(module.debug_compile_units(), [](const DICompileUnit *unit) {
    return unit->getEmissionKind() != DICompileUnit::NoDebug;
  });
  if (!wanted)
    return;
  for (Function &function : module)
    if (!function.isDeclaration() && !function.getSubprogram())
      if (DISubprogram *source = sourceOf(function))
        describe(function, *source);
}

} // namespace anysl::link
