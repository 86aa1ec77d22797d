//===-- frontends/rsl/SemaText.cpp - built-ins that make text ---------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

#include <anysl/format.h>

using namespace llvm;

namespace anysl::rsl {

/// What a directive's letter asks for; Error for %s, which takes no conversion.
static TypeKind wantedBy(char letter) {
  switch (letter) {
  case 'c':
    return TypeKind::Color;
  case 'p':
    return TypeKind::Point;
  case 'm':
    return TypeKind::Matrix;
  case 's':
    return TypeKind::String;
  default:
    return TypeKind::Float;
  }
}

/// Points, vectors, normals and colors are printed alike; anything else that does not convert has
/// its own form instead of the directive's.
static bool suits(Type type, TypeKind wanted) {
  return type.isError() || conversionCost(type, {wanted}) >= 0;
}

/// The directives of a constant format that take values; warns of what only looks like one.
std::vector<FormatDirective> Sema::directivesOf(const StringExpr &format) {
  std::vector<FormatDirective> directives;
  std::string_view text(format.value.data(), format.value.size());
  for (size_t at = 0;;) {
    FormatDirective next = nextPercent(text, at);
    if (next.begin == std::string_view::npos)
      return directives;
    if (!next.letter)
      diags
          .warning(format.loc, warn::Format,
                   "'" + format.value.slice(next.begin, next.end) +
                       "' is no directive and stays as it is; '%%' is a percent sign")
          .range(format.range);
    else if (next.letter != '%')
      directives.push_back(next);
    at = next.end;
  }
}

/// printf(format, values…) and format(format, values…).
Expr *Sema::checkFormat(CallExpr &call) {
  bool isPrint = call.name == "printf";
  call.form = isPrint ? CallForm::Print : CallForm::Format;
  call.type = {TypeKind::Error};
  if (call.args.empty()) {
    diags.error(call.loc, "'" + call.name + "' takes a format and values").range(call.nameRange);
    return &call;
  }
  call.args[0] = checkAs(call.args[0], {TypeKind::String}, "the format of '" + call.name + "'");
  bool bad = call.args[0]->type.isError(), varying = call.args[0]->type.varying;
  call.hasEffects = call.args[0]->hasEffects;
  auto *constant = dyn_cast<StringExpr>(call.args[0]);
  std::vector<FormatDirective> directives;
  if (constant)
    directives = directivesOf(*constant);
  for (size_t i = 1; i < call.args.size(); ++i) {
    Expr *&arg = call.args[i];
    bool isNamed = i <= directives.size();
    TypeKind wanted = isNamed ? wantedBy(directives[i - 1].letter) : TypeKind::Error;
    arg = check(arg, wanted);
    if (arg->type.isArray() || arg->type.is(TypeKind::Void)) {
      diags.error(arg->loc, "a value of type '" + toString(arg->type) + "' cannot be shown")
          .range(arg->range);
      bad = true;
    } else if (isNamed && !suits(arg->type, wanted)) {
      diags
          .warning(arg->loc, warn::Format,
                   "'" + constant->value.slice(directives[i - 1].begin, directives[i - 1].end) +
                       "' is for a " + nameOf(wanted) + ", not for a " + toString(arg->type))
          .range(arg->range);
    } else if (isNamed) {
      arg = convert(arg, {wanted}, "a value of '" + call.name + "'");
    }
    if (arg->type.is(TypeKind::Bool))
      arg = convert(arg, {TypeKind::Float}, "a value of '" + call.name + "'");
    bad |= arg->type.isError();
    varying |= arg->type.varying;
    call.hasEffects |= arg->hasEffects;
  }
  size_t values = call.args.size() - 1;
  if (constant && values != directives.size()) {
    auto warning = diags.warning(call.loc, warn::Format,
                                 "the format has " + Twine(directives.size()) +
                                     " directives, but there are " + Twine(values) + " values");
    warning.range(constant->range);
    for (Expr *surplus : call.args.drop_front(std::min(directives.size(), values) + 1))
      warning.range(surplus->range);
  }
  if (!bad)
    call.type = isPrint ? Type{TypeKind::Void} : Type{TypeKind::String, varying};
  return &call;
}

/// concat(a, b, …)
Expr *Sema::checkConcat(CallExpr &call) {
  call.form = CallForm::Concat;
  bool bad = call.args.empty(), varying = false;
  if (bad)
    diags.error(call.loc, "'concat' takes texts to join").range(call.nameRange);
  for (size_t i = 0; i < call.args.size(); ++i) {
    Expr *&arg = call.args[i];
    arg = checkAs(arg, {TypeKind::String}, "argument " + Twine(i + 1) + " of 'concat'");
    bad |= arg->type.isError();
    varying |= arg->type.varying;
    call.hasEffects |= arg->hasEffects;
  }
  call.type = {bad ? TypeKind::Error : TypeKind::String, varying};
  return &call;
}

} // namespace anysl::rsl
