// function.sl: one function at eight arguments, each after the other.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// FUNCTION is an expression of x and y, floats from 0.1 to 0.9, of and of V and W, vectors.

float reflected(vector I, N; float eta) {
  float Kr, Kt;
  fresnel(I, N, eta, Kr, Kt);
  return Kr;
}

surface function() {
  float i, sum = 0.1;
  for (i = 0; i < 8; i += 1) {
    float x = 0.1 + 0.4 * s + 0.04 * i, y = 0.2 + 0.5 * t + 0.01 * i;
    vector V = vector(x - 0.5, y, 1 - x), W = vector(y, 0.3 - x, 0.5);
    sum += FUNCTION;
  }
  Ci = sum;
}
