//===-- test/unit/STC/OpsTest.cpp - the operators' table ----------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/STC/Ops.h"
#include "lib/STC/Shader.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/IR/DerivedTypes.h"
#include "llvm/IR/LLVMContext.h"
#include <catch2/catch.hpp>

using namespace anysl::stc;

TEST_CASE("operators stand in ascending order of their numbers") {
  for (size_t i = 1; i < allOps().size(); ++i) {
    INFO(allOps()[i].name.str());
    CHECK(allOps()[i - 1].id() < allOps()[i].id());
  }
}

TEST_CASE("an operator is found by number, name and symbol") {
  CHECK(info(Op::reflect).name == "reflect");
  CHECK(opNamed("reflect")->op == Op::reflect);
  CHECK(opOfSymbol("anysl_reflect")->op == Op::reflect);
  CHECK(opNamed("anysl_reflect") == nullptr);
  CHECK(opOfSymbol("reflect") == nullptr);
  CHECK(opOfSymbol("anysl_type_vector") == nullptr);
}

TEST_CASE("numbers of operators never change") {
  // One from each section of the table: files written by an older version hold them.
  CHECK(unsigned(Op::alloc) == 1);
  CHECK(unsigned(Op::const_float) == 20);
  CHECK(unsigned(Op::dot) == 93);
  CHECK(unsigned(Op::lt_float) == 110);
  CHECK(unsigned(Op::smoothstep) == 162);
  CHECK(unsigned(Op::reflect) == 204);
  CHECK(unsigned(Op::noise_float_3) == 232);
  CHECK(unsigned(Op::load_param_float) == 306);
  CHECK(unsigned(Op::trace_color) == 361);
}

TEST_CASE("function types follow from the table") {
  llvm::LLVMContext context;
  auto *pointer = llvm::PointerType::getUnqual(context);
  auto *sample = functionType(context, info(Op::light_sample));
  CHECK(sample->getReturnType()->isIntegerTy(1));
  REQUIRE(sample->getNumParams() == 7);
  CHECK(sample->getParamType(0) == pointer);
  CHECK(sample->getParamType(1)->isIntegerTy(32));
  CHECK(functionType(context, info(Op::const_float))->getParamType(1)->isDoubleTy());
  CHECK(functionType(context, info(Op::alloc))->getReturnType() == pointer);
  CHECK(functionType(context, info(Op::float_from_test))->getParamType(1)->isIntegerTy(1));
}

TEST_CASE("an operator that asks for the context says so") {
  CHECK(info(Op::trace_color).takesContext());
  CHECK_FALSE(info(Op::reflect).takesContext());
  CHECK(toString(info(Op::fresnel).params[3]) == "Out(float)");
  CHECK(toString(info(Op::trace_color).params[1]) == "Ctx");
}

TEST_CASE("the kinds of numbers are told apart") {
  CHECK(idKind(info(Op::load_global_color)) == IdKind::Global);
  CHECK(idKind(info(Op::store_param_string)) == IdKind::Cell);
  CHECK(idKind(info(Op::param_is_bound)) == IdKind::Param);
  CHECK(idKind(info(Op::store_varying_float)) == IdKind::Param);
  CHECK(idKind(info(Op::query_string)) == IdKind::Query);
  CHECK_FALSE(idKind(info(Op::add_float)));
}

TEST_CASE("points, vectors and normals are one representation, colours another") {
  CHECK(sameRepresentation(Type::pointTy, Type::normalTy));
  CHECK(sameRepresentation(Type::vectorTy, Type::vectorTy));
  CHECK_FALSE(sameRepresentation(Type::colorTy, Type::vectorTy));
  CHECK_FALSE(sameRepresentation(Type::floatTy, Type::stringTy));
}

TEST_CASE("types and globals are found by name and number") {
  CHECK(typeNamed("matrix") == Type::matrixTy);
  CHECK_FALSE(typeNamed("int"));
  CHECK(info(Type::matrixTy).components == 16);
  REQUIRE(globalNumbered(6));
  CHECK(globalNumbered(6)->name == "Ci");
  CHECK(globalNumbered(999) == nullptr);
  for (const GlobalVariableInfo &global : allGlobals())
    CHECK(info(global.type).components == global.components);
}
