//===-- frontends/rsl/SemaGather.cpp - gather() -----------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include "frontends/rsl/Warnings.h"

#include "llvm/ADT/StringSwitch.h"

using namespace llvm;

namespace anysl::rsl {

namespace {
struct KnownOutput {
  GatherValue value;
  StringLiteral name;
  TypeKind type;
};
constexpr KnownOutput knownOutputs[] = {
#define RSL_GATHER_OUTPUT(id, name, type, onMiss, meaning) {GatherValue::id, name, TypeKind::type},
#include "frontends/rsl/GatherOutputs.def"
};
} // namespace

/// gather(category, P, direction, angle, samples, "name", value, …, "class:name", variable, …)
void Sema::checkGather(GatherStmt &stmt) {
  if (stmt.args.size() < 5) {
    diags.error(stmt.loc, "'gather' takes a category, a point, a direction, an angle and a number "
                          "of samples");
    for (Expr *&arg : stmt.args)
      arg = check(arg);
  } else {
    MutableArrayRef<Expr *> args = stmt.args;
    auto take = [&](unsigned i, TypeKind type, StringRef what) {
      return args[i] = checkAs(args[i], {type, true}, what + " for 'gather'");
    };
    stmt.category = take(0, TypeKind::String, "the category");
    stmt.position = take(1, TypeKind::Point, "the position");
    stmt.direction = take(2, TypeKind::Vector, "the direction");
    stmt.angle = take(3, TypeKind::Float, "the angle");
    stmt.samples = take(4, TypeKind::Float, "the number of samples");
    checkGatherPairs(stmt, args.drop_front(5));
  }
  useVarying();
  ++loops;
  checkStmt(stmt.body);
  checkStmt(stmt.elseBody);
  --loops;
}

/// What of a surface that a ray meets a pair asks for, if it is no argument of gather's own: groups
/// as <anysl/abi.h> has them in AnyslHits. A name alone, with a variable, is one of the surface
/// shader's.
static std::optional<std::string> askedByGather(StringRef word, const Expr *value,
                                                const NamedGroup &group) {
  auto [kind, name] = word.split(':');
  if (is_contained({"surface", "displacement", "primitive", "attribute"}, kind) && !name.empty() &&
      !name.contains(','))
    return word.str();
  SmallVector<StringRef, 32> known;
  for (const NamedGroup::Argument &argument : group.arguments)
    known.push_back(argument.name);
  if (word.empty() || word.contains(':') || word.contains(',') || !isa<NameExpr>(value) ||
      !didYouMean(word, known).empty())
    return std::nullopt;
  return ("surface:" + word).str();
}

void Sema::checkGatherPairs(GatherStmt &stmt, MutableArrayRef<Expr *> pairs) {
  const NamedGroup &group =
      *llvm::find_if(namedGroups(), [](const NamedGroup &known) { return known.name == "gather"; });
  std::vector<Expr *> named(group.fields.size(), nullptr);
  std::vector<GatherStmt::Output> outputs;
  std::vector<LightMessage> asked;
  for (size_t i = 0; i < pairs.size(); i += 2) {
    auto *name = dyn_cast<StringExpr>(pairs[i]);
    if (!name || i + 1 == pairs.size()) {
      diags
          .error(pairs[i]->loc,
                 name ? ("argument \"" + name->value + "\" of 'gather' has no value").str()
                      : "the name of an argument must be constant text")
          .range(pairs[i]->range);
      break;
    }
    StringRef word = name->value.rtrim();
    word = word.substr(word.find_last_of(" \t") + 1);
    Expr *&value = pairs[i + 1];
    if (const NamedGroup::Argument *argument = group.argumentNamed(word)) {
      value = argument->fields.empty() ? check(value, argument->type)
                                       : checkAs(value, {argument->type, true},
                                                 ("argument \"" + word + "\" of 'gather'").str());
      for (unsigned field : argument->fields)
        named[field] = value;
      warnDeclined(*argument, "gather", *name);
      continue;
    }
    value = check(value);
    if (const auto *known = llvm::find_if(
            knownOutputs, [&](const KnownOutput &output) { return output.name == word; });
        known != std::end(knownOutputs)) {
      if (!value->type.isError() && conversionCost({known->type}, value->type) < 0)
        diags
            .error(value->loc, "\"" + word + "\" is a " + nameOf(known->type) +
                                   ", which a variable of type '" + toString(value->type) +
                                   "' cannot hold")
            .range(value->range);
      checkTarget(value, true, value->loc, ("output \"" + word + "\" of 'gather'").str());
      outputs.push_back({known->value, known->type, value});
      continue;
    }
    if (std::optional<std::string> name = askedByGather(word, value, group)) {
      checkTarget(value, true, value->loc, ("output \"" + word + "\" of 'gather'").str());
      char letter = shapeLetter(value->type.element());
      if (!value->type.isError() && (!letter || letter == 'v' || value->type.isResizable))
        diags
            .error(value->loc, "a variable of type '" + toString(value->type) + "' cannot hold \"" +
                                   word + "\"")
            .range(value->range);
      else
        asked.push_back({ast.save(*name), value});
      continue;
    }
    SmallVector<StringRef, 32> names;
    for (const KnownOutput &output : knownOutputs)
      names.push_back(output.name);
    for (const NamedGroup::Argument &argument : group.arguments)
      names.push_back(argument.name);
    bool isOutput = word.contains(':');
    diags
        .warning(name->loc, warn::UnknownArgument,
                 isOutput ? "'gather' does not give \"" + word + "\"; the variable stays as it is" +
                                didYouMean(word, names)
                          : "'gather' has no argument \"" + word + "\"; it is ignored" +
                                didYouMean(word, names))
        .range(name->range);
    // What another renderer would write is no unused variable.
    if (auto *variable = dyn_cast<NameExpr>(value); isOutput && variable && variable->decl)
      variable->decl->isAssigned = true;
  }
  stmt.named = ast.copy<Expr *>(named);
  stmt.outputs = ast.copy<GatherStmt::Output>(outputs);
  stmt.asked = ast.copy<LightMessage>(asked);
}

} // namespace anysl::rsl
