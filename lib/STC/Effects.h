//===-- lib/STC/Effects.h - what operators are for, and whom they ask ---------------*- C++ -*-===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Effects.def and Services.def as data. A shader's description has them as bits (AnyslShaderInfo),
// so that renderers, too, go by these names.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STC_EFFECTS_H
#define ANYSL_STC_EFFECTS_H

#include <cstdint>

namespace anysl::stc {

enum class Effect : uint8_t {
#define STC_EFFECT(id, name, doc) name = id,
#include "lib/STC/Effects.def"
};

/// Whether operators of an effect look up pictures.
constexpr bool looksUpPictures(Effect effect) {
  return effect == Effect::Textures || effect == Effect::Environment ||
         effect == Effect::ShadowMaps;
}
/// Whether they trace rays that meet surfaces, which are then shaded.
constexpr bool tracesSurfaces(Effect effect) {
  return effect == Effect::Trace || effect == Effect::Glossy;
}

enum class Service : uint8_t {
#define STC_SERVICE(id, name, doc) name = id,
#include "lib/STC/Services.def"
};

/// Whether bits of AnyslShaderInfo have an effect, or a service.
template <class Kind>
constexpr bool has(uint32_t bits, Kind what) {
  return bits >> unsigned(what) & 1;
}

} // namespace anysl::stc

#endif
