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
class Shape {
public:
  /// Not yet reached by the analysis; joins with anything.
  Shape() = default;

  static Shape uniform() { return Shape(Kind::Strided, 0, true, true); }
  /// \p noSignedWrap and \p noUnsignedWrap say that base + k * stride is exact read as such a
  /// number, so that the stride survives an extension.
  static Shape strided(int64_t stride, bool noSignedWrap, bool noUnsignedWrap) {
    if (stride == 0)
      return uniform();
    return Shape(Kind::Strided, stride, noSignedWrap, noUnsignedWrap);
  }
  static Shape varying() { return Shape(Kind::Varying, 0, false, false); }

  bool isUnknown() const { return kind == Kind::Unknown; }
  bool isUniform() const { return kind == Kind::Strided && step == 0; }
  /// Uniform values are strided too.
  bool isStrided() const { return kind == Kind::Strided; }
  bool isVarying() const { return kind == Kind::Varying; }
  int64_t stride() const { return step; }
  bool noSignedWrap() const { return signedExact; }
  bool noUnsignedWrap() const { return unsignedExact; }

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
                 a.unsignedExact && b.unsignedExact);
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
  }

private:
  enum class Kind : uint8_t { Unknown, Strided, Varying };
  Shape(Kind kind, int64_t stride, bool signedExact, bool unsignedExact)
      : kind(kind), signedExact(signedExact), unsignedExact(unsignedExact), step(stride) {}

  Kind kind = Kind::Unknown;
  bool signedExact = false;
  bool unsignedExact = false;
  int64_t step = 0;
};

} // namespace anysl

#endif
