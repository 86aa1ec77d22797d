//===-- benchmarks/kernels/lighting.c - kernels that shade ------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "Kernels.h"

/// Light reflected by a polished dielectric from one direction: Phong's lobe times Schlick's
/// approximation of the Fresnel term.
KERNEL(specular) {
  const float lx = 0.48f, ly = 0.6f, lz = 0.64f;
  float ix = points->ix[i], iy = points->iy[i], iz = points->iz[i];
  float nx = points->nx[i], ny = points->ny[i], nz = points->nz[i];
  float d = ix * nx + iy * ny + iz * nz;
  float twice = 2 * d;
  float rx = ix - twice * nx, ry = iy - twice * ny, rz = iz - twice * nz;
  float c = rx * lx + ry * ly + rz * lz;
  c = c > 0 ? c : 0;
  float highlight = MATH(powf)(c, 8 + 24 * points->random[i]);
  float m = 1 - fabsf(d);
  float m2 = m * m;
  float fresnel = 0.04f + 0.96f * (m2 * m2 * m);
  points->out0[i] = highlight * fresnel;
}

/// What a dielectric of index 1.5 sends on: the refracted direction, or beyond the critical angle
/// the reflected one; and how much of the light the unpolarised Fresnel equations reflect.
KERNEL(glass) {
  float ix = points->ix[i], iy = points->iy[i], iz = points->iz[i];
  float nx = points->nx[i], ny = points->ny[i], nz = points->nz[i];
  float c = -(ix * nx + iy * ny + iz * nz);
  float eta = 1 / 1.5f;
  if (c < 0) {
    c = -c;
    nx = -nx, ny = -ny, nz = -nz;
    eta = 1.5f;
  }
  float k = 1 - eta * eta * (1 - c * c);
  float scale, fresnel;
  if (k < 0) {
    eta = 1;
    scale = 2 * c;
    fresnel = 1;
  } else {
    float t = sqrtf(k);
    scale = eta * c - t;
    float parallel = (c - eta * t) / (c + eta * t);
    float across = (eta * c - t) / (eta * c + t);
    fresnel = 0.5f * (parallel * parallel + across * across);
  }
  float x = eta * ix + scale * nx, y = eta * iy + scale * ny, z = eta * iz + scale * nz;
  points->out0[i] = x * fresnel;
  points->out1[i] = y * fresnel;
  points->out2[i] = z * fresnel;
}

/// Whether a ray is blocked by one of 32 spheres, and how far from it: the first one found ends the
/// search.
KERNEL(occlusion) {
  float px = points->px[i], py = points->py[i], pz = points->pz[i];
  float dx = points->ix[i], dy = points->iy[i], dz = points->iz[i];
  float distance = 1e30f;
  for (int s = 0; s < 32; ++s) {
    const float *sphere = points->spheres + 4 * s;
    float x = sphere[0] - px, y = sphere[1] - py, z = sphere[2] - pz;
    float b = x * dx + y * dy + z * dz;
    float c = x * x + y * y + z * z - sphere[3];
    float square = b * b - c;
    if (square < 0)
      continue;
    float root = sqrtf(square);
    float t = b - root > 1e-3f ? b - root : b + root;
    if (t > 1e-3f) {
      distance = t;
      break;
    }
  }
  points->out0[i] = distance < 1e30f ? 1 / (1 + distance) : 1;
}

/// A tangent, and the vector bent towards it, both stored component by component.
KERNEL(bend) {
  float x = points->triples[3 * i], y = points->triples[3 * i + 1], z = points->triples[3 * i + 2];
  float nx = points->nx[i], ny = points->ny[i], nz = points->nz[i];
  float tx = y * nz - z * ny, ty = z * nx - x * nz, tz = x * ny - y * nx;
  float scale = 1 / sqrtf(tx * tx + ty * ty + tz * tz + 1e-6f);
  points->outTriples[3 * i] = x + scale * tx;
  points->outTriples[3 * i + 1] = y + scale * ty;
  points->outTriples[3 * i + 2] = z + scale * tz;
}
