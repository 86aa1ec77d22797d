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

template <int components, class Number = anysl_number>
Number &inArrays(const anysl_context *context, void *const *arrays, uint32_t id, uint32_t element,
                 int component) {
  const AnyslShadeArgs *args = context->args;
  auto *values = static_cast<Number *>(arrays[id]);
  return values[(size_t(element) * args->data_stride + context->point) * components + component];
}

} // namespace

#include <anysl/standard/inputs.h>
