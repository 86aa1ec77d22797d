//===-- benchmarks/kernels/ByHandAvx512.c - five kernels with AVX-512 intrinsics --------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What a programmer who knows the instruction set would write for the kernels of the same names: 16
// points at once, masks in mask registers, products and sums fused, constants kept out of the loop.
//
//===------------------------------------------------------------------------------------------===//

#include <immintrin.h>

#include "Kernels.h"

#define LOAD(array) _mm512_loadu_ps(points->array + i)
#define STORE(array, value) _mm512_storeu_ps(points->array + i, value)
#define C(number) _mm512_set1_ps(number)
#define I(number) _mm512_set1_epi32(number)

static inline __m512 dot(__m512 ax, __m512 ay, __m512 az, __m512 bx, __m512 by, __m512 bz) {
  return _mm512_fmadd_ps(az, bz, _mm512_fmadd_ps(ax, bx, _mm512_mul_ps(ay, by)));
}

static inline __m512 absolute(__m512 x) { return _mm512_abs_ps(x); }

static inline __m512 roundDown(__m512 x) {
  return _mm512_roundscale_ps(x, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
}

static inline __m512 negateIf(__mmask16 m, __m512 x) {
  return _mm512_castsi512_ps(_mm512_mask_xor_epi32(_mm512_castps_si512(x), m,
                                                   _mm512_castps_si512(x), I((int)0x80000000u)));
}

/// x^y for 0 <= x <= 1 and y > 0, within 1 ULP: 2^(y log2 x) in double, eight at a time. The
/// polynomials are those of the math tier u10.
static inline __m256 powerOfEight(__m256 x, __m256 y) {
#define D(number) _mm512_set1_pd(number)
  __m512d a = _mm512_cvtps_pd(x);
  // a = 2^e m with m in [sqrt(1/2), sqrt 2); log2 m = 2/ln 2 · atanh((m - 1) / (m + 1))
  __m512d e = _mm512_getexp_pd(_mm512_mul_pd(a, D(1.4142135623730951)));
  __m512d m = _mm512_scalef_pd(a, _mm512_sub_pd(D(0), e));
  __m512d s = _mm512_div_pd(_mm512_sub_pd(m, D(1)), _mm512_add_pd(m, D(1)));
  __m512d z = _mm512_mul_pd(s, s);
  __m512d p = _mm512_fmadd_pd(D(0x1.e2f24b1bba993p-4), z, D(0x1.2438f59fc1f80p-3));
  p = _mm512_fmadd_pd(p, z, D(0x1.999a7a05759afp-3));
  p = _mm512_fmadd_pd(p, z, D(0x1.555554fdefc62p-2));
  p = _mm512_fmadd_pd(p, z, D(1));
  __m512d log = _mm512_fmadd_pd(_mm512_mul_pd(s, D(0x1.71547652b82fep+1)), p, e);
  __m512d t = _mm512_max_pd(_mm512_mul_pd(log, _mm512_cvtps_pd(y)), D(-160));
  __m512d n = _mm512_roundscale_pd(t, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
  __m512d f = _mm512_sub_pd(t, n);
  __m512d q = _mm512_fmadd_pd(D(0x1.41f45bfaf6771p-13), f, D(0x1.5f3e0bf705dcap-10));
  q = _mm512_fmadd_pd(q, f, D(0x1.3b2d57d6830fdp-7));
  q = _mm512_fmadd_pd(q, f, D(0x1.c6aee931eb9f1p-5));
  q = _mm512_fmadd_pd(q, f, D(0x1.ebfbdc2da67c7p-3));
  q = _mm512_fmadd_pd(q, f, D(0x1.62e430aea4decp-1));
  q = _mm512_fmadd_pd(q, f, D(1));
  __m512d power = _mm512_maskz_scalef_pd(_mm512_cmp_pd_mask(a, D(0), _CMP_GT_OQ), q, n);
  return _mm512_cvtpd_ps(power);
#undef D
}

KERNEL_EXPORT void specular_points(const KernelPoints *points, int count) {
  for (int i = 0; i < count; i += 16) {
    __m512 ix = LOAD(ix), iy = LOAD(iy), iz = LOAD(iz);
    __m512 nx = LOAD(nx), ny = LOAD(ny), nz = LOAD(nz);
    __m512 d = dot(ix, iy, iz, nx, ny, nz);
    __m512 twice = _mm512_add_ps(d, d);
    __m512 rx = _mm512_fnmadd_ps(twice, nx, ix);
    __m512 ry = _mm512_fnmadd_ps(twice, ny, iy);
    __m512 rz = _mm512_fnmadd_ps(twice, nz, iz);
    __m512 c = _mm512_max_ps(dot(rx, ry, rz, C(0.48f), C(0.6f), C(0.64f)), C(0));
    __m512 exponent = _mm512_fmadd_ps(C(24), LOAD(random), C(8));
    __m256 low = powerOfEight(_mm512_castps512_ps256(c), _mm512_castps512_ps256(exponent));
    __m256 high = powerOfEight(_mm512_extractf32x8_ps(c, 1), _mm512_extractf32x8_ps(exponent, 1));
    __m512 highlight = _mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1);
    __m512 m = _mm512_sub_ps(C(1), absolute(d));
    __m512 m2 = _mm512_mul_ps(m, m);
    __m512 m5 = _mm512_mul_ps(_mm512_mul_ps(m2, m2), m);
    STORE(out0, _mm512_mul_ps(highlight, _mm512_fmadd_ps(C(0.96f), m5, C(0.04f))));
  }
}

KERNEL_EXPORT void glass_points(const KernelPoints *points, int count) {
  for (int i = 0; i < count; i += 16) {
    __m512 ix = LOAD(ix), iy = LOAD(iy), iz = LOAD(iz);
    __m512 nx = LOAD(nx), ny = LOAD(ny), nz = LOAD(nz);
    __m512 d = dot(ix, iy, iz, nx, ny, nz);
    // c = |d|; the normal is turned through the sign of what it is multiplied with.
    __mmask16 inside = _mm512_cmp_ps_mask(d, C(0), _CMP_GT_OQ);
    __m512 c = absolute(d);
    __m512 eta = _mm512_mask_mov_ps(C(1 / 1.5f), inside, C(1.5f));
    __m512 k = _mm512_fnmadd_ps(_mm512_mul_ps(eta, eta), _mm512_fnmadd_ps(c, c, C(1)), C(1));
    __mmask16 total = _mm512_cmp_ps_mask(k, C(0), _CMP_LT_OQ);
    __m512 t = _mm512_sqrt_ps(_mm512_max_ps(k, C(0)));
    __m512 parallel = _mm512_div_ps(_mm512_fnmadd_ps(eta, t, c), _mm512_fmadd_ps(eta, t, c));
    __m512 refracted = _mm512_fmsub_ps(eta, c, t);
    __m512 across = _mm512_div_ps(refracted, _mm512_fmadd_ps(eta, c, t));
    __m512 fresnel =
        _mm512_mul_ps(C(0.5f), _mm512_fmadd_ps(parallel, parallel, _mm512_mul_ps(across, across)));
    fresnel = _mm512_mask_mov_ps(fresnel, total, C(1));
    __m512 scale = _mm512_mask_add_ps(refracted, total, c, c);
    eta = _mm512_mask_mov_ps(eta, total, C(1));
    scale = negateIf(inside, scale);
    STORE(out0, _mm512_mul_ps(_mm512_fmadd_ps(eta, ix, _mm512_mul_ps(scale, nx)), fresnel));
    STORE(out1, _mm512_mul_ps(_mm512_fmadd_ps(eta, iy, _mm512_mul_ps(scale, ny)), fresnel));
    STORE(out2, _mm512_mul_ps(_mm512_fmadd_ps(eta, iz, _mm512_mul_ps(scale, nz)), fresnel));
  }
}

KERNEL_EXPORT void brick_points(const KernelPoints *points, int count) {
  for (int i = 0; i < count; i += 16) {
    __m512 s = _mm512_mul_ps(C(9.7f), LOAD(u)), t = _mm512_mul_ps(C(19.3f), LOAD(v));
    __m512 row = roundDown(t);
    __m512 half = _mm512_mul_ps(C(0.5f), row);
    __mmask16 odd = _mm512_cmp_ps_mask(_mm512_sub_ps(half, roundDown(half)), C(0.25f), _CMP_GT_OQ);
    s = _mm512_mask_add_ps(s, odd, s, C(0.5f));
    __m512 column = roundDown(s);
    s = _mm512_sub_ps(s, column);
    t = _mm512_sub_ps(t, row);
    __mmask16 mortar =
        _mm512_cmp_ps_mask(s, C(0.06f), _CMP_LT_OQ) | _mm512_cmp_ps_mask(t, C(0.12f), _CMP_LT_OQ);
    __m512i seed =
        _mm512_xor_si512(_mm512_mullo_epi32(_mm512_cvttps_epi32(column), I((int)0x9e3779b1u)),
                         _mm512_mullo_epi32(_mm512_cvttps_epi32(row), I((int)0x85ebca77u)));
    seed = _mm512_xor_si512(seed, _mm512_srli_epi32(seed, 15));
    seed = _mm512_mullo_epi32(seed, I(0x2c1b3c6d));
    __m512 tint = _mm512_fmadd_ps(_mm512_cvtepi32_ps(_mm512_srli_epi32(seed, 8)),
                                  C(0.2f / 16777216), C(0.8f));
    __mmask16 edge = _mm512_cmp_ps_mask(t, C(0.85f), _CMP_GT_OQ);
    tint = _mm512_mask3_fmadd_ps(_mm512_sub_ps(t, C(0.85f)), C(0.8f), tint, edge);
    __m512 grain = _mm512_fmadd_ps(C(0.1f), LOAD(random), C(0.75f));
    __m512 blue = _mm512_mul_ps(_mm512_mul_ps(C(0.15f), tint), tint);
    STORE(out0, _mm512_mask_mov_ps(_mm512_mul_ps(C(0.7f), tint), mortar, grain));
    STORE(out1, _mm512_mask_mov_ps(_mm512_mul_ps(C(0.25f), tint), mortar, grain));
    STORE(out2, _mm512_mask_mov_ps(blue, mortar, grain));
  }
}

KERNEL_EXPORT void mandelbrot_points(const KernelPoints *points, int count) {
  for (int i = 0; i < count; i += 16) {
    __m512 cr = _mm512_fmadd_ps(C(2.8f), LOAD(u), C(-2.1f));
    __m512 ci = _mm512_fmadd_ps(C(2.6f), LOAD(v), C(-1.3f));
    __m512 zr = cr, zi = ci;
    __m512i steps = _mm512_setzero_si512();
    for (int step = 0; step < 256; ++step) {
      __m512 rr = _mm512_mul_ps(zr, zr), ii = _mm512_mul_ps(zi, zi);
      // A point that has left the circle never comes back before it becomes infinite or NaN.
      __mmask16 inside = _mm512_cmp_ps_mask(_mm512_fmadd_ps(zr, zr, ii), C(4), _CMP_LE_OQ);
      if (!inside)
        break;
      steps = _mm512_mask_add_epi32(steps, inside, steps, I(1));
      zi = _mm512_fmadd_ps(_mm512_add_ps(zr, zr), zi, ci);
      zr = _mm512_add_ps(_mm512_sub_ps(rr, ii), cr);
    }
    STORE(out0, _mm512_cvtepi32_ps(steps));
  }
}

static inline __m512 fade(__m512 t) {
  __m512 p = _mm512_fmadd_ps(t, _mm512_fmsub_ps(t, C(6), C(15)), C(10));
  return _mm512_mul_ps(_mm512_mul_ps(_mm512_mul_ps(t, t), t), p);
}

static inline __m512 mix(__m512 a, __m512 b, __m512 t) {
  return _mm512_fmadd_ps(t, _mm512_sub_ps(b, a), a);
}

static inline __m512i look(const int *table, __m512i index) {
  return _mm512_i32gather_epi32(_mm512_and_si512(index, I(255)), table, 4);
}

static inline __m512 gradient(const int *table, __m512i index, __m512 x, __m512 y, __m512 z) {
  __m512i h = look(table, index);
  // Bit 3 chooses x or y; both bits 3 and 2, or neither, do not choose z.
  __m512 a = _mm512_mask_mov_ps(x, _mm512_test_epi32_mask(h, I(8)), y);
  __mmask16 low = _mm512_testn_epi32_mask(h, I(12));
  __mmask16 corner = _mm512_cmpeq_epi32_mask(_mm512_and_si512(h, I(13)), I(12));
  __m512 b = _mm512_mask_mov_ps(_mm512_mask_mov_ps(z, corner, x), low, y);
  // Bits 0 and 1 are the signs.
  __m512i signA = _mm512_slli_epi32(h, 31);
  __m512i signB = _mm512_and_si512(_mm512_slli_epi32(h, 30), I((int)0x80000000u));
  a = _mm512_xor_ps(a, _mm512_castsi512_ps(signA));
  b = _mm512_xor_ps(b, _mm512_castsi512_ps(signB));
  return _mm512_add_ps(a, b);
}

static inline __m512 noise(const int *table, __m512 x, __m512 y, __m512 z) {
  __m512 fx = roundDown(x), fy = roundDown(y), fz = roundDown(z);
  __m512i cx = _mm512_cvttps_epi32(fx), cy = _mm512_cvttps_epi32(fy), cz = _mm512_cvttps_epi32(fz);
  x = _mm512_sub_ps(x, fx), y = _mm512_sub_ps(y, fy), z = _mm512_sub_ps(z, fz);
  __m512 u = fade(x), v = fade(y), w = fade(z);
  __m512 x1 = _mm512_sub_ps(x, C(1)), y1 = _mm512_sub_ps(y, C(1)), z1 = _mm512_sub_ps(z, C(1));
  __m512i one = I(1);
  __m512i a = _mm512_add_epi32(look(table, cx), cy);
  __m512i b = _mm512_add_epi32(look(table, _mm512_add_epi32(cx, one)), cy);
  __m512i aa = _mm512_add_epi32(look(table, a), cz);
  __m512i ab = _mm512_add_epi32(look(table, _mm512_add_epi32(a, one)), cz);
  __m512i ba = _mm512_add_epi32(look(table, b), cz);
  __m512i bb = _mm512_add_epi32(look(table, _mm512_add_epi32(b, one)), cz);
  __m512 near = mix(mix(gradient(table, aa, x, y, z), gradient(table, ba, x1, y, z), u),
                    mix(gradient(table, ab, x, y1, z), gradient(table, bb, x1, y1, z), u), v);
  aa = _mm512_add_epi32(aa, one), ab = _mm512_add_epi32(ab, one);
  ba = _mm512_add_epi32(ba, one), bb = _mm512_add_epi32(bb, one);
  __m512 far = mix(mix(gradient(table, aa, x, y, z1), gradient(table, ba, x1, y, z1), u),
                   mix(gradient(table, ab, x, y1, z1), gradient(table, bb, x1, y1, z1), u), v);
  return mix(near, far, w);
}

KERNEL_EXPORT void turbulence_points(const KernelPoints *points, int count) {
  for (int i = 0; i < count; i += 16) {
    __m512 x = LOAD(px), y = LOAD(py), z = LOAD(pz);
    __m512 sum = C(0), amplitude = C(0.5f);
    for (int octave = 0; octave < 4; ++octave) {
      sum = _mm512_fmadd_ps(amplitude, noise(points->permutation, x, y, z), sum);
      amplitude = _mm512_mul_ps(amplitude, C(0.5f));
      x = _mm512_add_ps(x, x), y = _mm512_add_ps(y, y), z = _mm512_add_ps(z, z);
    }
    STORE(out0, sum);
  }
}
