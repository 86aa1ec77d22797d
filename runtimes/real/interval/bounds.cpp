//===-- runtimes/real/interval/bounds.cpp - what notes say of bounds --------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The functions by which the linker asks for bounds and for conditions that these do not decide
// (lib/Link/Notes.cpp): anysl_is_undecided_<operator> of each operator that decides something.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/runtime.h>

using namespace anysl;

namespace {

template <typename T>
const Interval &component(const T *value, uint32_t i) {
  return reinterpret_cast<const Interval *>(value)[i];
}

template <typename T>
bool isEqualityUndecided(const T *a, const T *b) {
  Truth equal(true);
  for (uint32_t i = 0; i < sizeof(T) / sizeof(Interval); ++i)
    equal = equal & (component(a, i) == component(b, i));
  return !equal.isKnown();
}

} // namespace

extern "C" {

#define BOUNDED_TYPE(T)                                                                            \
  double anysl_low_of_##T(const anysl_##T *, uint32_t);                                            \
  double anysl_low_of_##T(const anysl_##T *x, uint32_t i) { return component(x, i).low; }          \
  double anysl_high_of_##T(const anysl_##T *, uint32_t);                                           \
  double anysl_high_of_##T(const anysl_##T *x, uint32_t i) { return component(x, i).high; }

BOUNDED_TYPE(float)
BOUNDED_TYPE(color)
BOUNDED_TYPE(vector)

#define COMPARISON(name, T, condition)                                                             \
  bool anysl_is_undecided_##name(const anysl_##T *, const anysl_##T *);                            \
  bool anysl_is_undecided_##name(const anysl_##T *a, const anysl_##T *b) { return condition; }

COMPARISON(lt_float, float, !(*a < *b).isKnown())
COMPARISON(le_float, float, !(*a <= *b).isKnown())
COMPARISON(gt_float, float, !(*a > *b).isKnown())
COMPARISON(ge_float, float, !(*a >= *b).isKnown())
COMPARISON(eq_float, float, isEqualityUndecided(a, b))
COMPARISON(ne_float, float, isEqualityUndecided(a, b))
COMPARISON(eq_color, color, isEqualityUndecided(a, b))
COMPARISON(ne_color, color, isEqualityUndecided(a, b))
COMPARISON(eq_vector, vector, isEqualityUndecided(a, b))
COMPARISON(ne_vector, vector, isEqualityUndecided(a, b))
COMPARISON(eq_matrix, matrix, isEqualityUndecided(a, b))
COMPARISON(ne_matrix, matrix, isEqualityUndecided(a, b))

bool anysl_is_undecided_index(const anysl_float *);
bool anysl_is_undecided_index(const anysl_float *x) { return !floorOf(*x).isPoint(); }
}
