//===-- lib/STC/Ops.h - the operators of subroutine-threaded code -------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// StcOps.def as data: what every operator takes, gives, and may do.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STC_OPS_H
#define ANYSL_STC_OPS_H

#include "lib/STC/Effects.h"
#include "lib/STC/Types.h"
#include <string>

namespace llvm {
class Function;
class FunctionType;
class LLVMContext;
} // namespace llvm

namespace anysl::stc {

/// The operators by name: `Op::reflect`. The values are the stable identifiers.
enum class Op : uint16_t {
#define STC_OP(id, name, ...) name = id,
#include "lib/STC/StcOps.def"
};

enum class ResultKind : uint8_t { None, Test, Index, Slot };

/// The kinds of parameters that StcOps.def explains.
enum class ParamKind : uint8_t {
  In,
  Out,
  InOut,
  Array,
  Ctx,
  Type,
  Slot,
  Bool,
  Index,
  Length,
  Id,
  Number,
  Text
};

struct OpParam {
  ParamKind kind;
  /// Only for In, Out, InOut and Array.
  Type type = Type::floatTy;
  /// Only for arrays handed to a module's own functions; operators take `Array` and a length.
  unsigned arrayLength = 0;

  bool isValue() const { return kind <= ParamKind::Array; }
};

enum class Purity : uint8_t { Structural, Pure, Reads, Writes, Stateful };
enum class Rule : uint8_t { Propagate, Uniform, Varying };

/// A line of StcOps.def.
struct OpInfo {
  Op op;
  /// Without the prefix `anysl_`.
  llvm::StringLiteral name;
  ResultKind result;
  llvm::ArrayRef<OpParam> params;
  Purity purity;
  Rule rule;
  Effect effect;
  Service service;
  llvm::StringLiteral doc;

  unsigned id() const { return unsigned(op); }
  /// The name of the function that the operator is.
  std::string symbol() const { return std::string("anysl_") + name.str(); }
  bool takesContext() const;
};

/// Every operator, in the order of the table, which is the order of the identifiers.
llvm::ArrayRef<OpInfo> allOps();
const OpInfo &info(Op op);

/// What an operator's Id parameter numbers: an entry of Globals.def, a cell of the parameters, a
/// parameter, or an entry of QueryKinds.def. Nothing for an operator without Id.
enum class IdKind : uint8_t { Global, Cell, Param, Query };
std::optional<IdKind> idKind(const OpInfo &op);

/// A line of <anysl/QueryKinds.def>: what a shader may ask the renderer for by name.
struct QueryKind {
  unsigned id;
  llvm::StringLiteral name;
  bool varying; ///< answers differ from point to point
  llvm::StringLiteral doc;
};
llvm::ArrayRef<QueryKind> allQueryKinds();
/// Null if there is none.
const QueryKind *queryKindNamed(llvm::StringRef name);

/// The prefix of every operator's function.
inline constexpr llvm::StringLiteral opPrefix = "anysl_";
/// The operator of a name without prefix (`reflect`); null if there is none.
const OpInfo *opNamed(llvm::StringRef name);
/// The operator whose function is called `symbol` (`anysl_reflect`); null if there is none.
const OpInfo *opOfSymbol(llvm::StringRef symbol);

/// The LLVM type of a function with such parameters and result.
llvm::FunctionType *functionType(llvm::LLVMContext &context, ResultKind result,
                                 llvm::ArrayRef<OpParam> params);
llvm::FunctionType *functionType(llvm::LLVMContext &context, const OpInfo &op);

llvm::StringRef nameOf(ResultKind kind);
llvm::StringRef nameOf(ParamKind kind);
llvm::StringRef nameOf(Purity purity);
llvm::StringRef nameOf(Rule rule);
llvm::StringRef nameOf(Effect effect);
llvm::StringRef nameOf(Service service);
/// The table's own sentence about an effect or a service.
llvm::StringRef docOf(Effect effect);
llvm::StringRef docOf(Service service);

/// The parameter as the table writes it: `In(color)`, `Ctx`.
std::string toString(const OpParam &param);

} // namespace anysl::stc

#endif
