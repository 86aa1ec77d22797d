//===-- test/unit/rsl/Types.cpp - conversions between the types of RSL ------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Sema.h"
#include <catch2/catch.hpp>

using namespace anysl::rsl;

static Type type(TypeKind kind, int length = Type::NoArray) { return {kind, false, length}; }

TEST_CASE("implicit conversions and their order") {
  auto cost = [](TypeKind from, TypeKind to) { return conversionCost(type(from), type(to)); };
  CHECK(cost(TypeKind::Float, TypeKind::Float) == 0);
  CHECK(cost(TypeKind::Point, TypeKind::Vector) > 0);
  CHECK(cost(TypeKind::Point, TypeKind::Vector) < cost(TypeKind::Point, TypeKind::Color));
  CHECK(cost(TypeKind::Point, TypeKind::Color) < cost(TypeKind::Float, TypeKind::Color));
  CHECK(cost(TypeKind::Float, TypeKind::Color) < cost(TypeKind::Float, TypeKind::Matrix));
  CHECK(cost(TypeKind::Color, TypeKind::Float) < 0);
  CHECK(cost(TypeKind::String, TypeKind::Float) < 0);
  CHECK(cost(TypeKind::Float, TypeKind::String) < 0);
  CHECK(cost(TypeKind::Matrix, TypeKind::Color) < 0);
  CHECK(cost(TypeKind::Void, TypeKind::Float) < 0);
}

TEST_CASE("arrays convert to arrays of their kind and length") {
  CHECK(conversionCost(type(TypeKind::Float, 3), type(TypeKind::Float, 3)) == 0);
  CHECK(conversionCost(type(TypeKind::Float, 3), type(TypeKind::Float, Type::AnyLength)) == 0);
  CHECK(conversionCost(type(TypeKind::Float, 3), type(TypeKind::Float, 4)) < 0);
  CHECK(conversionCost(type(TypeKind::Float, 3), type(TypeKind::Color, 3)) < 0);
  CHECK(conversionCost(type(TypeKind::Float, 3), type(TypeKind::Float)) < 0);
  CHECK(conversionCost(type(TypeKind::Float), type(TypeKind::Float, 3)) < 0);
}

TEST_CASE("the type of arithmetic") {
  auto combined = [](BinaryOp op, TypeKind a, TypeKind b) {
    TypeKind kind = combinedKind(op, type(a), type(b));
    if (op != BinaryOp::Subtract || a == b) // symmetric but for names of differences
      CHECK(combinedKind(op, type(b), type(a)) == kind);
    return kind;
  };
  CHECK(combined(BinaryOp::Add, TypeKind::Float, TypeKind::Float) == TypeKind::Float);
  CHECK(combined(BinaryOp::Multiply, TypeKind::Float, TypeKind::Color) == TypeKind::Color);
  CHECK(combined(BinaryOp::Add, TypeKind::Point, TypeKind::Vector) == TypeKind::Point);
  CHECK(combined(BinaryOp::Add, TypeKind::Normal, TypeKind::Vector) == TypeKind::Vector);
  CHECK(combined(BinaryOp::Subtract, TypeKind::Point, TypeKind::Point) == TypeKind::Vector);
  CHECK(combined(BinaryOp::Multiply, TypeKind::Color, TypeKind::Vector) == TypeKind::Color);
  CHECK(combined(BinaryOp::Divide, TypeKind::Matrix, TypeKind::Float) == TypeKind::Matrix);
  CHECK(combined(BinaryOp::Multiply, TypeKind::Matrix, TypeKind::Point) == TypeKind::Error);
  CHECK(combined(BinaryOp::Add, TypeKind::String, TypeKind::String) == TypeKind::Error);
}

TEST_CASE("types as text") {
  CHECK(toString(type(TypeKind::Color)) == "color");
  CHECK(toString(type(TypeKind::Float, 3)) == "float[3]");
  CHECK(toString(type(TypeKind::Float, Type::AnyLength)) == "float[]");
}
