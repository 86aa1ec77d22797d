//===-- tools/anysl-render/PictureError.h - how far pictures are from each other --*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_PICTUREERROR_H
#define ANYSL_RENDER_PICTUREERROR_H

#include "tools/anysl-render/Film.h"

namespace anysl::render {

/// The root of the mean square of the differences of all linear colour numbers.
double rootMeanSquare(const Film &a, const Film &b);

/// The mean over all pixels of the difference that one sees when two pictures take turns on a
/// screen, from 0 to 1: LDR-FLIP of Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and
/// Fairchild, "FLIP: A Difference Evaluator for Alternating Images" (Proceedings of the ACM on
/// Computer Graphics and Interactive Techniques 3(2), 2020), at its default distance of 67 pixels
/// a degree. Colours are taken as a screen shows them, limited to [0, 1].
double flipMean(const Film &reference, const Film &test);

} // namespace anysl::render

#endif
