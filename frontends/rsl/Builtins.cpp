//===-- frontends/rsl/Builtins.cpp - the built-in functions of RSL ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Builtins.h"

#include "lib/STC/Shader.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringSwitch.h"

using namespace llvm;

namespace anysl::rsl {
namespace {

TypeKind typeNamed(StringRef name) {
  return StringSwitch<TypeKind>(name)
      .Case("void", TypeKind::Void)
      .Case("condition", TypeKind::Bool)
      .Case("float", TypeKind::Float)
      .Case("color", TypeKind::Color)
      .Case("point", TypeKind::Point)
      .Case("vector", TypeKind::Vector)
      .Case("normal", TypeKind::Normal)
      .Case("matrix", TypeKind::Matrix)
      .Case("string", TypeKind::String)
      .Default(TypeKind::Error);
}

/// One entry between the commas of an operand list.
BuiltinOperand parseOperand(StringRef text) {
  BuiltinOperand operand;
  if (text == "space") {
    operand.source = BuiltinOperand::SpaceTo;
  } else if (text == "space space") {
    operand.source = BuiltinOperand::SpaceFromTo;
  } else if (text == "space matrix") {
    operand.source = BuiltinOperand::SpaceThenMatrix;
  } else if (text.consume_front("=")) {
    text = text.trim();
    if (text == "_") {
      operand.source = BuiltinOperand::Discard;
    } else if (text == "light") {
      operand.source = BuiltinOperand::Light;
    } else if (text.starts_with("\"")) {
      operand.source = BuiltinOperand::Text;
      operand.text = text.drop_front().drop_back();
    } else if (!text.getAsDouble(operand.number)) {
      operand.source = BuiltinOperand::Number;
    } else {
      operand.source = BuiltinOperand::Global;
      for (const stc::GlobalVariableInfo &global : stc::allGlobals())
        if (global.name == text)
          operand.global = static_cast<int>(global.id);
      assert(operand.global >= 0 && "Builtins.def names an unknown global");
    }
  } else {
    if (text.consume_front("out "))
      operand.source = BuiltinOperand::Out;
    else if (text.consume_front("inout "))
      operand.source = BuiltinOperand::InOut;
    operand.type = typeNamed(text.trim());
    assert(operand.type != TypeKind::Error && "Builtins.def names an unknown type");
  }
  return operand;
}

/// Adds one row of NamedArguments.def to its group.
void addField(std::vector<NamedGroup> &groups, StringRef group, StringRef field, StringRef type,
              double number) {
  if (groups.empty() || groups.back().name != group)
    groups.push_back({group, {}, {}});
  groups.back().fields.push_back({field, typeNamed(type), number});
}

void addRayField(std::vector<NamedGroup> &groups, StringRef group, StringRef field, StringRef type,
                 double number) {
  addField(groups, group, field, type, number);
  groups.back().fields.back().isForRays = true;
}

void addArgument(std::vector<NamedGroup> &groups, StringRef name, StringRef type, StringRef fields,
                 StringRef meaning) {
  NamedGroup &group = groups.back();
  NamedGroup::Argument argument{name, typeNamed(type), {}, meaning};
  SmallVector<StringRef, 4> parts;
  fields.drop_front().drop_back().split(parts, ',', -1, /*KeepEmpty=*/false);
  for (StringRef part : parts) {
    auto *field = find_if(group.fields, [&](auto &known) { return known.name == part.trim(); });
    assert(field != group.fields.end() && "NamedArguments.def names an unknown field");
    argument.fields.push_back(unsigned(field - group.fields.begin()));
  }
  group.arguments.push_back(argument);
}

struct Table {
  std::vector<NamedGroup> groups;
  std::vector<Builtin> builtins;
  StringMap<SmallVector<const Builtin *, 4>> byName;
  std::vector<StringRef> names;

  /// The operands that `named GROUP` stands for.
  void addNamed(Builtin &builtin, StringRef groupName) {
    auto group = find_if(groups, [&](auto &known) { return known.name == groupName; });
    assert(group != groups.end() && "Builtins.def names an unknown group");
    builtin.named = &*group;
    for (auto [i, field] : enumerate(group->fields)) {
      if (field.isForRays)
        continue;
      BuiltinOperand operand;
      operand.source = BuiltinOperand::Named;
      operand.type = field.type;
      operand.number = field.number;
      operand.field = unsigned(i);
      builtin.operands.push_back(operand);
    }
  }

  Table() {
#define RSL_NAMED_FIELD(group, field, type, number) addField(groups, #group, #field, #type, number);
#define RSL_RAY_FIELD(group, field, type, number)                                                  \
  addRayField(groups, #group, #field, #type, number);
#define RSL_NAMED_ARGUMENT(group, name, type, fields, meaning)                                     \
  addArgument(groups, #name, #type, #fields, meaning);
#define RSL_DECLINED_ARGUMENT(group, name, type, why)                                              \
  addArgument(groups, #name, #type, "()", why);                                                    \
  groups.back().arguments.back().isDeclined = true;
#include "frontends/rsl/NamedArguments.def"
    struct Row {
      StringRef result, name, operands;
      stc::Op op;
      StringRef meaning;
    };
    static constexpr Row rows[] = {
#define RSL_BUILTIN(result, name, operands, op, meaning)                                           \
  {#result, #name, #operands, stc::Op::op, meaning},
#include "frontends/rsl/Builtins.def"
    };
    builtins.reserve(std::size(rows));
    for (const Row &row : rows) {
      Builtin builtin{row.name, typeNamed(row.result), {}, row.op, row.meaning, {}, nullptr, false};
      SmallVector<StringRef, 8> parts;
      row.operands.drop_front().drop_back().split(parts, ',', -1, /*KeepEmpty=*/false);
      for (StringRef part : parts) {
        part = part.trim();
        if (part == "rest") {
          builtin.takesRest = true;
          continue;
        }
        if (part.consume_front("named ")) {
          addNamed(builtin, part.trim());
          continue;
        }
        BuiltinOperand operand = parseOperand(part);
        if (operand.source <= BuiltinOperand::InOut)
          builtin.arguments.push_back({operand.type, operand.source != BuiltinOperand::Out,
                                       operand.source != BuiltinOperand::In});
        else
          for (unsigned i = 0; i < operand.argumentCount(); ++i)
            builtin.arguments.push_back({i == 1 && operand.source == BuiltinOperand::SpaceThenMatrix
                                             ? TypeKind::Matrix
                                             : TypeKind::String,
                                         true, false});
        builtin.operands.push_back(operand);
      }
      builtins.push_back(std::move(builtin));
    }
    for (const Builtin &builtin : builtins) {
      SmallVector<const Builtin *, 4> &overloads = byName[builtin.name];
      if (overloads.empty() && !builtin.name.starts_with("__"))
        names.push_back(builtin.name);
      overloads.push_back(&builtin);
    }
#define RSL_SPECIAL(result, name, arguments, meaning) names.push_back(#name);
#include "frontends/rsl/Builtins.def"
    for (const stc::QueryKind &kind : stc::allQueryKinds())
      names.push_back(kind.name);
  }
};

const Table &table() {
  static const Table table;
  return table;
}

} // namespace

const NamedGroup::Argument *NamedGroup::argumentNamed(StringRef wanted) const {
  for (const Argument &argument : arguments)
    if (argument.name == wanted)
      return &argument;
  return nullptr;
}

ArrayRef<NamedGroup> namedGroups() { return table().groups; }

ArrayRef<Builtin> allBuiltins() { return table().builtins; }

ArrayRef<const Builtin *> builtinsNamed(StringRef name) {
  auto found = table().byName.find(name);
  return found == table().byName.end() ? ArrayRef<const Builtin *>() : found->second;
}

ArrayRef<StringRef> builtinNames() { return table().names; }

TypeKind specialResult(StringRef name) {
#define RSL_SPECIAL(result, special, arguments, meaning)                                           \
  if (name == #special)                                                                            \
    return StringRef(#result) == "condition" ? TypeKind::Error : typeNamed(#result);
#include "frontends/rsl/Builtins.def"
  return stc::queryKindNamed(name) ? TypeKind::Float : TypeKind::Error;
}

StringRef missingFor(StringRef name) {
#define RSL_UNSUPPORTED(known, need)                                                               \
  if (name == #known)                                                                              \
    return need;
#include "frontends/rsl/Builtins.def"
  return {};
}

std::string signature(const Builtin &builtin) {
  std::string text = (nameOf(builtin.result) + " " + builtin.name + "(").str();
  for (const Builtin::Argument &argument : builtin.arguments) {
    if (!StringRef(text).ends_with("("))
      text += ", ";
    text += (argument.isOut ? "output " : "") + nameOf(argument.type).str();
  }
  if (builtin.named || builtin.takesRest)
    text += StringRef(text).ends_with("(") ? "..." : ", ...";
  return text + ")";
}

} // namespace anysl::rsl
