//===-- lib/Demand/Assumptions.cpp - what a demand lets one take for granted ------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Demand/Demand.h"

#include <algorithm>
#include <set>

namespace anysl::demand {

uint32_t standardKind(std::string_view source) {
#define ANYSL_STANDARD_LIGHT(id, name, word, itsSource, absence)                                   \
  if (source == itsSource)                                                                         \
    return ANYSL_LIGHT_##name;
#include <anysl/LightKinds.def>
  return ANYSL_LIGHT_SHADER;
}

const char *sourceOf(uint32_t standardKind) {
  switch (standardKind) {
#define ANYSL_STANDARD_LIGHT(id, name, word, source, absence)                                      \
  case id:                                                                                         \
    return source;
#include <anysl/LightKinds.def>
  default:
    return "";
  }
}

std::span<const LightDemand> Demand::linkedLights() const {
  if (!eachLight || eachLight->size() > ANYSL_MOST_LINKED_LIGHTS)
    return {};
  return *eachLight;
}

void Demand::setLights(std::vector<LightDemand> each, bool hasAmbient,
                       std::optional<std::array<float, 3>> sum) {
  std::set<std::string> kinds;
  for (const LightDemand &light : each)
    kinds.insert(light.kind);
  if (hasAmbient)
    kinds.emplace(ambientLight);
  ambient = hasAmbient ? sum : std::array<float, 3>{};
  lights.emplace(kinds.begin(), kinds.end());
  eachLight = std::move(each);
}

uint32_t Demand::assumptions() const {
  auto bit = [](AnyslAssumption assumption, bool holds) {
    return holds ? uint32_t(1) << assumption : 0;
  };
  bool mayBeAmbient = false, shines = false, runsShaders = false;
  for (const std::string &kind : lights ? *lights : std::vector<std::string>()) {
    bool isAmbient = kind == ambientLight;
    bool isShader = !isAmbient && standardKind(kind) == ANYSL_LIGHT_SHADER;
    mayBeAmbient |= isAmbient || isShader;
    shines |= !isAmbient;
    runsShaders |= isShader;
  }
  uint32_t result = 0;
#define ANYSL_STANDARD_LIGHT(id, name, word, source, absence)                                      \
  result |= bit(ANYSL_ASSUMES_##absence,                                                           \
                lights && std::find(lights->begin(), lights->end(), source) == lights->end());
#include <anysl/LightKinds.def>
  return result | bit(ANYSL_ASSUMES_NO_LIGHTS, lights && !shines) |
         bit(ANYSL_ASSUMES_NO_LIGHT_SHADERS, lights && !runsShaders) |
         bit(ANYSL_ASSUMES_NO_AMBIENT, lights && !mayBeAmbient) |
         bit(ANYSL_ASSUMES_NO_SHADOWS, shadows && !*shadows) |
         bit(ANYSL_ASSUMES_NO_OTHER_RAYS, othersTrace && !*othersTrace) |
         bit(ANYSL_ASSUMES_NO_TRACED_RAYS, rayDepth && *rayDepth == 0) |
         bit(ANYSL_ASSUMES_NO_TEXTURES, textures && textures->empty()) |
         bit(ANYSL_ASSUMES_NO_DISPLACEMENT, displacement && !*displacement) |
         bit(ANYSL_ASSUMES_NO_VOLUMES, atmosphere && !*atmosphere) |
         bit(ANYSL_ASSUMES_NO_MOTION, shutter && (*shutter)[0] == (*shutter)[1]);
}

} // namespace anysl::demand
