//===-- anysl/standard/spaces.h - named coordinate systems ------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_SPACES_H
#define ANYSL_STANDARD_SPACES_H

#include <anysl/standard/context.h>

void anysl_space_matrix(anysl_matrix *result, anysl_context *context, const anysl_string *from,
                        const anysl_string *to) {
  double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const AnyslShadeArgs *args = context->args;
  if (args->services->space_matrix)
    args->services->space_matrix(args->renderer, args, *from, *to, matrix);
  anysl::repeat<16>([&](auto k) { result->m[k / 4][k % 4] = anysl_float(matrix[k]); });
}

#endif // ANYSL_STANDARD_SPACES_H
