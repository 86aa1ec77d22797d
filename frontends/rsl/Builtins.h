//===-- frontends/rsl/Builtins.h - the built-in functions of RSL --------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_FRONTENDS_RSL_BUILTINS_H
#define ANYSL_FRONTENDS_RSL_BUILTINS_H

#include "frontends/rsl/Type.h"
#include "lib/STC/Ops.h"
#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/SmallVector.h"
#include <vector>

namespace anysl::rsl {

/// Where an operand of the operator comes from, as Builtins.def explains.
struct BuiltinOperand {
  enum Source : uint8_t {
    In,
    Out,
    InOut,
    Global,
    Number,
    Text,
    Discard,
    Light,
    SpaceTo,
    SpaceFromTo,
    SpaceThenMatrix,
    Named
  };
  Source source = In;
  TypeKind type = TypeKind::Float; ///< In, Out, InOut, Named
  int global = -1;                 ///< Global: as in Globals.def
  double number = 0;               ///< Number; Named: the default
  unsigned field = 0;              ///< Named: number of the field in its group
  llvm::StringRef text;            ///< Text

  /// How many arguments of the call it takes.
  unsigned argumentCount() const {
    return source <= InOut || source == SpaceTo                 ? 1
           : source == SpaceFromTo || source == SpaceThenMatrix ? 2
                                                                : 0;
  }
};

/// A group of NamedArguments.def: what calls take behind their other arguments as "name", value.
struct NamedGroup {
  struct Field {
    llvm::StringRef name;
    TypeKind type;
    double number;          ///< the default; of a string it is ""
    bool isForRays = false; ///< no operand: for a lookup that is traced
  };
  struct Argument {
    llvm::StringRef name;
    TypeKind type;
    llvm::SmallVector<unsigned, 2> fields; ///< that it sets
    llvm::StringRef meaning;
    bool isDeclined = false; ///< it would change the result, and a call gets a warning
  };
  llvm::StringRef name;
  llvm::SmallVector<Field, 10> fields;
  llvm::SmallVector<Argument, 20> arguments;

  const Argument *argumentNamed(llvm::StringRef name) const;
};

/// Every group, in the table's order.
llvm::ArrayRef<NamedGroup> namedGroups();

/// One overload of a built-in.
struct Builtin {
  llvm::StringRef name;
  TypeKind result;
  llvm::SmallVector<BuiltinOperand, 8> operands;
  stc::Op op;
  llvm::StringRef meaning;

  struct Argument {
    TypeKind type;
    bool isIn, isOut;
  };
  /// The arguments of a call, in order.
  llvm::SmallVector<Argument, 8> arguments;
  const NamedGroup *named = nullptr; ///< the arguments by name that it takes; null: none
  bool takesRest = false;            ///< any further arguments, which mean nothing to it
};

/// Every overload, in the table's order.
llvm::ArrayRef<Builtin> allBuiltins();
/// The overloads of a name; empty if it is no built-in.
llvm::ArrayRef<const Builtin *> builtinsNamed(llvm::StringRef name);
/// Each name once.
llvm::ArrayRef<llvm::StringRef> builtinNames();
/// What a query or a built-in without a fixed list of arguments gives; Error if that depends on the
/// arguments, or for any other name.
TypeKind specialResult(llvm::StringRef name);
/// What a built-in of RSL that this compiler does not have would need; empty for any other name.
llvm::StringRef missingFor(llvm::StringRef name);
/// `color mix(color, color, float)`
std::string signature(const Builtin &builtin);

} // namespace anysl::rsl

#endif
