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

extern "C" {

/// The first component of each global that says how another one changes with u or v. The linker,
/// which defines these, asks the host for such a global only if its variable is still read in the
/// end.
#define ANYSL_DERIVATIVE(name, byU, byV)                                                           \
  extern const uint32_t anysl_derivative_input_##byU, anysl_derivative_input_##byV;
#include <anysl/Globals.def>
extern const uint32_t anysl_derivative_input_N; // says with dNdu and dNdv how the surface bends
extern const uint32_t anysl_derivative_input_du, anysl_derivative_input_dv; // for rays

/// The number of a parameter, for whoever looks up a derivative of it: from the calls that are left
/// in the end the linker knows for which parameters the host is asked.
__attribute__((const)) uint32_t anysl_derivative_param(uint32_t id);

} // extern "C"

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

/// How far the next point lies in u and in v, for rays that carry derivatives; inputs.h has it.
anysl_number stepOfU(const anysl_context *context);
anysl_number stepOfV(const anysl_context *context);

} // namespace anysl

#endif // ANYSL_STANDARD_CONTEXT_H
