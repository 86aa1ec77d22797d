//===-- tools/anysl-render/AccuracyReport.h - what buys a better picture ----------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_ACCURACYREPORT_H
#define ANYSL_RENDER_ACCURACYREPORT_H

#include "tools/anysl-render/Options.h"

namespace anysl::render {

/// Renders a scene with one setting after the other changed: math tier, real, samples a pixel, and
/// the parameter `samples` of surface shaders that have one. Each picture is compared with a
/// converged one, of as many samples as it takes, and with one of the same samples whose shaders
/// compute in double. Writes accuracy.html, accuracy.json and accuracy.svg into a folder. Throws
/// UserError.
void writeAccuracyReport(const Options &options, const SceneDescription &scene,
                         const std::vector<std::filesystem::path> &searchPath, Warnings &warnings);

} // namespace anysl::render

#endif
