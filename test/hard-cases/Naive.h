//===-- test/hard-cases/Naive.h - the obvious code for each row ---------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What one writes without thinking of the row's inputs, in float. The same judge measures it, and
// docs/hard-cases.md says what it gives.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_HARDCASES_NAIVE_H
#define ANYSL_TEST_HARDCASES_NAIVE_H

namespace hardcases {

using Naive = void (*)(const float *in, float *out);

#define NAIVE(name) void name(const float *in, float *out);
NAIVE(naiveLength)
NAIVE(naiveNormalize)
NAIVE(naiveUnitDot)
NAIVE(naiveFaceforward)
NAIVE(naiveReflect)
NAIVE(naiveFresnel)
NAIVE(naiveRefract)
NAIVE(naiveSmoothstep)
NAIVE(naiveMod)
NAIVE(naivePow)
NAIVE(naiveLog)
NAIVE(naiveAcos)
NAIVE(naiveAngle)
NAIVE(naiveAtan2)
NAIVE(naiveSqrt)
NAIVE(naiveSpline)
NAIVE(naiveSplineUnity)
NAIVE(naiveNoise)
NAIVE(naiveNoiseCell)
NAIVE(naiveCellnoise)
NAIVE(naivePnoise)
NAIVE(naiveSpecular)
NAIVE(naiveMicrofacet)
NAIVE(naiveDivideIdle)
NAIVE(naiveMerge)
NAIVE(naiveLoop)
NAIVE(naiveDenormal)
NAIVE(naiveGuards)
NAIVE(naiveBasis)
NAIVE(naiveTone)
NAIVE(naiveHsv)
NAIVE(naiveHsl)
NAIVE(naiveXyz)
NAIVE(naiveYiq)
NAIVE(naiveXyY)
NAIVE(naiveFilterstep)
NAIVE(naiveDivide)
NAIVE(naiveArea)
NAIVE(naiveEdgeSlopes)
NAIVE(naivePowerSlopes)
NAIVE(naiveLengthSlopes)
NAIVE(naiveAtan2Slopes)
NAIVE(naiveKinks)
NAIVE(naiveFilterwidth)
NAIVE(naiveQuadric)
NAIVE(naiveGamma)
NAIVE(naiveFarCamera)
#undef NAIVE

} // namespace hardcases

#endif
