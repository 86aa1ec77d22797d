//===-- passes/Vectorize/Shape.h - how a value differs from lane to lane ------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_PASSES_VECTORIZE_SHAPE_H
#define ANYSL_PASSES_VECTORIZE_SHAPE_H

#include "llvm/Support/raw_ostream.h"

namespace anysl {

/// A value's shape: lane k has the value of lane 0 plus k times a constant stride (0: uniform), or
/// nothing is known. Pointers stride in bytes. Statements hold for active lanes; whatever an idle
/// lane holds is never looked at.
///
/// With a stride comes an alignment: the value of lane 0, be it idle, is a multiple of a power of
/// two if any lane is active.
class Shape {
public:
  /// Not yet reached by the analysis; joins with anything.
  Shape() = default;

  static Shape uniform() { return Shape(Kind::Strided, 0, true, true, 0); }
  /// \p noSignedWrap and \p noUnsignedWrap say that base + k * stride is exact read as such a
  /// number, so that the stride survives an extension.
  static Shape strided(int64_t stride, bool noSignedWrap, bool noUnsignedWrap) {
    if (stride == 0)
      return uniform();
    return Shape(Kind::Strided, stride, noSignedWrap, noUnsignedWrap, 0);
  }
  static Shape varying() { return Shape(Kind::Varying, 0, false, false, 0); }
  /// The same, where lane 0's value is a multiple of 2 to the power of \p zeros.
  Shape aligned(unsigned zeros) const {
    Shape result = *this;
    if (isStrided())
      result.zeroBits = std::min(zeros, mostZeros);
    return result;
  }

  bool isUnknown() const { return kind == Kind::Unknown; }
  bool isUniform() const { return kind == Kind::Strided && step == 0; }
  /// Uniform values are strided too.
  bool isStrided() const { return kind == Kind::Strided; }
  bool isVarying() const { return kind == Kind::Varying; }
  int64_t stride() const { return step; }
  bool noSignedWrap() const { return signedExact; }
  bool noUnsignedWrap() const { return unsignedExact; }
  /// How many of the low bits of lane 0's value are known to be zero.
  unsigned zeros() const { return zeroBits; }
  static constexpr unsigned mostZeros = 12; // a page

  friend bool operator==(const Shape &, const Shape &) = default;

  /// The shape of a value that is one or the other, the same for all lanes.
  static Shape join(const Shape &a, const Shape &b) {
    if (a.isUnknown())
      return b;
    if (b.isUnknown())
      return a;
    if (a.isVarying() || b.isVarying() || a.step != b.step)
      return varying();
    return Shape(Kind::Strided, a.step, a.signedExact && b.signedExact,
                 a.unsignedExact && b.unsignedExact, std::min(a.zeroBits, b.zeroBits));
  }

  void print(llvm::raw_ostream &out) const {
    if (isUnknown())
      out << "unreached";
    else if (isVarying())
      out << "varying";
    else if (isUniform())
      out << "uniform";
    else
      out << "stride " << step;
    if (isStrided() && zeroBits)
      out << ", aligned to " << (uint64_t(1) << zeroBits);
  }

private:
  enum class Kind : uint8_t { Unknown, Strided, Varying };
  Shape(Kind kind, int64_t stride, bool signedExact, bool unsignedExact, unsigned zeros)
      : kind(kind), signedExact(signedExact), unsignedExact(unsignedExact), zeroBits(zeros),
        step(stride) {}

  Kind kind = Kind::Unknown;
  bool signedExact = false;
  bool unsignedExact = false;
  uint8_t zeroBits = 0;
  int64_t step = 0;
};

} // namespace anysl

#endif
