//===-- tools/anysl-render/EffectsReport.h - what a scene calls for, at what cost ----*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RENDER_EFFECTSREPORT_H
#define ANYSL_RENDER_EFFECTSREPORT_H

#include "tools/anysl-render/Options.h"

namespace anysl::render {

/// Links the scene's shaders for it and for any scene, as they are and without each effect, renders
/// with all of these, and tells of each effect that the shaders' sources can have whether the scene
/// calls for it, who asks, why, and what it costs: a table on the standard output, and effects.json
/// and effects.html in the folder of Options::effectsReport.
void writeEffectsReport(const Options &options, const SceneDescription &scene,
                        const std::vector<std::filesystem::path> &searchPath, Warnings &warnings);

} // namespace anysl::render

#endif
