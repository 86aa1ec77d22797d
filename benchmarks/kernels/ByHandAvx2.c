//===-- benchmarks/kernels/ByHandAvx2.c - five kernels with AVX2 and FMA intrinsics -----------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What a programmer who knows the instruction set would write for the kernels of the same names: 8
// points at once, masks in vectors, products and sums fused, constants kept out of the loop.
//
//===------------------------------------------------------------------------------------------===//

#include <immintrin.h>

#include "Kernels.h"

#define LOAD(array) _mm256_loadu_ps(points->array + i)
#define STORE(array, value) _mm256_storeu_ps(points->array + i, value)
#define C(number) _mm256_set1_ps(number)
#define I(number) _mm256_set1_epi32(number)

static inline __m256 dot(__m256 ax, __m256 ay, __m256 az, __m256 bx, __m256 by, __m256 bz) {
  return _mm256_fmadd_ps(az, bz, _mm256_fmadd_ps(ax, bx, _mm256_mul_ps(ay, by)));
}

static inline __m256 absolute(__m256 x) { return _mm256_andnot_ps(C(-0.0f), x); }

/// 2^(y log2 x) in double for 0 <= x <= 1 and y > 0, within 1 ULP of float, four at a time. The
/// polynomials are those of the math tier u10.
static inline __m128 powerOfFour(__m128 x, __m128 y) {
#define D(number) _mm256_set1_pd(number)
  __m256d a = _mm256_cvtps_pd(x);
  // a = 2^e m with m in [sqrt(1/2), sqrt 2); log2 m = 2/ln 2 · atanh((m - 1) / (m + 1))
  __m256i bits = _mm256_castpd_si256(a);
  __m256i above = _mm256_sub_epi64(bits, _mm256_set1_epi64x(0x3fe6a09e667f3bcdll));
  __m256i fraction = _mm256_and_si256(above, _mm256_set1_epi64x(0x000fffffffffffffll));
  __m256d m =
      _mm256_castsi256_pd(_mm256_add_epi64(fraction, _mm256_set1_epi64x(0x3fe6a09e667f3bcdll)));
  // The exponent e, no less than -150, becomes a double in the low bits of 1.5 · 2^52.
  __m256i exponent =
      _mm256_srli_epi64(_mm256_add_epi64(above, _mm256_set1_epi64x(0x4000000000000000ll)), 52);
  __m256d e = _mm256_sub_pd(
      _mm256_castsi256_pd(_mm256_add_epi64(exponent, _mm256_castpd_si256(D(0x1.8p52)))),
      D(0x1.8p52 + 1024));
  __m256d s = _mm256_div_pd(_mm256_sub_pd(m, D(1)), _mm256_add_pd(m, D(1)));
  __m256d z = _mm256_mul_pd(s, s);
  __m256d p = _mm256_fmadd_pd(D(0x1.e2f24b1bba993p-4), z, D(0x1.2438f59fc1f80p-3));
  p = _mm256_fmadd_pd(p, z, D(0x1.999a7a05759afp-3));
  p = _mm256_fmadd_pd(p, z, D(0x1.555554fdefc62p-2));
  p = _mm256_fmadd_pd(p, z, D(1));
  __m256d log = _mm256_fmadd_pd(_mm256_mul_pd(s, D(0x1.71547652b82fep+1)), p, e);
  __m256d t = _mm256_max_pd(_mm256_mul_pd(log, _mm256_cvtps_pd(y)), D(-160));
  __m256d shifted = _mm256_add_pd(t, D(0x1.8p52));
  __m256d f = _mm256_sub_pd(t, _mm256_sub_pd(shifted, D(0x1.8p52)));
  __m256d q = _mm256_fmadd_pd(D(0x1.41f45bfaf6771p-13), f, D(0x1.5f3e0bf705dcap-10));
  q = _mm256_fmadd_pd(q, f, D(0x1.3b2d57d6830fdp-7));
  q = _mm256_fmadd_pd(q, f, D(0x1.c6aee931eb9f1p-5));
  q = _mm256_fmadd_pd(q, f, D(0x1.ebfbdc2da67c7p-3));
  q = _mm256_fmadd_pd(q, f, D(0x1.62e430aea4decp-1));
  q = _mm256_fmadd_pd(q, f, D(1));
  __m256i scaled =
      _mm256_add_epi64(_mm256_castpd_si256(q), _mm256_slli_epi64(_mm256_castpd_si256(shifted), 52));
  __m256d power = _mm256_and_pd(_mm256_castsi256_pd(scaled), _mm256_cmp_pd(a, D(0), _CMP_GT_OQ));
  return _mm256_cvtpd_ps(power);
#undef D
}

KERNEL_EXPORT void specular_points(const KernelPoints *points, int count) {
  for (int i = 0; i < count; i += 8) {
    __m256 ix = LOAD(ix), iy = LOAD(iy), iz = LOAD(iz);
    __m256 nx = LOAD(nx), ny = LOAD(ny), nz = LOAD(nz);
    __m256 d = dot(ix, iy, iz, nx, ny, nz);
    __m256 twice = _mm256_add_ps(d, d);
    __m256 rx = _mm256_fnmadd_ps(twice, nx, ix);
    __m256 ry = _mm256_fnmadd_ps(twice, ny, iy);
    __m256 rz = _mm256_fnmadd_ps(twice, nz, iz);
    __m256 c = _mm256_max_ps(dot(rx, ry, rz, C(0.48f), C(0.6f), C(0.64f)), C(0));
    __m256 exponent = _mm256_fmadd_ps(C(24), LOAD(random), C(8));
    __m128 low = powerOfFour(_mm256_castps256_ps128(c), _mm256_castps256_ps128(exponent));
    __m128 high = powerOfFour(_mm256_extractf128_ps(c, 1), _mm256_extractf128_ps(exponent, 1));
    __m256 highlight = _mm256_set_m128(high, low);
    __m256 m = _mm256_sub_ps(C(1), absolute(d));
    __m256 m2 = _mm256_mul_ps(m, m);
    __m256 m5 = _mm256_mul_ps(_mm256_mul_ps(m2, m2), m);
    STORE(out0, _mm256_mul_ps(highlight, _mm256_fmadd_ps(C(0.96f), m5, C(0.04f))));
  }
}

KERNEL_EXPORT void glass_points(const KernelPoints *points, int count) {
  for (int i = 0; i < count; i += 8) {
    __m256 ix = LOAD(ix), iy = LOAD(iy), iz = LOAD(iz);
    __m256 nx = LOAD(nx), ny = LOAD(ny), nz = LOAD(nz);
    __m256 d = dot(ix, iy, iz, nx, ny, nz);
    // c = |d|; the normal is turned through the sign of what it is multiplied with.
    __m256 inside = _mm256_cmp_ps(d, C(0), _CMP_GT_OQ);
    __m256 c = absolute(d);
    __m256 eta = _mm256_blendv_ps(C(1 / 1.5f), C(1.5f), inside);
    __m256 k = _mm256_fnmadd_ps(_mm256_mul_ps(eta, eta), _mm256_fnmadd_ps(c, c, C(1)), C(1));
    __m256 t = _mm256_sqrt_ps(_mm256_max_ps(k, C(0)));
    __m256 parallel = _mm256_div_ps(_mm256_fnmadd_ps(eta, t, c), _mm256_fmadd_ps(eta, t, c));
    __m256 refracted = _mm256_fmsub_ps(eta, c, t);
    __m256 across = _mm256_div_ps(refracted, _mm256_fmadd_ps(eta, c, t));
    __m256 fresnel =
        _mm256_mul_ps(C(0.5f), _mm256_fmadd_ps(parallel, parallel, _mm256_mul_ps(across, across)));
    // The sign of k says whether the reflection is total.
    fresnel = _mm256_blendv_ps(fresnel, C(1), k);
    __m256 scale = _mm256_blendv_ps(refracted, _mm256_add_ps(c, c), k);
    eta = _mm256_blendv_ps(eta, C(1), k);
    scale = _mm256_xor_ps(scale, _mm256_and_ps(inside, C(-0.0f)));
    STORE(out0, _mm256_mul_ps(_mm256_fmadd_ps(eta, ix, _mm256_mul_ps(scale, nx)), fresnel));
    STORE(out1, _mm256_mul_ps(_mm256_fmadd_ps(eta, iy, _mm256_mul_ps(scale, ny)), fresnel));
    STORE(out2, _mm256_mul_ps(_mm256_fmadd_ps(eta, iz, _mm256_mul_ps(scale, nz)), fresnel));
  }
}

KERNEL_EXPORT void brick_points(const KernelPoints *points, int count) {
  for (int i = 0; i < count; i += 8) {
    __m256 s = _mm256_mul_ps(C(9.7f), LOAD(u)), t = _mm256_mul_ps(C(19.3f), LOAD(v));
    __m256 row = _mm256_floor_ps(t);
    __m256 half = _mm256_mul_ps(C(0.5f), row);
    __m256 odd = _mm256_cmp_ps(_mm256_sub_ps(half, _mm256_floor_ps(half)), C(0.25f), _CMP_GT_OQ);
    s = _mm256_add_ps(s, _mm256_and_ps(odd, C(0.5f)));
    __m256 column = _mm256_floor_ps(s);
    s = _mm256_sub_ps(s, column);
    t = _mm256_sub_ps(t, row);
    __m256 mortar = _mm256_or_ps(_mm256_cmp_ps(s, C(0.06f), _CMP_LT_OQ),
                                 _mm256_cmp_ps(t, C(0.12f), _CMP_LT_OQ));
    __m256i seed =
        _mm256_xor_si256(_mm256_mullo_epi32(_mm256_cvttps_epi32(column), I((int)0x9e3779b1u)),
                         _mm256_mullo_epi32(_mm256_cvttps_epi32(row), I((int)0x85ebca77u)));
    seed = _mm256_xor_si256(seed, _mm256_srli_epi32(seed, 15));
    seed = _mm256_mullo_epi32(seed, I(0x2c1b3c6d));
    __m256 tint = _mm256_fmadd_ps(_mm256_cvtepi32_ps(_mm256_srli_epi32(seed, 8)),
                                  C(0.2f / 16777216), C(0.8f));
    __m256 rise = _mm256_sub_ps(t, C(0.85f));
    tint = _mm256_fmadd_ps(_mm256_max_ps(rise, C(0)), C(0.8f), tint);
    __m256 grain = _mm256_fmadd_ps(C(0.1f), LOAD(random), C(0.75f));
    __m256 blue = _mm256_mul_ps(_mm256_mul_ps(C(0.15f), tint), tint);
    STORE(out0, _mm256_blendv_ps(_mm256_mul_ps(C(0.7f), tint), grain, mortar));
    STORE(out1, _mm256_blendv_ps(_mm256_mul_ps(C(0.25f), tint), grain, mortar));
    STORE(out2, _mm256_blendv_ps(blue, grain, mortar));
  }
}

KERNEL_EXPORT void mandelbrot_points(const KernelPoints *points, int count) {
  for (int i = 0; i < count; i += 8) {
    __m256 cr = _mm256_fmadd_ps(C(2.8f), LOAD(u), C(-2.1f));
    __m256 ci = _mm256_fmadd_ps(C(2.6f), LOAD(v), C(-1.3f));
    __m256 zr = cr, zi = ci;
    __m256i steps = _mm256_setzero_si256();
    for (int step = 0; step < 256; ++step) {
      __m256 rr = _mm256_mul_ps(zr, zr), ii = _mm256_mul_ps(zi, zi);
      // A point that has left the circle never comes back before it becomes infinite or NaN.
      __m256 inside = _mm256_cmp_ps(_mm256_fmadd_ps(zr, zr, ii), C(4), _CMP_LE_OQ);
      if (_mm256_testz_ps(inside, inside))
        break;
      steps = _mm256_sub_epi32(steps, _mm256_castps_si256(inside));
      zi = _mm256_fmadd_ps(_mm256_add_ps(zr, zr), zi, ci);
      zr = _mm256_add_ps(_mm256_sub_ps(rr, ii), cr);
    }
    STORE(out0, _mm256_cvtepi32_ps(steps));
  }
}

static inline __m256 fade(__m256 t) {
  __m256 p = _mm256_fmadd_ps(t, _mm256_fmsub_ps(t, C(6), C(15)), C(10));
  return _mm256_mul_ps(_mm256_mul_ps(_mm256_mul_ps(t, t), t), p);
}

static inline __m256 mix(__m256 a, __m256 b, __m256 t) {
  return _mm256_fmadd_ps(t, _mm256_sub_ps(b, a), a);
}

static inline __m256i look(const int *table, __m256i index) {
  return _mm256_i32gather_epi32(table, _mm256_and_si256(index, I(255)), 4);
}

static inline __m256 gradient(const int *table, __m256i index, __m256 x, __m256 y, __m256 z) {
  __m256i h = look(table, index);
  // Bit 3 chooses x or y; both bits 3 and 2, or neither, do not choose z.
  __m256 a = _mm256_blendv_ps(x, y, _mm256_castsi256_ps(_mm256_slli_epi32(h, 28)));
  __m256i low = _mm256_cmpeq_epi32(_mm256_and_si256(h, I(12)), I(0));
  __m256i corner = _mm256_cmpeq_epi32(_mm256_and_si256(h, I(13)), I(12));
  __m256 b = _mm256_blendv_ps(_mm256_blendv_ps(z, x, _mm256_castsi256_ps(corner)), y,
                              _mm256_castsi256_ps(low));
  // Bits 0 and 1 are the signs.
  __m256i signA = _mm256_slli_epi32(h, 31);
  __m256i signB = _mm256_and_si256(_mm256_slli_epi32(h, 30), I((int)0x80000000u));
  a = _mm256_xor_ps(a, _mm256_castsi256_ps(signA));
  b = _mm256_xor_ps(b, _mm256_castsi256_ps(signB));
  return _mm256_add_ps(a, b);
}

static inline __m256 noise(const int *table, __m256 x, __m256 y, __m256 z) {
  __m256 fx = _mm256_floor_ps(x), fy = _mm256_floor_ps(y), fz = _mm256_floor_ps(z);
  __m256i cx = _mm256_cvttps_epi32(fx), cy = _mm256_cvttps_epi32(fy), cz = _mm256_cvttps_epi32(fz);
  x = _mm256_sub_ps(x, fx), y = _mm256_sub_ps(y, fy), z = _mm256_sub_ps(z, fz);
  __m256 u = fade(x), v = fade(y), w = fade(z);
  __m256 x1 = _mm256_sub_ps(x, C(1)), y1 = _mm256_sub_ps(y, C(1)), z1 = _mm256_sub_ps(z, C(1));
  __m256i one = I(1);
  __m256i a = _mm256_add_epi32(look(table, cx), cy);
  __m256i b = _mm256_add_epi32(look(table, _mm256_add_epi32(cx, one)), cy);
  __m256i aa = _mm256_add_epi32(look(table, a), cz);
  __m256i ab = _mm256_add_epi32(look(table, _mm256_add_epi32(a, one)), cz);
  __m256i ba = _mm256_add_epi32(look(table, b), cz);
  __m256i bb = _mm256_add_epi32(look(table, _mm256_add_epi32(b, one)), cz);
  __m256 near = mix(mix(gradient(table, aa, x, y, z), gradient(table, ba, x1, y, z), u),
                    mix(gradient(table, ab, x, y1, z), gradient(table, bb, x1, y1, z), u), v);
  aa = _mm256_add_epi32(aa, one), ab = _mm256_add_epi32(ab, one);
  ba = _mm256_add_epi32(ba, one), bb = _mm256_add_epi32(bb, one);
  __m256 far = mix(mix(gradient(table, aa, x, y, z1), gradient(table, ba, x1, y, z1), u),
                   mix(gradient(table, ab, x, y1, z1), gradient(table, bb, x1, y1, z1), u), v);
  return mix(near, far, w);
}

KERNEL_EXPORT void turbulence_points(const KernelPoints *points, int count) {
  for (int i = 0; i < count; i += 8) {
    __m256 x = LOAD(px), y = LOAD(py), z = LOAD(pz);
    __m256 sum = C(0), amplitude = C(0.5f);
    for (int octave = 0; octave < 4; ++octave) {
      sum = _mm256_fmadd_ps(amplitude, noise(points->permutation, x, y, z), sum);
      amplitude = _mm256_mul_ps(amplitude, C(0.5f));
      x = _mm256_add_ps(x, x), y = _mm256_add_ps(y, y), z = _mm256_add_ps(z, z);
    }
    STORE(out0, sum);
  }
}
