//===-- frontends/rsl/Type.h - the types of RSL -------------------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_TYPE_H
#define ANYSL_FRONTENDS_RSL_TYPE_H

#include "lib/STC/Types.h"
#include <string>

namespace anysl::rsl {

struct StructDecl;

enum class TypeKind : uint8_t {
  Error, ///< of an expression that was already reported
  Void,
  Bool, ///< of a comparison: no variable has this type
  Float,
  Color,
  Point,
  Vector,
  Normal,
  Matrix,
  String,
  Shader, ///< a co-shader's handle: its name, "" for null
  Struct  ///< which one: Type::structure
};

/// A type with its storage class: whether a value is the same for all points of a batch.
struct Type {
  static constexpr int NoArray = -1;
  static constexpr int AnyLength = 0; ///< a function's parameter `float x[]`

  TypeKind kind = TypeKind::Error;
  bool varying = false;
  int length = NoArray;
  const StructDecl *structure = nullptr;
  bool isResizable = false; ///< an array whose length changes; `length` is the room that it has

  bool is(TypeKind other) const { return kind == other && !isArray(); }
  bool isError() const { return kind == TypeKind::Error; }
  bool isArray() const { return length != NoArray; }
  bool isStruct() const { return is(TypeKind::Struct); }
  /// point, vector or normal
  bool isGeometric() const;
  /// color, point, vector or normal
  bool isTriple() const { return isGeometric() || is(TypeKind::Color); }
  /// float, matrix or a triple: what arithmetic is for
  bool isNumeric() const { return isTriple() || is(TypeKind::Float) || is(TypeKind::Matrix); }
  Type element() const { return {kind, varying, NoArray, structure}; }
  Type withVarying(bool is) const { return {kind, is, length, structure, isResizable}; }
};

/// As written in RSL: `color`, `float[3]`.
std::string toString(Type type);
llvm::StringRef nameOf(TypeKind kind);
/// The abstract type of STC; only for types that a variable may have.
stc::Type lowered(TypeKind kind);
TypeKind typeKindOf(stc::Type type);

/// What implicit conversion from one type to another costs, for choosing among overloads: 0 the
/// same, small numbers for changes of meaning (point to vector), larger ones for promotion.
/// Negative: there is none.
int conversionCost(Type from, Type to);

} // namespace anysl::rsl

#endif
