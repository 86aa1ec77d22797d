//===-- tools/anysl-link/Scene.h - the scene to link for ------------------------------*- C++
//-*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_TOOLS_ANYSL_LINK_SCENE_H
#define ANYSL_TOOLS_ANYSL_LINK_SCENE_H

#include "lib/Demand/Demand.h"
#include "lib/Support/Diagnostics.h"

namespace anysl {

/// What a scene calls for, by a RIB file or, where the name ends in .json, by a manifest. `linked`
/// and `beside` are the shaders' files, the latter of those that are not linked: of a RIB scene
/// whose shaders are all there it is known what they ask each other. Nothing, with errors reported,
/// if a file is wrong.
std::optional<demand::Demand> readScene(DiagnosticEngine &diags, const std::string &path,
                                        const std::vector<std::string> &linked,
                                        const std::vector<std::string> &beside);

} // namespace anysl

#endif
