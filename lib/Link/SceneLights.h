//===-- lib/Link/SceneLights.h - lights that are linked into shaders ----------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_LINK_SCENELIGHTS_H
#define ANYSL_LIB_LINK_SCENELIGHTS_H

#include "lib/Link/Session.h"

namespace anysl::link {

/// The lights that shine on every point of the session's shaders; none if they are not known, or
/// too many.
llvm::ArrayRef<demand::LightDemand> linkedLights(const Session &session);

/// What ambient lights add up to at every point of the session's shaders, if it is known.
std::optional<std::array<float, 3>> linkedAmbient(const Session &session);

/// An AnyslLinkedLight of <anysl/demand.h>.
llvm::Constant *lightConstant(llvm::Module &module, const demand::LightDemand &light);

/// Gives a runtime the table of the lights.
void adaptLights(const Session &session, llvm::Module &runtime);

} // namespace anysl::link

#endif
