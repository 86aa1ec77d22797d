//===-- frontends/rsl/SemaDerivatives.cpp - other forms of calls that ask for derivatives -----===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"

using namespace llvm;

namespace anysl::rsl {

/// area(p, strategy) is area(p): there is one way to look at a surface. filterstep may end with
/// pairs of a name and a value.
Expr *Sema::rewriteCall(CallExpr &call, TypeKind hint) {
  if (call.name == "area" && call.args.size() == 2 && probe(call.args[1]).is(TypeKind::String)) {
    Expr *strategy = check(call.args[1]);
    if (strategy->type.isError())
      return strategy;
    Expr *point[] = {call.args[0]};
    return check(ast.make<CallExpr>(call.nameRange, call.range, call.name, ast.copy<Expr *>(point)),
                 hint);
  }
  if (call.name != "filterstep")
    return nullptr;
  for (size_t i = 2; i < call.args.size() && i < 4; ++i)
    if (probe(call.args[i]).is(TypeKind::String))
      return rewriteFilterstep(call, i, hint);
  return nullptr;
}

/// filterstep(edge, x, …) and filterstep(edge, s0, s1, …) with pairs are functions of their own,
/// which take the factor on the filter's width and the filter's number last.
Expr *Sema::rewriteFilterstep(CallExpr &call, size_t positional, TypeKind hint) {
  call.type = {TypeKind::Error};
  ArrayRef<Expr *> args = call.args;
  Expr *factor = nullptr;
  unsigned filter = 0;
  // In the order in which the shading library numbers them.
  static constexpr StringRef filters[] = {"box", "triangle", "gaussian", "catmull-rom"};
  auto refuse = [&](const Expr *at, const Twine &message) {
    diags.error(at->loc, message).range(at->range);
    return &call;
  };
  for (size_t i = positional; i < args.size(); i += 2) {
    auto *name = dyn_cast<StringExpr>(args[i]);
    if (!name)
      return refuse(args[i], "here must stand the name of an argument of 'filterstep'");
    if (i + 1 == args.size())
      return refuse(name, "argument \"" + name->value + "\" of 'filterstep' has no value");
    if (name->value == "width") {
      factor = args[i + 1];
    } else if (name->value == "filter") {
      auto *value = dyn_cast<StringExpr>(args[i + 1]);
      if (!value)
        return refuse(args[i + 1], "the filter of 'filterstep' must be constant text");
      filter = unsigned(find(filters, value->value) - std::begin(filters));
      if (filter == std::size(filters))
        return refuse(value,
                      "unknown filter '" + value->value + "'" + didYouMean(value->value, filters));
    } else {
      return refuse(name, "'filterstep' has no argument \"" + name->value + "\"" +
                              didYouMean(name->value, {"width", "filter"}));
    }
  }
  SmallVector<Expr *, 5> operands(args.take_front(positional));
  if (factor)
    operands.push_back(factor);
  for (Expr *operand : operands)
    if (Type type = probe(operand); !type.isError() && !type.is(TypeKind::Float))
      return refuse(operand, "'filterstep' takes floats, not a " + toString(type));
  if (!factor)
    operands.push_back(ast.make<NumberExpr>(call.range, 1.0));
  operands.push_back(ast.make<NumberExpr>(call.range, double(filter)));
  return check(
      ast.make<CallExpr>(call.nameRange, call.range, "__filterstep", ast.copy<Expr *>(operands)),
      hint);
}

} // namespace anysl::rsl
