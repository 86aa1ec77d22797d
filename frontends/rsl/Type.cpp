//===-- frontends/rsl/Type.cpp - the types of RSL ---------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "frontends/rsl/Type.h"

#include "frontends/rsl/Ast.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/ErrorHandling.h"

using namespace llvm;

namespace anysl::rsl {

bool Type::isGeometric() const {
  return !isArray() &&
         (kind == TypeKind::Point || kind == TypeKind::Vector || kind == TypeKind::Normal);
}

StringRef nameOf(TypeKind kind) {
  switch (kind) {
  case TypeKind::Error:
    return "error";
  case TypeKind::Void:
    return "void";
  case TypeKind::Bool:
    return "condition";
  case TypeKind::Float:
    return "float";
  case TypeKind::Color:
    return "color";
  case TypeKind::Point:
    return "point";
  case TypeKind::Vector:
    return "vector";
  case TypeKind::Normal:
    return "normal";
  case TypeKind::Matrix:
    return "matrix";
  case TypeKind::String:
    return "string";
  case TypeKind::Shader:
    return "shader";
  case TypeKind::Struct:
    return "struct";
  }
  llvm_unreachable("unknown type");
}

std::string toString(Type type) {
  std::string text = (type.structure ? type.structure->name : nameOf(type.kind)).str();
  if (type.isArray())
    text +=
        type.length == Type::AnyLength || type.isResizable ? "[]" : "[" + itostr(type.length) + "]";
  return text;
}

stc::Type lowered(TypeKind kind) {
  switch (kind) {
  case TypeKind::Float:
    return stc::Type::floatTy;
  case TypeKind::Color:
    return stc::Type::colorTy;
  case TypeKind::Point:
    return stc::Type::pointTy;
  case TypeKind::Vector:
    return stc::Type::vectorTy;
  case TypeKind::Normal:
    return stc::Type::normalTy;
  case TypeKind::Matrix:
    return stc::Type::matrixTy;
  case TypeKind::String:
  case TypeKind::Shader:
    return stc::Type::stringTy;
  case TypeKind::Error:
  case TypeKind::Void:
  case TypeKind::Bool:
  case TypeKind::Struct:
    break;
  }
  llvm_unreachable("no variable has this type");
}

TypeKind typeKindOf(stc::Type type) {
  switch (type) {
  case stc::Type::floatTy:
    return TypeKind::Float;
  case stc::Type::colorTy:
    return TypeKind::Color;
  case stc::Type::pointTy:
    return TypeKind::Point;
  case stc::Type::vectorTy:
    return TypeKind::Vector;
  case stc::Type::normalTy:
    return TypeKind::Normal;
  case stc::Type::matrixTy:
    return TypeKind::Matrix;
  case stc::Type::stringTy:
    return TypeKind::String;
  }
  llvm_unreachable("unknown type");
}

int conversionCost(Type from, Type to) {
  if (from.isError() || to.isError())
    return 0;
  if (from.isArray() || to.isArray()) {
    bool fits = from.isArray() && to.isArray() && from.kind == to.kind &&
                from.structure == to.structure &&
                (from.length == to.length || to.length == Type::AnyLength || from.isResizable ||
                 to.isResizable);
    // The right length is better than one that is known only when the shader runs.
    return !fits ? -1 : from.isResizable && to.length > 0 && !to.isResizable ? 1 : 0;
  }
  if (from.kind == to.kind)
    return from.structure == to.structure ? 0 : -1;
  if (from.isGeometric() && to.isGeometric())
    return 1;
  if (from.isTriple() && to.isTriple())
    return 4;
  bool isScalar = from.is(TypeKind::Float) || from.is(TypeKind::Bool);
  if (from.is(TypeKind::Bool) && to.is(TypeKind::Float))
    return 2;
  if (isScalar && to.isTriple())
    return 8;
  if (isScalar && to.is(TypeKind::Matrix))
    return 16;
  return -1;
}

} // namespace anysl::rsl
