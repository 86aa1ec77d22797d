//===-- test/hard-cases/Inputs.h - the inputs that break obvious code ---------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Lists of inputs that take more than a line to write: points in no special position at every
// magnitude, angles spaced by logarithm about a singular one. Each is the same in every run.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TEST_HARDCASES_INPUTS_H
#define ANYSL_TEST_HARDCASES_INPUTS_H

#include "test/hard-cases/Format.h"

namespace hardcases {

/// The lists that a table's line writes out, one after the other, rounded to the format.
Inputs join(std::initializer_list<Inputs> lists);
/// Every combination of the values.
Inputs product(const std::vector<std::vector<double>> &axes);

/// Directions in all octants, times every magnitude of the format that a length can have.
Inputs vectorsOfAllSizes(Format f);
/// Vectors of unit length, as the format rounds them.
Inputs unitVectors(Format f, int count = 60);
/// Unit vectors on and beside the z axis, both ways.
Inputs nearPole(Format f);
/// Unit I and N with the given change of N's length, from normal to grazing incidence.
Inputs reflections(Format f, const std::vector<double> &lengthErrors);
/// I, N and eta with angles spaced by logarithm about the critical one, on both sides.
Inputs aboutCriticalAngle(Format f);
/// I, N and eta: extreme ratios of media, at normal, oblique and grazing incidence.
Inputs extremeMedia(Format f);
/// I, N and eta for Snell's law: all incidences, total reflection included.
Inputs refractions(Format f);
/// Two unit vectors with the given angle between them.
Inputs closeVectors(Format f);
/// N, I and a reference whose product with I is ±0, or anything else.
Inputs facing(Format f);
/// Coordinates far and near, on lattice points and between them.
Inputs coordinates(Format f);
/// Half vectors about a normal (0, 0, 1), as wide as the given roughness or ten times as wide.
Inputs halfVectors(Format f);
/// Colours: grey ones, black, bright ones, saturated ones, with negative components if `anySign`.
Inputs colors(bool anySign);
/// Derivatives of P, N and Ng: parallel, zero, tiny, huge, ordinary.
Inputs frames(Format f);
/// Every power of two of the format, and its neighbours.
Inputs allExponents(Format f);

} // namespace hardcases

#endif
