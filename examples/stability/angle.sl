// angle.sl: the angle between two directions.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The arc cosine is steep at 1: an error in the last digit of the product becomes a large one of the angle. The
// lengths of sum and difference have the tangent of half of it (W. Kahan, "How Futile are Mindless Assessments of
// Roundoff in Floating-Point Computation?", 2006, section 12).

surface angle() {
  vector a = normalize(N), b = normalize(N + 0.01 * s * vector(1, 0, 0));
  Ci = acos(a . b);
}

surface stableangle() {
  vector a = normalize(N), b = normalize(N + 0.01 * s * vector(1, 0, 0));
  Ci = 2 * atan(length(a - b), length(a + b));
}
