//===-- runtimes/scalar/inputs.cpp - globals and varying parameters as arrays of structures ---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// A point is one structure of ANYSL_COMPONENT_COUNT reals, which holds its uniform globals too.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/standard/context.h>

using namespace anysl;

namespace {

anysl_number &number(const anysl_context *context, uint32_t component, uint32_t) {
  auto *points = static_cast<anysl_number *>(context->args->globals[0]);
  return points[size_t(context->point) * ANYSL_COMPONENT_COUNT + component];
}

/// Component number `component` of an element of a parameter given point by point, where a type has
/// `components` of them.
template <int components>
anysl_number &varying(const anysl_context *context, uint32_t id, uint32_t element, int component) {
  const AnyslShadeArgs *args = context->args;
  auto *values = static_cast<anysl_number *>(args->param_data[id]);
  return values[(size_t(element) * args->data_stride + context->point) * components + component];
}

bool isWanted(const anysl_context *context, uint32_t id) {
  void *const *data = context->args->param_data;
  return data && data[id];
}

} // namespace

#include <anysl/standard/inputs.h>
