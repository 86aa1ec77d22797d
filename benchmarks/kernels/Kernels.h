//===-- benchmarks/kernels/Kernels.h - what every kernel is written with ----------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A kernel is a plain C function for one point,
//
//   KERNEL(gain) { points->out0[i] = 2 * points->u[i]; }
//
// which asks for vector variants as any C program does, with `#pragma omp declare simd`. The same
// source is compiled for every contestant; KERNEL ends with the loop `gain_points` that is timed:
//
//   KERNEL_WIDTH=1   calls the function itself; KERNEL_VECTORIZE asks clang to vectorise that loop
//   KERNEL_WIDTH=W   calls the variant whose name starts with KERNEL_VARIANT, e.g. "_ZGVeN16ul_",
//                    which anysl-vectorize defines; KERNEL_LANES, if it is not a width that
//                    compilers give the instruction set by themselves
//
// KERNEL_TIER takes the elementary functions from <anysl/math.h> instead of from the C library.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_BENCHMARKS_KERNELS_KERNELS_H
#define ANYSL_BENCHMARKS_KERNELS_KERNELS_H

#ifdef __cplusplus
extern "C" {
#endif

/// The points of one patch: an array for each input and output, and tables that all points share.
typedef struct KernelPoints {
  const float *ix, *iy, *iz; ///< directions of length 1
  const float *nx, *ny, *nz; ///< normals of length 1
  const float *px, *py, *pz; ///< positions in [-4, 4]³
  const float *u, *v;        ///< a grid of 64 × 64 over [0, 1)², u running fastest
  const float *random;       ///< in [0, 1)
  const float *triples;      ///< three floats a point
  const int *permutation;    ///< of 0 … 255
  const float *spheres;      ///< 32 spheres of four floats: centre and radius²
  const float *image;        ///< 64 × 64
  float *out0, *out1, *out2;
  float *outTriples;
} KernelPoints;

/// Runs a kernel for the points 0 … count - 1; `count` is a multiple of 64.
typedef void KernelLoop(const KernelPoints *points, int count);

#ifdef __cplusplus
}
#else

#include <math.h>

#ifdef KERNEL_TIER
#include <anysl/math.h>
#define MATH(name) anysl_math_##name
#else
#define MATH(name) name
#endif

#define KERNEL_PRAGMA(text) _Pragma(#text)
#define KERNEL_SIMD(...)                                                                           \
  KERNEL_PRAGMA(omp declare simd notinbranch uniform(points) linear(i : 1) __VA_ARGS__)
#ifdef KERNEL_LANES
#define KERNEL_VARIANTS KERNEL_SIMD(simdlen(KERNEL_LANES))
#else
#define KERNEL_VARIANTS KERNEL_SIMD()
#endif

#define KERNEL(name)                                                                               \
  void name(const KernelPoints *points, int i);                                                    \
  KERNEL_LOOP(name)                                                                                \
  KERNEL_VARIANTS void name(const KernelPoints *points, int i)

#define KERNEL_EXPORT __attribute__((visibility("default")))

#if KERNEL_WIDTH > 1
#define KERNEL_LOOP(name)                                                                          \
  void name##_variant(const KernelPoints *points, int i) __asm__(KERNEL_VARIANT #name);            \
  KERNEL_EXPORT void name##_points(const KernelPoints *points, int count) {                        \
    for (int i = 0; i < count; i += KERNEL_WIDTH)                                                  \
      name##_variant(points, i);                                                                   \
  }
#elif defined(KERNEL_VECTORIZE)
#define KERNEL_LOOP(name)                                                                          \
  KERNEL_EXPORT void name##_points(const KernelPoints *points, int count) {                        \
    _Pragma("clang loop vectorize(assume_safety)") for (int i = 0; i < count; ++i)                 \
        name(points, i);                                                                           \
  }
#else
#define KERNEL_LOOP(name)                                                                          \
  KERNEL_EXPORT void name##_points(const KernelPoints *points, int count) {                        \
    for (int i = 0; i < count; ++i)                                                                \
      name(points, i);                                                                             \
  }
#endif

#endif

#endif // ANYSL_BENCHMARKS_KERNELS_KERNELS_H
