//===-- frontends/rsl/SemaQuery.cpp - questions to the renderer -------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

#include <anysl/abi.h>

using namespace llvm;

namespace anysl::rsl {

/// Outside of illuminance there is no light to ask.
void Sema::checkIsInLight(const CallExpr &call) {
  if (!illuminances && !function)
    diags
        .warning(call.loc, warn::Unanswered,
                 "outside of 'illuminance' no light answers '" + call.name + "'")
        .range(call.nameRange);
}

/// attribute(name, variable) and its like; textureinfo(file, name, variable). A variable that is
/// declared uniform may be asked for: usage has it so, also for what differs from point to point.
Expr *Sema::checkQuery(CallExpr &call) {
  call.form = CallForm::Query;
  call.type = {TypeKind::Error};
  bool hasSubject = call.name == "textureinfo";
  size_t texts = hasSubject ? 2 : 1;
  if (call.args.size() != texts + 1) {
    diags
        .error(call.loc, "'" + call.name + "' takes " + (hasSubject ? "a file, a name" : "a name") +
                             " and a variable")
        .range(call.nameRange);
    for (Expr *&arg : call.args)
      arg = check(arg);
    return &call;
  }
  if (call.name == "lightsource") {
    call.args[0] = checkAs(call.args[0], {TypeKind::String}, "argument 1 of 'lightsource'");
    call.args[1] = check(call.args[1]);
    call.hasEffects = true;
    return checkLightSource(call);
  }
  // A function's parameter counts as varying though texts are commonly the same everywhere.
  bool bad = false, varying = false, isPassedText = true;
  for (size_t i = 0; i < texts; ++i) {
    Expr *&arg = call.args[i];
    arg = checkAs(arg, {TypeKind::String}, "argument " + Twine(i + 1) + " of '" + call.name + "'");
    auto *name = dyn_cast<NameExpr>(arg);
    isPassedText &=
        !arg->type.varying || (name && name->decl && name->decl->kind == VarKind::FunctionParam);
    varying |= arg->type.varying;
    bad |= arg->type.isError();
  }
  Expr *&variable = call.args[texts];
  variable = check(variable);
  checkTarget(variable, varying && !isPassedText, variable->loc,
              ("output argument " + Twine(texts + 1) + " of '" + call.name + "'").str());
  call.hasEffects = true;
  Type type = variable->type;
  raiseCapacity(variable, options.arrayCapacity);
  if (!bad && !type.isError())
    call.type = {TypeKind::Float, varying};
  return &call;
}

/// shadername() is the name of the shader at hand, known where a function is expanded;
/// shadername("surface") asks as surface() would.
Expr *Sema::checkShaderName(CallExpr &call) {
  call.form = CallForm::ShaderName;
  call.type = {TypeKind::String};
  if (call.args.empty())
    return &call;
  for (Expr *&arg : call.args)
    arg = check(arg);
  auto *kind = dyn_cast<StringExpr>(call.args[0]);
  bool isShader =
      kind && stc::queryKindNamed(kind->value) &&
      is_contained({"surface", "displacement", "atmosphere", "lightsource", "incident", "opposite"},
                   kind->value);
  if (!isShader || call.args.size() != 1) {
    diags
        .error(call.loc, "'shadername' takes no argument, or one of \"surface\", \"displacement\", "
                         "\"atmosphere\", \"lightsource\", \"incident\" and \"opposite\"")
        .range(call.nameRange);
    call.type = {TypeKind::Error};
  } else if (kind->value == "lightsource") {
    checkIsInLight(call);
  }
  return &call;
}

} // namespace anysl::rsl
