//===-- frontends/rsl/LowerText.cpp - built-ins that make text --------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Lowering.h"

#include <anysl/format.h>

using namespace llvm;

namespace anysl::rsl {

using stc::Op;

namespace {

/// The operators that show a value of a type.
struct Showing {
  Op append, print;
};

Showing showing(TypeKind kind) {
  switch (kind) {
  case TypeKind::Float:
    return {Op::append_float, Op::print_float};
  case TypeKind::Color:
    return {Op::append_color, Op::print_color};
  case TypeKind::Matrix:
    return {Op::append_matrix, Op::print_matrix};
  case TypeKind::String:
    return {Op::append_string, Op::print_string};
  default:
    return {Op::append_vector, Op::print_vector};
  }
}

/// How many values a constant format takes, and whether it has text behind the last.
std::pair<size_t, bool> shapeOf(StringRef format) {
  std::string_view text(format.data(), format.size());
  size_t directives = 0, behind = 0;
  for (size_t at = 0;;) {
    FormatDirective next = nextPercent(text, at);
    if (next.begin == std::string_view::npos)
      return {directives, behind < text.size()};
    at = next.end;
    if (!next.letter || next.letter == '%')
      continue;
    ++directives;
    behind = at;
  }
}

} // namespace

/// A format is followed at run time, one operator for each value, whether or not it is constant.
Value *Lowering::callFormat(const CallExpr &call) {
  bool isPrint = call.form == CallForm::Print;
  SmallVector<Value *, 8> values;
  for (size_t i = 0; i < call.args.size(); ++i)
    values.push_back(lowerBefore(call.args[i], effectsAfter(call, i)));
  at(call.loc);
  auto *constant = dyn_cast<StringExpr>(call.args[0]);
  if (constant && !isPrint && !constant->value.contains('%'))
    return values[0];
  Value *result = isPrint ? nullptr : text("");
  if (!hasContext(call.loc))
    return result;
  size_t count = values.size() - 1;
  bool hasRest = true;
  if (constant) {
    auto [directives, hasText] = shapeOf(constant->value);
    count = std::min(count, directives);
    hasRest = hasText || count < directives;
  }
  auto apply = [&](Op append, Op print, Value *index, ArrayRef<Value *> value) {
    SmallVector<Value *, 6> operands;
    Value *longer = isPrint ? nullptr : temporary(call.type);
    if (isPrint)
      operands = {b.context(), values[0], index};
    else
      operands = {longer, b.context(), result, values[0], index};
    operands.append(value.begin(), value.end());
    b.call(isPrint ? print : append, operands);
    result = longer;
  };
  for (size_t i = 0; i < count; ++i) {
    Showing ops = showing(call.args[i + 1]->type.kind);
    apply(ops.append, ops.print, b.index(static_cast<int>(i)), values[i + 1]);
  }
  // A line is printed at its end.
  if (hasRest || isPrint)
    apply(Op::append_rest, Op::print_rest, b.index(static_cast<int>(count)), {});
  return result;
}

Value *Lowering::callConcat(const CallExpr &call) {
  SmallVector<Value *, 4> values;
  for (size_t i = 0; i < call.args.size(); ++i)
    values.push_back(lowerBefore(call.args[i], effectsAfter(call, i)));
  at(call.loc);
  Value *result = values[0];
  if (values.size() == 1 || !hasContext(call.loc))
    return result;
  Value *format = text("%s");
  for (Value *next : ArrayRef(values).drop_front()) {
    Value *longer = temporary(call.type);
    b.call(Op::append_string, {longer, b.context(), result, format, b.index(0), next});
    result = longer;
  }
  return result;
}

} // namespace anysl::rsl
