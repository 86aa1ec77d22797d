//===-- anysl/standard/spaces.h - named coordinate systems ------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_SPACES_H
#define ANYSL_STANDARD_SPACES_H

#include <anysl/standard/context.h>

#ifndef __AVX__
#error "compile with -mavx: otherwise clang returns a row through memory"
#endif

namespace {

using MatrixRow = double __attribute__((ext_vector_type(4)));

/// A row of a matrix, which is the same for all points of a batch. `const` says so: nothing that a
/// shader does changes it. That, and a result by value instead of in memory (where each lane would
/// have a copy), lets widening ask once for all lanes, and the loop over the points once for all.
[[gnu::const, gnu::noinline]] MatrixRow spaceMatrixRow(const AnyslShadeArgs *args, const char *from,
                                                       const char *to, uint32_t row) {
  double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  if (args->services->space_matrix)
    args->services->space_matrix(args->renderer, args, from, to, matrix);
  const double *x = matrix + row * 4;
  return {x[0], x[1], x[2], x[3]};
}

} // namespace

void anysl_space_matrix(anysl_matrix *result, anysl_context *context, const anysl_string *from,
                        const anysl_string *to) {
  anysl::repeat<4>([&](auto i) {
    MatrixRow row = spaceMatrixRow(context->args, *from, *to, uint32_t(int(i)));
    anysl::repeat<4>([&](auto k) { result->m[i][k] = anysl_float(row[int(k)]); });
  });
}

#endif // ANYSL_STANDARD_SPACES_H
