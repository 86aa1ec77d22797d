//===-- passes/Vectorize/VectorAbi.h - names and signatures of vector variants ------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The x86 vector function ABI (sourceware.org/glibc/wiki/libmvec, as GCC implements it): how a
// variant is named, which type each of its arguments has, and how lanes are packed into those
// arguments.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_VECTORABI_H
#define ANYSL_PASSES_VECTORIZE_VECTORABI_H

#include "llvm/IR/IRBuilder.h"

#include <optional>
#include <string>

namespace anysl {

/// The instruction set that a variant's name promises its caller.
enum class Isa { Sse, Avx, Avx2, Avx512, Llvm };

struct VariantParam {
  enum class Kind {
    Vector,       ///< v: one value per lane
    Uniform,      ///< u: one value for all lanes
    Linear,       ///< l, R: lane k has the value of lane 0 plus k * step
    LinearByParam ///< ls, Rs: the same, with the step in parameter number `step`
  };
  Kind kind = Kind::Vector;
  int64_t step = 0;  ///< in bytes for pointers
  llvm::Align align; ///< of what a pointer points to, in lane 0 of a linear one
};

/// What a name such as _ZGVdM8uul_f or _ZGV_LLVM_N8v_f(f_x8) says.
struct VariantName {
  Isa isa;
  bool masked;
  unsigned width;
  llvm::SmallVector<VariantParam, 8> params; ///< of the scalar function, without the mask
  std::string scalarName;
  std::string functionName; ///< of the variant
};

/// Nothing if the text is no such name, or one for another architecture or a scalable vector.
std::optional<VariantName> parseVariantName(llvm::StringRef text);

/// All variant names among a function's or call's attributes.
llvm::SmallVector<VariantName, 4> variantNames(llvm::AttributeList attributes);

/// The type of W lanes of \p type: a vector for a scalar, and for a structure, array or vector the
/// structure or array of its widened elements. i1 stays i1.
llvm::Type *widenedType(llvm::Type *type, unsigned width);

/// A variant's signature, and the packing of widened values into its arguments.
class VariantSignature {
public:
  /// \p scalar is the function that the variant belongs to. Nothing where the name does not fit it;
  /// then \p why says so.
  static std::optional<VariantSignature> get(const VariantName &name, llvm::FunctionType *scalar,
                                             const llvm::DataLayout &layout, std::string &why);
  /// The same, for a variant that is given with a type of its own (a mask in another form, vectors
  /// by reference).
  static std::optional<VariantSignature> getFor(const VariantName &name, llvm::FunctionType *scalar,
                                                const llvm::Function &variant, std::string &why);

  llvm::FunctionType *type() const { return functionType; }
  /// Adds the attributes that passing needs (sret).
  void addAttributes(llvm::Function &function) const;

  /// In a variant's entry block: the widened value of each scalar parameter that is a Vector; for
  /// the others the argument as it is; last, if masked, the mask as <W x i1>.
  llvm::SmallVector<llvm::Value *, 8> unpackArguments(llvm::IRBuilder<> &builder,
                                                      llvm::Function &variant) const;
  /// Emits the return of a widened value (null for void).
  void packReturn(llvm::IRBuilder<> &builder, llvm::Function &variant, llvm::Value *value) const;

  /// Calls a variant with the arguments that unpackArguments would give back; returns the widened
  /// result.
  llvm::CallInst *call(llvm::IRBuilder<> &builder, llvm::FunctionCallee variant,
                       llvm::ArrayRef<llvm::Value *> arguments, llvm::Value *&result) const;

private:
  enum class Form { Direct, Pieces, ByReference, IntegerMask };
  struct Slot {
    Form form = Form::Direct;
    llvm::Type *type = nullptr;    ///< the widened type inside (Direct, ByReference: of the whole)
    llvm::Type *element = nullptr; ///< of a piece; an i1 travels as an i8
    unsigned pieces = 1;           ///< number of arguments
    unsigned lanesPerPiece = 0;
  };

  llvm::Value *unpack(llvm::IRBuilder<> &builder, const Slot &slot,
                      llvm::ArrayRef<llvm::Value *> pieces, bool isMask) const;
  void pack(llvm::IRBuilder<> &builder, const Slot &slot, llvm::Value *value, bool isMask,
            llvm::SmallVectorImpl<llvm::Value *> &pieces) const;
  Slot vectorSlot(Isa isa, llvm::Type *type) const;

  unsigned width = 0;
  bool masked = false;
  bool returnsByReference = false;
  Slot result;
  llvm::SmallVector<Slot, 8> slots; ///< of the parameters, then of the mask
  llvm::FunctionType *functionType = nullptr;
  llvm::FunctionType *scalarType = nullptr;
};

/// The instruction set extensions that code under an ABI letter may use, as LLVM spells them
/// ("+avx2,+fma"); nothing for _LLVM_.
llvm::StringRef featuresOf(Isa isa);

/// The size of a vector register under an ABI letter; 0 for _LLVM_.
unsigned registerBits(Isa isa, bool forFloats);

} // namespace anysl

#endif
