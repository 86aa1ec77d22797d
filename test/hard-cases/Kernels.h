//===-- test/hard-cases/Kernels.h - hard cases of renderers -------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Functions of tools/anysl-render called as a row's inputs want, and the inputs and judges of these
// rows.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_HARDCASES_KERNELS_H
#define ANYSL_TEST_HARDCASES_KERNELS_H

#include "test/hard-cases/Format.h"

namespace hardcases {

/// The two distances at which a ray (origin, direction) meets a whole quadric of kind in[6], or -1,
/// -1.
void quadric(const double *in, double *out);
Inputs farRays(bool allKinds);
long double judgeQuadric(const Example &);

/// The share of rays that leave a convex shape of size in[0] (in[1]: 0 a sphere, 1 facets) and meet
/// it again.
void secondaryRays(const double *in, double *out);
void naiveSecondaryRays(const float *in, float *out);
/// Their share, which has to be below 1e-5.
long double judgeShare(const Example &);

/// Where a ray meets a sphere of radius in[6] at in[3..5] from an eye at in[0..2], relative to the
/// eye.
void farCamera(const double *in, double *out);
long double judgeFarCamera(const Example &);

/// A pixel's value of two rising numbers.
void pixelGamma(const double *in, double *out);
bool gammaHolds(const Example &);

} // namespace hardcases

#endif
