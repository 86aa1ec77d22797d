//===-- anysl/standard/alike.h - which points ask a renderer the same -------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_ALIKE_H
#define ANYSL_STANDARD_ALIKE_H

#include <stdint.h>

namespace anysl {

inline bool isAlike(float a, float b) { return a == b; }

/// A text that may be missing, in place of which there is an empty one.
inline const char *orEmpty(const char *text) { return text ? text : ""; }

/// Texts may be null.
inline bool isAlike(const char *a, const char *b) {
  if (a == b || !a || !b)
    return a == b;
  for (; *a && *a == *b; ++a, ++b)
    ;
  return *a == *b;
}

/// Those points of `mask`, of `width`, for which all numbers and texts are those of the first one
/// in it, itself always among them. Of points that are not in the mask values may be anything.
template <typename... T>
[[gnu::always_inline]] inline uint32_t likeFirst(uint32_t mask, uint32_t width,
                                                 const T *const... values) {
  uint32_t first = uint32_t(__builtin_ctz(mask)), alike = 0;
  // Nearly always all are, to the very addresses of the texts: no branches for that.
  for (uint32_t i = 0; i < width; ++i)
    alike |= uint32_t((... & (values[i] == values[first]))) << i;
  alike = (alike & mask) | 1u << first;
  for (uint32_t others = mask & ~alike; others; others &= others - 1) {
    uint32_t i = uint32_t(__builtin_ctz(others));
    alike |= uint32_t((... && isAlike(values[i], values[first]))) << i;
  }
  return alike;
}

} // namespace anysl

#endif // ANYSL_STANDARD_ALIKE_H
