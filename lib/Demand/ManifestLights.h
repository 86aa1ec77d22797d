//===-- lib/Demand/ManifestLights.h - a manifest's lights ---------------------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_LIB_DEMAND_MANIFESTLIGHTS_H
#define ANYSL_LIB_DEMAND_MANIFESTLIGHTS_H

#include "lib/Demand/Demand.h"
#include "lib/Demand/ManifestReader.h"

namespace anysl::demand {

/// Reads the key "lights": names of kinds, of which there may be any number, or objects, which are
/// the lights themselves. Throws UserError with the place of what is wrong.
void readLights(const Json &value, const std::string &key, Demand &demand);
/// Follows from the lights whether any casts shadows, where the manifest does not say so; throws
/// UserError if it says otherwise.
void addShadows(const Json &manifest, Demand &demand);
/// The lights of `demand.eachLight`, and whether there are ambient ones. `places`: with who gives
/// each value of a parameter.
std::string writeLights(const Demand &demand, bool places);

} // namespace anysl::demand

#endif
