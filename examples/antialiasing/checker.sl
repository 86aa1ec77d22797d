// checker.sl: squares.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Two square waves of -1 and 1; their product tells the colours apart, and its average is the product of their averages.

#include "edges.h"

surface checker(float frequency = 1; color light = 0.9, dark = 0.05;) {
  float across = 2 * wave(s * frequency / 2, 0.5) - 1;
  float along = 2 * wave(t * frequency / 2, 0.5) - 1;
  Oi = Os;
  Ci = Oi * mix(dark, light, 0.5 + 0.5 * across * along);
}
