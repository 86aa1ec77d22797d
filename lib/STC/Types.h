//===-- lib/STC/Types.h - the abstract types of subroutine-threaded code ------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The types of Types.def, the storage classes, and the facts about slots that the builder, the
// verifier and the linker all need.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STC_TYPES_H
#define ANYSL_STC_TYPES_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"
#include <cstdint>
#include <optional>

namespace llvm {
class Value;
} // namespace llvm

namespace anysl::stc {

/// The abstract types: `Type::floatTy`, `Type::colorTy` and so on.
enum class Type : uint8_t {
#define STC_TYPE(id, name, components, doc) name##Ty = id,
#include "lib/STC/Types.def"
};

/// A line of Types.def.
struct TypeInfo {
  Type type;
  llvm::StringLiteral name;
  /// Real numbers in a value, which is also the number of parameter cells that it takes.
  unsigned components;
  llvm::StringLiteral doc;
};

llvm::ArrayRef<TypeInfo> allTypes();
const TypeInfo &info(Type type);
/// The type of a name such as `color`; nothing for any other text.
std::optional<Type> typeNamed(llvm::StringRef name);

/// Whether a value of one type may stand where the other is asked for: the types are equal or
/// both geometric. Points, vectors and normals differ in how they transform, not in what they are.
bool sameRepresentation(Type a, Type b);

/// The prefix of the symbols whose addresses name types in STC.
inline constexpr llvm::StringLiteral typeSymbolPrefix = "anysl_type_";
/// The type whose symbol `value` is; nothing for any other value.
std::optional<Type> typeOfSymbol(const llvm::Value *value);

/// How a variable may differ between the points of a batch.
enum class Storage : uint8_t { Varying, Uniform };
llvm::StringRef nameOf(Storage storage);

/// What a pointer operand designates.
struct SlotInfo {
  Type type;
  /// The number of consecutive values; 0 for a single value that is not an array.
  unsigned arrayLength = 0;
};

/// What `value` designates: the result of anysl_alloc, anysl_alloc_array or anysl_element, or an
/// argument that its function's signature declares to be a value. Nothing for any other value.
std::optional<SlotInfo> slotInfo(const llvm::Value *value);

} // namespace anysl::stc

#endif
