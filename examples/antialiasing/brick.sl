// brick.sl: bricks in running bond, each with a shade of its own.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// The mortar is what two waves leave over. The shade of each brick, noise by its number, fades to its mean where bricks are smaller than
// pixels.

#include "edges.h"

surface brick(float frequency = 1, gap = 0.12; color clay = color(0.6, 0.18, 0.1), mortar = color(0.75, 0.72, 0.66);) {
  float row = floor(t * frequency * 2);
  float along = s * frequency + 0.5 * mod(row, 2);
  float inside = wave(along, 1 - gap / 2) * wave(t * frequency * 2, 1 - gap);
  float shade = (cellnoise(along, row) - 0.5) * detail(along) * detail(t * frequency * 2);
  Oi = Os;
  Ci = Oi * mix(mortar, clay * (1 + shade), inside);
}
