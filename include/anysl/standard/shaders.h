//===-- anysl/standard/shaders.h - methods of other shaders -----------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_SHADERS_H
#define ANYSL_STANDARD_SHADERS_H

#include <anysl/standard/message.h>

namespace {

[[gnu::noinline]] bool callMethod(const AnyslShadeArgs *args, uint32_t point, const char *shader,
                                  const char *what, anysl_float *numbers, uint32_t numberCount,
                                  anysl_string *texts, uint32_t textCount) {
  // No shader has the empty name: null is not asked about.
  auto call = args->services->call_method;
  if (!call || !shader || !*shader)
    return false;
  return anysl::withMessage(what, numbers, numberCount, texts, textCount,
                            [&](AnyslMessage &message) {
                              bool done = call(args->renderer, args, point, shader, &message) != 0;
                              anysl::takeBack(message, numbers, texts);
                              return done;
                            });
}

/// `const`: the same for all points, whatever shaders do; see standard/spaces.h.
[[gnu::const, gnu::noinline]] const char *shaderName(const AnyslShadeArgs *args,
                                                     const char *category, uint32_t index) {
  auto name = args->services->shader_name;
  return name ? name(args->renderer, args, category, index) : nullptr;
}

} // namespace

bool anysl_call_method(anysl_context *context, const anysl_string *shader, const anysl_string *what,
                       anysl_float *numbers, uint32_t numberCount, anysl_string *texts,
                       uint32_t textCount) {
  return callMethod(context->args, context->point, *shader, *what, numbers, numberCount, texts,
                    textCount);
}

bool anysl_shader_name(anysl_string *result, anysl_context *context, const anysl_string *category,
                       int32_t index) {
  const char *name = shaderName(context->args, *category ? *category : "", uint32_t(index));
  *result = name ? name : "";
  return name != nullptr;
}

#endif // ANYSL_STANDARD_SHADERS_H
