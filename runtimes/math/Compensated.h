//===-- runtimes/math/Compensated.h - float functions within 1 ULP, evaluated in float --------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Exponentials and logarithms are sums in which one term is large and known exactly; the rest may
// then carry the few roundings that float evaluation brings. That takes half the time of double,
// and no fused multiply-add.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIMES_MATH_COMPENSATED_H
#define ANYSL_RUNTIMES_MATH_COMPENSATED_H

#include "runtimes/math/Coefficients.h"
#include "runtimes/math/Core.h"
#include "runtimes/math/Special.h"

namespace anysl::tier {

/// x without the lower half of its significand.
ANYSL_TIER float upperBits(float x) { return fromBits(bitsOf(x) & 0xfffff000u); }

/// The sum high + low as 1 + high + high²·P + low, times 2^n.
ANYSL_TIER float expCompensated(float high, float low, UInt32 bits) {
  float tail = high * high * horner(ExpFloat, high) + low;
  return scaleBy(1 + (high + tail), bits);
}

ANYSL_TIER float expInFloatOnly(float x) {
  x = clampKeepNaN(x, -110.0f, 95.0f);
  float t = x * 0x1.715476p+0f + RoundShiftF;
  float n = t - RoundShiftF;
  // n·high is exact: high has 15 bits.
  float a = x - n * 0x1.62e4p-1f, b = n * 0x1.7f7d1cp-20f;
  float r = a - b;
  return expCompensated(r, (a - r) - b, bitsOf(t));
}

ANYSL_TIER float exp2InFloatOnly(float x) {
  x = clampKeepNaN(x, -160.0f, 140.0f);
  float t = x + RoundShiftF;
  float f = x - (t - RoundShiftF);
  // f·log 2 as a sum, from parts of 12 bits.
  float fh = upperBits(f), fl = f - fh;
  float a = fh * 0x1.62ep-1f, b = fl * 0x1.62ep-1f + f * 0x1.0bfbe8p-15f;
  float r = a + b;
  return expCompensated(r, (a - r) + b, bitsOf(t));
}

/// A positive finite x as (1 + f)·2^n, 1 + f in [sqrt 1/2, sqrt 2).
struct DecomposedF {
  float f, n;
};
ANYSL_TIER DecomposedF decomposeF(float x) {
  constexpr UInt32 lowest = 0x3f3504f3, one = 0x3f800000;
  bool tiny = x < 0x1p-126f;
  UInt32 bits = bitsOf(tiny ? x * 0x1p23f : x);
  UInt32 shifted = bits - lowest + one;
  float m = fromBits(bits - (shifted & 0xff800000u) + one);
  return {m - 1, float(Int32(shifted >> 23) - (tiny ? 127 + 23 : 127))};
}

/// log(1+f) = f + this; only the rounding of f² counts.
ANYSL_TIER float logTail(float f) {
  float square = f * f;
  return square * (f * horner(LogFloat, f)) - 0.5f * square;
}

ANYSL_TIER float logInFloatOnly(float x) {
  DecomposedF d = decomposeF(x);
  float y = d.n * 0x1.62e4p-1f + (d.f + (logTail(d.f) + d.n * 0x1.7f7d1cp-20f));
  return isPositiveFinite(x) ? y : logSpecial(x);
}

/// n·unit + log(1+f)·(high + low). The logarithm is kept as a sum, of whose larger part the upper
/// 12 bits are multiplied exactly by the 12 bits of `high`.
template <class Base>
ANYSL_TIER float logScaled(float x, Base) {
  DecomposedF d = decomposeF(x);
  float tail = logTail(d.f);
  float l = d.f + tail;
  tail = (d.f - l) + tail;
  float upper = upperBits(l), lower = (l - upper) + tail;
  float rest = lower * Base::high + l * Base::low + d.n * Base::unitLow;
  float a = d.n * Base::unitHigh, b = upper * Base::high, sum = a + b;
  float y = sum + (((a - sum) + b) + rest);
  return isPositiveFinite(x) ? y : logSpecial(x);
}
struct Base2 {
  static constexpr float high = 0x1.716p+0f, low = -0x1.7135a8p-13f, unitHigh = 1, unitLow = 0;
};
struct Base10 {
  static constexpr float high = 0x1.bccp-2f, low = -0x1.09d5b2p-15f, unitHigh = 0x1.344p-2f,
                         unitLow = 0x1.3509f8p-18f;
};

} // namespace anysl::tier

#endif // ANYSL_RUNTIMES_MATH_COMPENSATED_H
