//===-- runtimes/packet/inputs.cpp - globals and varying parameters as structures of arrays ---===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Component c of a point is array c's element number `point`: consecutive points lie next to each
// other, so widened code loads and stores whole vectors.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/standard/context.h>

using namespace anysl;

namespace {

anysl_number &number(const anysl_context *context, uint32_t component, uint32_t step) {
  auto *array = static_cast<anysl_number *>(context->args->globals[component]);
  return array[size_t(context->point) * step];
}

template <int components, class Number = anysl_number>
Number &inArrays(const anysl_context *context, void *const *arrays, uint32_t id, uint32_t element,
                 int component) {
  const AnyslShadeArgs *args = context->args;
  auto *values = static_cast<Number *>(arrays[id]);
  return values[(size_t(element) * components + component) * args->data_stride + context->point];
}

} // namespace

#include <anysl/standard/inputs.h>
