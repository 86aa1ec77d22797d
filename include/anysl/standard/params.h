//===-- anysl/standard/params.h - uniform parameters, in cells --------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_PARAMS_H
#define ANYSL_STANDARD_PARAMS_H

#include <anysl/standard/context.h>

namespace anysl {

inline anysl_float loadCell(const anysl_context *context, uint32_t cell) {
  return anysl_float(context->args->params[cell].number);
}

inline void storeCell(const anysl_context *context, uint32_t cell, const anysl_float &x) {
  context->args->params[cell].number = double(numberOf(x));
}

} // namespace anysl

void anysl_load_param_float(anysl_float *result, anysl_context *context, uint32_t cell) {
  *result = anysl::loadCell(context, cell);
}

void anysl_load_param_color(anysl_color *result, anysl_context *context, uint32_t cell) {
  *result = {anysl::loadCell(context, cell), anysl::loadCell(context, cell + 1),
             anysl::loadCell(context, cell + 2)};
}

void anysl_load_param_vector(anysl_vector *result, anysl_context *context, uint32_t cell) {
  *result = {anysl::loadCell(context, cell), anysl::loadCell(context, cell + 1),
             anysl::loadCell(context, cell + 2)};
}

void anysl_load_param_matrix(anysl_matrix *result, anysl_context *context, uint32_t cell) {
  anysl::repeat<16>([&](auto k) { result->m[k / 4][k % 4] = anysl::loadCell(context, cell + k); });
}

void anysl_load_param_string(anysl_string *result, anysl_context *context, uint32_t cell) {
  *result = context->args->params[cell].string;
}

void anysl_store_param_float(anysl_context *context, uint32_t cell, const anysl_float *a) {
  anysl::storeCell(context, cell, *a);
}

void anysl_store_param_color(anysl_context *context, uint32_t cell, const anysl_color *a) {
  anysl::storeCell(context, cell, a->r);
  anysl::storeCell(context, cell + 1, a->g);
  anysl::storeCell(context, cell + 2, a->b);
}

void anysl_store_param_vector(anysl_context *context, uint32_t cell, const anysl_vector *a) {
  anysl::storeCell(context, cell, a->x);
  anysl::storeCell(context, cell + 1, a->y);
  anysl::storeCell(context, cell + 2, a->z);
}

void anysl_store_param_matrix(anysl_context *context, uint32_t cell, const anysl_matrix *a) {
  anysl::repeat<16>([&](auto k) { anysl::storeCell(context, cell + k, a->m[k / 4][k % 4]); });
}

void anysl_store_param_string(anysl_context *context, uint32_t cell, const anysl_string *a) {
  context->args->params[cell].string = *a;
}

bool anysl_param_is_set(anysl_context *context, uint32_t id) {
  return context->args->param_is_set[id] != 0;
}

bool anysl_param_is_bound(anysl_context *context, uint32_t id) {
  void *const *data = context->args->param_data;
  return data && data[id] && !(context->args->param_is_set[id] & ANYSL_PARAM_ONLY_OUT);
}

#endif // ANYSL_STANDARD_PARAMS_H
