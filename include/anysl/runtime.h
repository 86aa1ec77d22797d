//===-- anysl/runtime.h - what a runtime is compiled against ----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Declares every operator of the table, the type symbols and the hooks between a runtime and the
// linker. A runtime includes this header, defines the operators that are its own, and is compiled
// to bitcode with -Wmissing-prototypes -Werror: a definition whose signature is not the table's
// does not compile. docs/architecture.md says which kind of module defines what.
//
// What `float` is comes from <anysl/real.h>, which each folder of runtimes/real has its own of; it
// defines `anysl_float` and the functions listed in runtimes/real/README.md.
//
// Runtimes are freestanding: no C or C++ library is there, only clang's builtins.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_RUNTIME_H
#define ANYSL_RUNTIME_H

#include <anysl/abi.h>
#include <anysl/real.h>
#include <anysl/vec.h>

//===-- Types ---------------------------------------------------------------------------------===//

using anysl_color = anysl::Rgb<anysl_float>;
using anysl_vector = anysl::Vec<anysl_float>;
using anysl_point = anysl_vector;
using anysl_normal = anysl_vector;
using anysl_matrix = anysl::Mat<anysl_float>;
/// Null-terminated text that nobody frees. A null pointer counts as the empty text.
using anysl_string = const char *;

/// What a runtime knows about the point being shaded; each interface runtime defines its own.
struct anysl_context;

extern "C" {

/// One variable per type, `anysl_type_vector` and so on: the linker reads a type's size from it.
#define STC_TYPE(id, name, components, meaning) extern anysl_##name anysl_type_##name;
#include <anysl/Types.def>

//===-- Operators -----------------------------------------------------------------------------===//

#define None void
#define Test bool
#define In(T) const anysl_##T *
#define Out(T) anysl_##T *
#define InOut(T) anysl_##T *
#define Array(T) anysl_##T *
#define Ctx anysl_context *
#define Type const void *
#define Slot void *
#define Bool bool
#define Index int32_t
#define Length uint32_t
#define Id uint32_t
#define Number double
#define Text const char *
#define STC_OP(id, name, result, parameters, purity, rule, effect, service, meaning)               \
  result anysl_##name parameters;
#include <anysl/StcOps.def>
#undef None
#undef Test
#undef In
#undef Out
#undef InOut
#undef Array
#undef Ctx
#undef Type
#undef Slot
#undef Bool
#undef Index
#undef Length
#undef Id
#undef Number
#undef Text

//===-- What a real says of itself ------------------------------------------------------------===//

/// The number format of a host's arrays.
extern const AnyslReal anysl_real_format;
/// Whether numbers carry their derivatives along.
extern const bool anysl_real_has_derivatives;
/// Whether code with this real shades one point at a time only.
extern const bool anysl_real_is_scalar;
/// A derivative of higher order than the real carries. The linker, which defines it as 0, sees
/// whether it is still read in the end.
__attribute__((const)) anysl_number anysl_unknown_derivative(void);

//===-- Hooks ---------------------------------------------------------------------------------===//

/// The shader. The linker puts it here.
void anysl_shader_body(anysl_context *);
/// The defaults of the shader's parameters. The linker puts them here.
void anysl_shader_init(anysl_context *);
/// An interface runtime defines these: make a context and call the function above.
void anysl_runtime_shade_point(const AnyslShadeArgs *args, uint32_t point);
void anysl_runtime_init(const AnyslShadeArgs *args);
/// How this runtime finds the globals of a point.
extern const AnyslLayout anysl_runtime_layout;
/// Whether it looks for ANYSL_PARAM_HALF.
extern const bool anysl_runtime_reads_half;

} // extern "C"

/// Names a wide form of the function that follows, for widening to call instead of the scalar form
/// once per lane. `mangled` is the vector function ABI's name and `variant` the function that it
/// stands for:
///
///     ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M8lvvl4_renderer_ask", renderer_ask_8)
///     void renderer_ask(uint32_t point, float a, float b, float *result);
///
/// The linker turns these annotations into the attribute "vector-function-abi-variant".
#define ANYSL_VECTOR_VARIANT(mangled, variant)                                                     \
  __attribute__((annotate("anysl.vector_variant:" mangled "(" #variant ")")))

#endif // ANYSL_RUNTIME_H
