//===-- benchmarks/by-hand/ByHand.h - a shader library written in C++ -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// What the author of a renderer would write instead of using AnySL: the shader as a C++ function over the
// packet runtime's own types, compiled by clang with link-time optimisation into a library that the
// benchmark opens like any other. Vectorisation is off, as in the linked code of width 1.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_BENCHMARKS_BY_HAND_BYHAND_H
#define ANYSL_BENCHMARKS_BY_HAND_BYHAND_H

#include <anysl/standard/context.h>

namespace by_hand {

template <uint32_t id>
inline anysl_vector vectorOf(anysl_context *context) {
  anysl_vector result;
  anysl_load_global_vector(&result, context, id);
  return result;
}

template <uint32_t id>
inline anysl_color colorOf(anysl_context *context) {
  anysl_color result;
  anysl_load_global_color(&result, context, id);
  return result;
}

inline anysl_vector normalize(const anysl_vector &v) {
  anysl_vector result;
  anysl_normalize(&result, &v);
  return result;
}

inline anysl_color opaque() { return {1, 1, 1}; }

/// I - 2 (I.N) N
inline anysl_vector reflect(const anysl_vector &I, const anysl_vector &N) {
  return I - N * (2 * dot(I, N));
}

} // namespace by_hand

/// Exports the library: one surface shader whose body is anysl_shader_body. `paramTable` describes its
/// parameters, `defaults` has one number a cell; both are pointers with a count.
#define BY_HAND_LIBRARY(shaderName, paramTable, paramCount, defaults, cellCount)                   \
  static void shadeByHand(const AnyslShadeArgs *args, uint32_t first, uint32_t last) {             \
    for (uint32_t point = first; point < last; ++point)                                            \
      anysl_runtime_shade_point(args, point);                                                      \
  }                                                                                                \
  void anysl_shader_init(anysl_context *) {}                                                       \
  static void initByHand(const AnyslShadeArgs *args) {                                             \
    for (uint32_t cell = 0; cell < cellCount; ++cell)                                              \
      args->params[cell].number = defaults[cell];                                                  \
  }                                                                                                \
  static const AnyslEntryInfo entries[] = {{1, shadeByHand}};                                      \
  static const AnyslShaderInfo shaders[] = {                                                       \
      {shaderName, ANYSL_SURFACE, paramCount, paramTable, cellCount, 1, entries,                   \
       ~0ull >> (64 - ANYSL_GLOBAL_COUNT), 1ull << ANYSL_Ci | 1ull << ANYSL_Oi, 0, 0,              \
       initByHand}};                                                                               \
  extern "C" __attribute__((visibility("default"))) const AnyslLibraryInfo anysl_library = {       \
      ANYSL_MAGIC, ANYSL_ABI_VERSION, sizeof(AnyslLibraryInfo), ANYSL_LAYOUT_SOA,                  \
      ANYSL_REAL_FLOAT, ANYSL_GLOBAL_COUNT, ANYSL_COMPONENT_COUNT, sizeof(AnyslShadeArgs),         \
      sizeof(AnyslServices), 1, shaders, "by hand", "packet", "float", "u10", "native", ""}

#endif
