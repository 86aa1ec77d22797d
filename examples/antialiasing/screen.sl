// screen.sl: a net of wires; between them one sees through.
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
#include "edges.h"

surface screen(float frequency = 1, wire = 0.2;) {
  float hole = wave(s * frequency, 1 - wire) * wave(t * frequency, 1 - wire);
  Oi = 1 - hole;
  Ci = Oi * color(0.1, 0.12, 0.2);
}
