//===-- benchmarks/kernels/patterns.c - kernels that make patterns ----------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Kernels.h"

/// A wall of bricks: every second row is shifted, mortar lies between, each brick has a tint and a
/// lit upper edge.
KERNEL(brick) {
  float s = 9.7f * points->u[i], t = 19.3f * points->v[i];
  float row = floorf(t);
  float half = 0.5f * row;
  if (half - floorf(half) > 0.25f)
    s += 0.5f;
  float column = floorf(s);
  s -= column;
  t -= row;
  float red, green, blue;
  if (s < 0.06f || t < 0.12f) {
    float grain = 0.75f + 0.1f * points->random[i];
    red = green = blue = grain;
  } else {
    unsigned seed = (unsigned)(int)column * 0x9e3779b1u ^ (unsigned)(int)row * 0x85ebca77u;
    seed ^= seed >> 15;
    seed *= 0x2c1b3c6du;
    float tint = 0.8f + (float)(int)(seed >> 8) * (0.2f / 16777216);
    if (t > 0.85f)
      tint += (t - 0.85f) * 0.8f;
    red = 0.7f * tint;
    green = 0.25f * tint;
    blue = 0.15f * tint * tint;
  }
  points->out0[i] = red;
  points->out1[i] = green;
  points->out2[i] = blue;
}

static inline float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }
static inline float mix(float a, float b, float t) { return a + t * (b - a); }

/// The product of (x, y, z) with one of the gradients of Perlin's improved noise, chosen by four
/// bits.
static inline float gradient(int hash, float x, float y, float z) {
  int h = hash & 15;
  float a = h < 8 ? x : y;
  float b = h < 4 ? y : h == 12 || h == 14 ? x : z;
  return ((h & 1) ? -a : a) + ((h & 2) ? -b : b);
}

/// Perlin's improved noise (Improving Noise, SIGGRAPH 2002).
static inline float noise(const int *table, float x, float y, float z) {
  float fx = floorf(x), fy = floorf(y), fz = floorf(z);
  int cx = (int)fx, cy = (int)fy, cz = (int)fz;
  x -= fx, y -= fy, z -= fz;
  float u = fade(x), v = fade(y), w = fade(z);
  int a = table[cx & 255], b = table[(cx + 1) & 255];
  int aa = table[(a + cy) & 255], ab = table[(a + cy + 1) & 255];
  int ba = table[(b + cy) & 255], bb = table[(b + cy + 1) & 255];
  float near = mix(mix(gradient(table[(aa + cz) & 255], x, y, z),
                       gradient(table[(ba + cz) & 255], x - 1, y, z), u),
                   mix(gradient(table[(ab + cz) & 255], x, y - 1, z),
                       gradient(table[(bb + cz) & 255], x - 1, y - 1, z), u),
                   v);
  float far = mix(mix(gradient(table[(aa + cz + 1) & 255], x, y, z - 1),
                      gradient(table[(ba + cz + 1) & 255], x - 1, y, z - 1), u),
                  mix(gradient(table[(ab + cz + 1) & 255], x, y - 1, z - 1),
                      gradient(table[(bb + cz + 1) & 255], x - 1, y - 1, z - 1), u),
                  v);
  return mix(near, far, w);
}

/// Four octaves of noise.
KERNEL(turbulence) {
  const int *table = points->permutation;
  float x = points->px[i], y = points->py[i], z = points->pz[i];
  float sum = 0, amplitude = 0.5f;
  for (int octave = 0; octave < 4; ++octave) {
    sum += amplitude * noise(table, x, y, z);
    amplitude *= 0.5f;
    x *= 2, y *= 2, z *= 2;
  }
  points->out0[i] = sum;
}

static inline unsigned hashCell(int x, int y) {
  unsigned h = (unsigned)x * 0x8da6b343u ^ (unsigned)y * 0xd8163841u;
  h ^= h >> 13;
  h *= 0x5bd1e995u;
  return h ^ (h >> 15);
}

/// How much nearer the nearest than the second nearest of points strewn over cells is (Worley,
/// SIGGRAPH 1996).
KERNEL(cells) {
  float x = 12 * points->u[i], y = 12 * points->v[i];
  float fx = floorf(x), fy = floorf(y);
  int cx = (int)fx, cy = (int)fy;
  x -= fx, y -= fy;
  float first = 8, second = 8;
  for (int row = -1; row <= 1; ++row)
    for (int column = -1; column <= 1; ++column) {
      unsigned h = hashCell(cx + column, cy + row);
      float dx = (float)column + (float)(int)(h & 0xffff) * (1 / 65536.0f) - x;
      float dy = (float)row + (float)(int)(h >> 16) * (1 / 65536.0f) - y;
      float square = dx * dx + dy * dy;
      if (square < first) {
        second = first;
        first = square;
      } else if (square < second) {
        second = square;
      }
    }
  points->out0[i] = sqrtf(second) - sqrtf(first);
}

/// A texture of 64 × 64 texels, repeated, looked up between four of them.
KERNEL(texture) {
  float s = 37 * points->px[i], t = 29 * points->py[i];
  float fs = floorf(s), ft = floorf(t);
  int column = (int)fs, row = (int)ft;
  s -= fs, t -= ft;
  const float *image = points->image;
  int left = column & 63, right = (column + 1) & 63;
  int upper = (row & 63) * 64, lower = ((row + 1) & 63) * 64;
  float above = mix(image[upper + left], image[upper + right], s);
  float below = mix(image[lower + left], image[lower + right], s);
  points->out0[i] = mix(above, below, t);
}
