// versine.sl: one minus the cosine of a small angle.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The cosine of a small angle is so near to 1 that the difference is made of its last digits.

surface versine() {
  float x = 0.1 * s * t;
  Ci = 1 - cos(x);
}

surface stableversine() {
  float x = 0.1 * s * t;
  float half = sin(x / 2);
  Ci = 2 * half * half;
}
