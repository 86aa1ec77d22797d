//===-- benchmarks/kernels/loops.c - kernels whose loops end when the data says ---------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Kernels.h"

/// The Mandelbrot set: after how many steps a point leaves the circle of radius 2.
KERNEL(mandelbrot) {
  float cr = -2.1f + 2.8f * points->u[i], ci = -1.3f + 2.6f * points->v[i];
  float zr = cr, zi = ci;
  int steps = 0;
  while (steps < 256) {
    float rr = zr * zr, ii = zi * zi;
    if (rr + ii > 4)
      break;
    zi = 2 * zr * zi + ci;
    zr = rr - ii + cr;
    ++steps;
  }
  points->out0[i] = (float)steps;
}

/// Sphere tracing (Hart 1996): a ray steps on by the distance to a torus and a plane, until it hits
/// one or is far off.
KERNEL(march) {
  float px = points->u[i] * 6 - 3, py = points->v[i] * 4 + 0.1f, pz = -4;
  float dx = points->nx[i] * 0.2f, dy = points->ny[i] * 0.2f - 0.25f, dz = 1;
  float t = 0;
  int steps = 0;
  while (t < 20) {
    float x = px + t * dx, y = py + t * dy, z = pz + t * dz;
    float ring = sqrtf(x * x + z * z) - 1.5f;
    float height = y - 1;
    float torus = sqrtf(ring * ring + height * height) - 0.5f;
    float distance = torus < y ? torus : y;
    if (distance < 1e-3f || ++steps > 100)
      break;
    t += 0.7f * distance;
  }
  points->out0[i] = t;
  points->out1[i] = (float)steps;
}

/// A small machine that each point drives with random numbers of its own.
KERNEL(automaton) {
  unsigned state = (unsigned)(int)(points->random[i] * 16777216) * 747796405u + 2891336453u;
  int total = 0;
  float value = 1;
  for (int round = 0; round < 24; ++round) {
    int count = 1 + (int)(state >> 27);
    for (int k = 0; k < count; ++k) {
      state = state * 1664525u + 1013904223u;
      switch (state >> 29) {
      case 0:
        if (state & 0x10000)
          continue;
        total += k;
        break;
      case 1:
      case 2:
        total ^= (int)(state >> 20 & 255);
        break;
      case 3:
        value = value * 0.5f + (float)k;
        break;
      case 4:
        value += (float)(total & 15);
        if (value > 40)
          value -= 40;
        break;
      default:
        total += round;
      }
      if (total > 900) {
        total -= 900;
        break;
      }
    }
    if (value > 39.5f)
      break;
  }
  points->out0[i] = value;
  points->out1[i] = (float)total;
}
