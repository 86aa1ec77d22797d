//===-- anysl/standard/context.h - the shading context of a runtime over AnyslShadeArgs -------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The headers of this folder define what every runtime does alike that gets its points as a batch
// (AnyslShadeArgs): a runtime includes each in one of its sources, and adds what is its own, where
// the globals lie and how it asks the renderer. A runtime with a context of its own writes its own.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_CONTEXT_H
#define ANYSL_STANDARD_CONTEXT_H

#include <anysl/hash.h>
#include <anysl/runtime.h>

struct anysl_context {
  const AnyslShadeArgs *args;
  uint32_t point;
  /// Where the point's sequence of random numbers stands, see standard/random.h.
  uint32_t random;
};

namespace anysl {

/// How many points further the value of each global is that belongs to the next point: 0 for a
/// uniform one.
inline constexpr uint32_t globalStep[] = {
#define uniform 0
#define varying 1
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) storage,
#include <anysl/Globals.def>
#undef uniform
#undef varying
};

/// The first component of each global among all components of a point.
inline constexpr uint32_t globalComponent[] = {
#define ANYSL_GLOBAL(id, name, type, components, storage, doc) ANYSL_COMPONENT_##name,
#include <anysl/Globals.def>
};

/// The global that says how a global changes with u, and with v; `none` where there is no such.
inline constexpr uint32_t none = ~0u;
constexpr uint32_t derivativeByU(uint32_t id) {
  switch (id) {
#define ANYSL_DERIVATIVE(name, byU, byV)                                                           \
  case ANYSL_##name:                                                                               \
    return ANYSL_##byU;
#include <anysl/Globals.def>
  default:
    return none;
  }
}
constexpr uint32_t derivativeByV(uint32_t id) {
  switch (id) {
#define ANYSL_DERIVATIVE(name, byU, byV)                                                           \
  case ANYSL_##name:                                                                               \
    return ANYSL_##byV;
#include <anysl/Globals.def>
  default:
    return none;
  }
}

} // namespace anysl

#endif // ANYSL_STANDARD_CONTEXT_H
