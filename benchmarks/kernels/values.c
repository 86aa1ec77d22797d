//===-- benchmarks/kernels/values.c - kernels about functions and local arrays ----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Kernels.h"

/// One of each elementary function, arguments as shaders have them.
KERNEL(elementary) {
  float x = points->px[i], y = points->py[i], z = points->pz[i], r = points->random[i];
  float waves = MATH(sinf)(x) * MATH(cosf)(y);
  float falloff = MATH(expf)(-fabsf(z)) + MATH(logf)(r + 0.01f);
  float lobe = MATH(powf)(r, 1 + fabsf(x));
  points->out0[i] = waves + falloff;
  points->out1[i] = lobe * MATH(atan2f)(y, x);
}

/// The median and the trimmed mean of nine samples, which are sorted in a local array.
KERNEL(median) {
  float samples[9];
  float seed = points->random[i] + 0.1f;
  for (int k = 0; k < 9; ++k) {
    float sample = seed * (17.13f + 3.71f * (float)k);
    sample -= floorf(sample);
    int place = k;
    while (place > 0 && samples[place - 1] > sample) {
      samples[place] = samples[place - 1];
      --place;
    }
    samples[place] = sample;
  }
  float sum = 0;
  for (int k = 2; k < 7; ++k)
    sum += samples[k];
  points->out0[i] = samples[4];
  points->out1[i] = 0.2f * sum;
}
