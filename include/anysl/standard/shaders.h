//===-- anysl/standard/shaders.h - methods of other shaders -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_SHADERS_H
#define ANYSL_STANDARD_SHADERS_H

#include <anysl/standard/context.h>

namespace {

[[gnu::noinline]] int callMethod(const AnyslShadeArgs *args, uint32_t point, const char *shader,
                                 const char *method, double *values) {
  auto call = args->services->call_method;
  return call ? call(args->renderer, args, point, shader, method, values) : 0;
}

/// `const`: the same for all points, whatever shaders do; see standard/spaces.h.
[[gnu::const, gnu::noinline]] const char *shaderName(const AnyslShadeArgs *args,
                                                     const char *category, uint32_t index) {
  auto name = args->services->shader_name;
  return name ? name(args->renderer, args, category, index) : nullptr;
}

} // namespace

bool anysl_call_method(anysl_context *context, const anysl_string *shader,
                       const anysl_string *method, anysl_matrix *a, anysl_matrix *b) {
  double values[32];
  anysl::repeat<16>([&](auto k) {
    values[int(k)] = double(a->m[k / 4][k % 4]);
    values[16 + int(k)] = double(b->m[k / 4][k % 4]);
  });
  // No shader has the empty name: null is not asked about.
  const char *name = *shader ? *shader : "";
  bool done =
      *name && callMethod(context->args, context->point, name, *method ? *method : "", values);
  anysl::repeat<16>([&](auto k) {
    a->m[k / 4][k % 4] = anysl_float(values[int(k)]);
    b->m[k / 4][k % 4] = anysl_float(values[16 + int(k)]);
  });
  return done;
}

bool anysl_shader_name(anysl_string *result, anysl_context *context, const anysl_string *category,
                       int32_t index) {
  const char *name = shaderName(context->args, *category ? *category : "", uint32_t(index));
  *result = name ? name : "";
  return name != nullptr;
}

#endif // ANYSL_STANDARD_SHADERS_H
