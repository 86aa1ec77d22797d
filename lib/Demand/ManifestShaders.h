//===-- lib/Demand/ManifestShaders.h - a manifest's shaders -------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_DEMAND_MANIFESTSHADERS_H
#define ANYSL_LIB_DEMAND_MANIFESTSHADERS_H

#include "lib/Demand/Demand.h"
#include "lib/Demand/ManifestReader.h"

namespace anysl::demand {

/// Reads what a manifest says of a shader. `complete`: whether parameters that are not named keep
/// their defaults, if it does not say so. Throws UserError with the place of what is wrong.
ShaderDemand readShader(const Json &json, const std::string &name, bool complete);
/// `places`: with who gives each value.
std::string writeShader(const ShaderDemand &shader, bool places);

} // namespace anysl::demand

#endif
