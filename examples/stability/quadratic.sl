// quadratic.sl: the smaller root of x^2 - b x + c = 0.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Where b is large beside c, its square root is nearly b, and the difference keeps few of their digits. The product of
// both roots is c, which gives the smaller one without a difference.

surface quadratic(float scale = 1e4) {
  float b = scale * (0.1 + s), c = 0.1 + t;
  Ci = (b - sqrt(b * b - 4 * c)) / 2;
}

surface stablequadratic(float scale = 1e4) {
  float b = scale * (0.1 + s), c = 0.1 + t;
  Ci = 2 * c / (b + sqrt(b * b - 4 * c));
}
