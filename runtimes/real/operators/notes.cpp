//===-- runtimes/real/operators/notes.cpp - what notes say of values --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The functions by which the linker looks at values where notes are asked for (lib/Link/Notes.cpp):
// of each type that consists of numbers, anysl_is_finite_<type> and anysl_number_of_<type>, and of
// a real with bounds anysl_low_of_<type> and anysl_high_of_<type> as well. Components are counted
// as they lie in memory.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/runtime.h>

using namespace anysl;

namespace {

template <typename T>
const anysl_float &component(const T *value, uint32_t i) {
  return reinterpret_cast<const anysl_float *>(value)[i];
}

template <typename T>
bool areFinite(const T *value) {
  bool finite = true;
  repeat<sizeof(T) / sizeof(anysl_float)>(
      [&](auto i) { finite = finite & isFinite(valueOf(component(value, i))); });
  return finite;
}

} // namespace

#define NOTED_TYPE(T)                                                                              \
  extern "C" bool anysl_is_finite_##T(const anysl_##T *);                                          \
  bool anysl_is_finite_##T(const anysl_##T *value) { return areFinite(value); }                    \
  extern "C" double anysl_number_of_##T(const anysl_##T *, uint32_t);                              \
  double anysl_number_of_##T(const anysl_##T *value, uint32_t i) {                                 \
    return double(numberOf(component(value, i)));                                                  \
  }

NOTED_TYPE(float)
NOTED_TYPE(color)
NOTED_TYPE(vector)
NOTED_TYPE(matrix)
