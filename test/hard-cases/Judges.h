//===-- test/hard-cases/Judges.h - what is right, and how far off a result is -------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A judge gives the error of one call's results: a multiple of its row's unit, infinite where a
// result is wrong in kind (NaN, the wrong side, outside its range). What is right is computed here
// in long double from closed forms; nothing of AnySL's own takes part.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_HARDCASES_JUDGES_H
#define ANYSL_TEST_HARDCASES_JUDGES_H

#include "test/hard-cases/Format.h"
#include <functional>

namespace hardcases {

using Judge = std::function<long double(const Example &)>;
/// The right results for given inputs.
using Truth = void (*)(const long double *in, long double *out);

/// The largest error of `outputs` results, in units in the last place of what is right.
Judge inUlps(Truth truth, int outputs);
/// The largest difference.
Judge byDifference(Truth truth, int outputs);
/// The largest difference as a share of what is right; of denormal numbers, of the smallest normal
/// one.
Judge byRatio(Truth truth, int outputs);
/// 0 where all results are as they should be, else infinite.
Judge ifTrue(bool (*holds)(const Example &));

//===-- Truths --------------------------------------------------------------------------------===//

void trueLength(const long double *in, long double *out);
void trueAcosAsin(const long double *in, long double *out);
void trueAngle(const long double *in, long double *out);
void trueAtan2(const long double *in, long double *out);
void trueSmoothstep(const long double *in, long double *out);
void trueSpline(const long double *in, long double *out);
void trueUnity(const long double *in, long double *out);
void trueMicrofacet(const long double *in, long double *out);
void trueRoots(const long double *in, long double *out);
void trueLog(const long double *in, long double *out);
void trueTone(const long double *in, long double *out);
void trueFilterstep(const long double *in, long double *out);
void trueMerge(const long double *in, long double *out);
void trueGather(const long double *in, long double *out);
void trueArea(const long double *in, long double *out);
void trueEdgeSlopes(const long double *in, long double *out);
void truePowerSlopes(const long double *in, long double *out);
void trueLengthSlopes(const long double *in, long double *out);
void trueAtan2Slopes(const long double *in, long double *out);
void trueKinks(const long double *in, long double *out);

//===-- Judges of their own -------------------------------------------------------------------===//

long double judgeNormalize(const Example &);
bool unitDotHolds(const Example &);
bool faceforwardHolds(const Example &);
/// Of reflect: the error as a share of 4e + 2e² + 4e-7 for |N| = 1 + e.
long double judgeReflect(const Example &);
/// Of reflect at a normal of unit length: the change of length.
long double judgeReflectLength(const Example &);
long double judgeFresnel(const Example &);
bool extremeFresnelHolds(const Example &);
long double judgeRefract(const Example &);
long double judgeMod(const Example &);
long double judgePow(const Example &);
bool atan2SignsHold(const Example &);
long double judgeNoise(const Example &);
bool noiseCellHolds(const Example &);
bool cellnoiseHolds(const Example &);
bool pnoiseHolds(const Example &);
bool specularHolds(const Example &);
bool idleDivisionHolds(const Example &);
bool loopHolds(const Example &);
bool denormalsHold(const Example &);
bool guardsHold(const Example &);
long double judgeBasis(const Example &);
bool divideHolds(const Example &);
/// Of a colour there and back: NaN, a changed colour, or a grey that got a hue.
template <bool hasHue>
long double judgeColor(const Example &);
long double judgeNormalField(const Example &);
bool filterWidthHolds(const Example &);

} // namespace hardcases

#endif
