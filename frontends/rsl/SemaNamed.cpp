//===-- frontends/rsl/SemaNamed.cpp - arguments by name ---------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// texture("file"[channel], s, t, "blur", 0.1, …): what NamedArguments.def lists.
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

using namespace llvm;

namespace anysl::rsl {

/// Moves what stands behind a built-in's own arguments from `args` to `rest`: pairs of names and
/// values, which begin at the first text that no overload has a place for, and whatever a built-in
/// takes without looking at it. "file"[channel] is the argument "channel".
void Sema::splitNamed(CallExpr &call) {
  if (call.isSplit || call.object)
    return;
  call.isSplit = true;
  for (const Scope &scope : scopes)
    if (scope.functions.count(call.name))
      return;
  const NamedGroup *group = nullptr;
  bool takesRest = false;
  size_t least = SIZE_MAX, most = 0;
  // occlusion(file, …) takes what follows without looking at it, occlusion(P, N, …) names it.
  bool isFile = !call.args.empty() && probe(call.args[0]).is(TypeKind::String);
  auto overloads = builtinsNamed(call.name);
  bool isEither = any_of(overloads, [](const Builtin *b) { return b->takesRest; }) &&
                  any_of(overloads, [](const Builtin *b) { return b->named; });
  for (const Builtin *builtin : overloads) {
    if (isEither && builtin->takesRest != isFile)
      continue;
    group = builtin->named ? builtin->named : group;
    takesRest |= builtin->takesRest;
    least = std::min(least, builtin->arguments.size());
    if (builtin->arguments.size() <= call.args.size())
      most = std::max(most, builtin->arguments.size());
  }
  if (!group && !takesRest)
    return;
  std::vector<Expr *> rest;
  if (auto *index = call.args.empty() ? nullptr : dyn_cast<IndexExpr>(call.args[0]);
      index && probe(index->base).is(TypeKind::String) &&
      (!group || group->argumentNamed("channel"))) {
    call.args[0] = index->base;
    if (group)
      rest.push_back(ast.make<StringExpr>(index->range, "channel"));
    rest.push_back(index->index);
  }
  size_t end = takesRest ? most : least;
  while (group && end < call.args.size() && !probe(call.args[end]).is(TypeKind::String))
    ++end;
  if (end > call.args.size())
    end = call.args.size();
  llvm::append_range(rest, call.args.drop_front(end));
  call.args = call.args.take_front(end);
  call.rest = ast.copy<Expr *>(rest);
}

/// Says that an argument, which would change the result elsewhere, does not here.
void Sema::warnDeclined(const NamedGroup::Argument &argument, StringRef function,
                        const Expr &name) {
  if (argument.isDeclined)
    diags
        .warning(name.loc, warn::DeclinedArgument,
                 "argument \"" + argument.name + "\" of '" + function +
                     "' changes nothing: " + argument.meaning)
        .range(name.range);
}

/// Finds the field of each argument by name, and checks its value.
void Sema::checkNamed(CallExpr &call, const NamedGroup &group, bool &varying, bool &bad) {
  MutableArrayRef<Expr *> named =
      ast.copy<Expr *>(std::vector<Expr *>(group.fields.size(), nullptr));
  call.named = named;
  for (size_t i = 0; i < call.rest.size(); i += 2) {
    auto *name = dyn_cast<StringExpr>(call.rest[i]);
    if (!name) {
      Expr *wrong = check(call.rest[i]);
      if (!wrong->type.isError())
        diags
            .error(wrong->loc,
                   wrong->type.is(TypeKind::String)
                       ? "the name of an argument must be constant text"
                       : ("'" + call.name + "' expects the name of an argument here").str())
            .range(wrong->range);
      bad = true;
      return;
    }
    if (i + 1 == call.rest.size()) {
      diags.error(name->loc, "argument \"" + name->value + "\" of '" + call.name + "' has no value")
          .range(name->range);
      bad = true;
      return;
    }
    // A type may stand before the name: "uniform float blur".
    StringRef word = name->value.rtrim();
    word = word.substr(word.find_last_of(" \t") + 1);
    Expr *&value = call.rest[i + 1];
    const NamedGroup::Argument *argument = group.argumentNamed(word);
    if (!argument) {
      SmallVector<StringRef, 20> names;
      for (const NamedGroup::Argument &known : group.arguments)
        names.push_back(known.name);
      diags
          .warning(name->loc, warn::UnknownArgument,
                   "'" + call.name + "' has no argument \"" + word + "\"; it is ignored" +
                       didYouMean(word, names))
          .range(name->range);
    }
    if (argument && !argument->fields.empty()) {
      // Renderers differ in whether a mode is a word or a number, which becomes its digits.
      if (argument->type == TypeKind::String && probe(value).is(TypeKind::Float)) {
        Expr *format = ast.make<StringExpr>(value->range, "%g");
        value = ast.make<CallExpr>(value->range, value->range, "format",
                                   ast.copy<Expr *>({format, value}));
      }
      value = checkAs(value, {argument->type, true},
                      ("argument \"" + word + "\" of '" + call.name + "'").str());
      for (unsigned field : argument->fields)
        named[field] = value;
      varying |= value->type.varying;
    } else {
      value = check(value, argument ? argument->type : TypeKind::Error);
      if (argument)
        warnDeclined(*argument, call.name, *name);
    }
    bad |= value->type.isError();
    call.hasEffects |= value->hasEffects;
  }
}

} // namespace anysl::rsl
