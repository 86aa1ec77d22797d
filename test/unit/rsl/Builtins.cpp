//===-- test/unit/rsl/Builtins.cpp - the table of built-ins fits the table of operators -------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Builtins.h"
#include "lib/STC/Shader.h"
#include <catch2/catch.hpp>
#include <set>

using namespace anysl;
using namespace anysl::rsl;

static bool agree(TypeKind a, stc::Type b) {
  TypeKind kind = typeKindOf(b);
  return a == kind || (Type{a}.isGeometric() && Type{kind}.isGeometric());
}

TEST_CASE("every built-in gives its operator what that takes") {
  for (const Builtin &builtin : allBuiltins()) {
    CAPTURE(signature(builtin));
    const stc::OpInfo &op = stc::info(builtin.op);
    bool isTest = op.result == stc::ResultKind::Test;
    CHECK(isTest == (builtin.result == TypeKind::Bool));
    size_t next = 0, followers = 0;
    bool needsResult = !isTest && builtin.result != TypeKind::Void;
    for (const stc::OpParam &param : op.params) {
      if (param.kind == stc::ParamKind::Ctx)
        continue;
      if (needsResult) {
        needsResult = false;
        CHECK(param.kind == stc::ParamKind::Out);
        CHECK(agree(builtin.result, param.type));
        continue;
      }
      if (followers) {
        --followers;
        CHECK(param.kind == stc::ParamKind::In);
        CHECK(Type{typeKindOf(param.type)}.isGeometric());
        continue;
      }
      REQUIRE(next < builtin.operands.size());
      const BuiltinOperand &operand = builtin.operands[next++];
      switch (operand.source) {
      case BuiltinOperand::In:
        CHECK(param.kind == stc::ParamKind::In);
        CHECK(agree(operand.type, param.type));
        break;
      case BuiltinOperand::Out:
        CHECK(param.kind == stc::ParamKind::Out);
        CHECK(agree(operand.type, param.type));
        break;
      case BuiltinOperand::InOut:
        CHECK(param.kind == stc::ParamKind::InOut);
        CHECK(agree(operand.type, param.type));
        break;
      case BuiltinOperand::Global:
        CHECK(param.kind == stc::ParamKind::In);
        CHECK(agree(typeKindOf(stc::globalNumbered(unsigned(operand.global))->type), param.type));
        break;
      case BuiltinOperand::Named:
        CHECK(param.kind == stc::ParamKind::In);
        CHECK(agree(operand.type, param.type));
        REQUIRE(builtin.named);
        CHECK(builtin.named->fields[operand.field].type == operand.type);
        break;
      case BuiltinOperand::Number:
        CHECK(param.kind == stc::ParamKind::In);
        CHECK(param.type == stc::Type::floatTy);
        break;
      case BuiltinOperand::Text:
        CHECK(param.kind == stc::ParamKind::In);
        CHECK(param.type == stc::Type::stringTy);
        break;
      case BuiltinOperand::Discard:
        CHECK(param.kind == stc::ParamKind::Out);
        break;
      case BuiltinOperand::Light:
        // Its number, and behind it the position and the normal that it lights.
        CHECK(param.kind == stc::ParamKind::Index);
        followers = 2;
        break;
      case BuiltinOperand::SpaceTo:
      case BuiltinOperand::SpaceFromTo:
        CHECK(param.kind == stc::ParamKind::In);
        CHECK(param.type == stc::Type::matrixTy);
        break;
      }
    }
    CHECK(next == builtin.operands.size());
    CHECK_FALSE(needsResult);
  }
}

TEST_CASE("no two overloads of a built-in are the same") {
  std::set<std::string> seen;
  for (const Builtin &builtin : allBuiltins())
    CHECK(seen.insert(signature(builtin)).second);
}

TEST_CASE("an argument by name has the type of the fields that it sets") {
  REQUIRE(!namedGroups().empty());
  for (const NamedGroup &group : namedGroups()) {
    std::set<std::string> seen;
    for (const NamedGroup::Argument &argument : group.arguments) {
      CAPTURE(group.name.str(), argument.name.str());
      CHECK(seen.insert(argument.name.str()).second);
      CHECK(group.argumentNamed(argument.name) == &argument);
      for (unsigned field : argument.fields)
        CHECK(group.fields[field].type == argument.type);
    }
    CHECK_FALSE(group.argumentNamed("nothing"));
  }
}

TEST_CASE("built-ins are found by name") {
  CHECK(builtinsNamed("faceforward").size() == 2);
  CHECK(builtinsNamed("noise").size() == 12);
  CHECK(builtinsNamed("nothing").empty());
  CHECK(missingFor("noise").empty());
  for (llvm::StringRef name : builtinNames())
    CHECK(missingFor(name).empty());
}
