//===-- frontends/rsl/SemaLight.cpp - illuminance, illuminate, solar, lightsource -------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

using namespace llvm;

namespace anysl::rsl {

/// Sorts the arguments of illuminance([category,] P [, axis, angle] [, name, value ...]),
/// illuminate(P [, axis, angle]) and solar([axis, angle]).
void Sema::checkLight(LightStmt &stmt) {
  StringRef word = stmt.kind == StmtKind::Illuminance  ? "illuminance"
                   : stmt.kind == StmtKind::Illuminate ? "illuminate"
                                                       : "solar";
  bool isLoop = stmt.kind == StmtKind::Illuminance, hasPosition = stmt.kind != StmtKind::Solar;
  if (!isLoop && shader && shader->type != ShaderType::Light)
    diags.error(stmt.loc,
                "'" + word + "' belongs in a light shader, not in a " + nameOf(shader->type));
  ArrayRef<Expr *> args = stmt.args;
  if (isLoop && !args.empty() && probe(args[0]).is(TypeKind::String)) {
    stmt.category = check(args[0]);
    args = args.drop_front();
  }
  if (hasPosition && !args.empty()) {
    stmt.position = checkAs(args[0], {TypeKind::Point, true}, "the position for '" + word + "'");
    args = args.drop_front();
  }
  bool namesFollow = isLoop && !args.empty() && probe(args[0]).is(TypeKind::String);
  if ((hasPosition && !stmt.position) || (!namesFollow && args.size() == 1)) {
    diags.error(stmt.loc, "'" + word + "' takes " +
                              (hasPosition ? "a position and, optionally, an axis and an angle"
                                           : "an axis and an angle, or nothing"));
    for (Expr *arg : args)
      check(arg);
    args = {};
  } else if (!namesFollow && !args.empty()) {
    stmt.axis = checkAs(args[0], {TypeKind::Vector, true}, "the axis for '" + word + "'");
    stmt.angle = checkAs(args[1], {TypeKind::Float, true}, "the angle for '" + word + "'");
    args = args.drop_front(2);
  }
  if (isLoop)
    checkLightMessages(stmt, args);
  else if (!args.empty())
    diags.error(args[0]->loc, "'" + word + "' takes no more arguments").range(args[0]->range);
  useVarying();
  loops += isLoop;
  illuminances += isLoop;
  checkStmt(stmt.body);
  loops -= isLoop;
  illuminances -= isLoop;
}

/// What later renderers take behind the other arguments: "light:NAME", variable asks each light,
/// "send:light:NAME", value tells it, "lightcache", "refresh" or "reuse" is about speed only.
void Sema::checkLightMessages(LightStmt &stmt, ArrayRef<Expr *> args) {
  std::vector<LightMessage> asked, sent;
  for (; !args.empty(); args = args.drop_front(std::min<size_t>(args.size(), 2))) {
    Expr *given = check(args[0]);
    auto *name = dyn_cast<StringExpr>(given);
    if (!name) {
      if (!given->type.isError())
        diags
            .error(given->loc, given->type.is(TypeKind::String)
                                   ? "the name of an argument must be constant text"
                                   : "'illuminance' takes no more arguments but with a name")
            .range(given->range);
      for (Expr *arg : args.drop_front())
        check(arg);
      break;
    }
    if (args.size() == 1) {
      diags.error(name->loc, "'" + name->value + "' lacks its value").range(name->range);
      break;
    }
    StringRef key = name->value;
    Expr *value = check(args[1]);
    if (key.consume_front("send:light:")) {
      if (checkSentValue(value))
        sent.push_back({key, value});
    } else if (key.consume_front("light:")) {
      if (checkAskedLight(value, "'" + name->value + "'"))
        asked.push_back({key, value});
    } else if (key != "lightcache") {
      StringRef known[] = {"light:", "send:light:", "lightcache"};
      diags
          .error(name->loc,
                 "'illuminance' has no argument '" + name->value + "'" + didYouMean(key, known))
          .range(name->range);
    }
  }
  stmt.asked = ast.copy<LightMessage>(asked);
  stmt.sent = ast.copy<LightMessage>(sent);
}

/// A value for a light's parameter.
bool Sema::checkSentValue(Expr *value) {
  char letter = shapeLetter(value->type.element());
  if (!value->type.isError() && (!letter || letter == 'v'))
    diags
        .error(value->loc,
               "a value of type '" + toString(value->type) + "' cannot be sent to a light")
        .range(value->range);
  return letter && letter != 'v';
}

/// A variable that a light's parameter is to be put into.
bool Sema::checkAskedLight(Expr *variable, const Twine &what) {
  // The value may differ from point to point, yet a uniform variable is common here.
  checkTarget(variable, false, variable->loc, what.str());
  if (variable->type.isError())
    return false;
  if (!variable->type.isResizable)
    return true;
  diags.error(variable->loc, what + " needs an array of constant length").range(variable->range);
  return false;
}

/// lightsource(name, variable)
Expr *Sema::checkLightSource(CallExpr &call) {
  bool good = checkAskedLight(call.args[1], "output argument 2 of 'lightsource'");
  if (!illuminances && !function)
    diags
        .warning(call.loc, warn::Unanswered,
                 "outside of 'illuminance' there is no light to ask; it gives 0")
        .range(call.range);
  call.type = {good && !call.args[0]->type.isError() ? TypeKind::Float : TypeKind::Error};
  return &call;
}

} // namespace anysl::rsl
