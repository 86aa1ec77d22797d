//===-- anysl/standard/hooks.h - from a batch to the shader's own functions -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_HOOKS_H
#define ANYSL_STANDARD_HOOKS_H

#include <anysl/standard/context.h>

void anysl_runtime_shade_point(const AnyslShadeArgs *args, uint32_t point) {
  // Loaded whether or not the shader draws numbers: where it does not, nothing of this is left.
  uint32_t seed = args->seeds ? args->seeds[point] : point;
  anysl_context context = {args, point, anysl::mixBits(seed + anysl::goldenStep)};
  anysl_shader_body(&context);
}

void anysl_runtime_init(const AnyslShadeArgs *args) {
  anysl_context context = {args, 0, 0};
  anysl_shader_init(&context);
}

#endif // ANYSL_STANDARD_HOOKS_H
