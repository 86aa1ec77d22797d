//===-- anysl/standard/random.h - each point's own sequence of random numbers -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Number k of a point is mixBits(mixBits(seed + goldenStep) + k * goldenStep), that is Weyl's
// sequence through a permutation. It depends on the point's seed and on how many numbers the point
// has drawn, so it is the same at every width, thread count and real; numbers have 24 bits for that
// reason too.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_RANDOM_H
#define ANYSL_STANDARD_RANDOM_H

#include <anysl/standard/context.h>

namespace anysl {

inline anysl_float nextRandom(anysl_context *context) {
  uint32_t state = context->random;
  context->random = state + goldenStep;
  return unitFromBits(mixBits(state));
}

} // namespace anysl

void anysl_random_float(anysl_float *result, anysl_context *context) {
  *result = anysl::nextRandom(context);
}

void anysl_random_color(anysl_color *result, anysl_context *context) {
  result->r = anysl::nextRandom(context);
  result->g = anysl::nextRandom(context);
  result->b = anysl::nextRandom(context);
}

void anysl_random_vector(anysl_vector *result, anysl_context *context) {
  result->x = anysl::nextRandom(context);
  result->y = anysl::nextRandom(context);
  result->z = anysl::nextRandom(context);
}

#endif // ANYSL_STANDARD_RANDOM_H
