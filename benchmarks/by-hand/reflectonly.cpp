//===-- benchmarks/by-hand/reflectonly.cpp - examples/shaders/reflectonly.sl, by hand ---------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "ByHand.h"

using namespace by_hand;

void anysl_shader_body(anysl_context *context) {
  anysl_vector R = reflect(vectorOf<ANYSL_I>(context), vectorOf<ANYSL_N>(context));
  anysl_color Ci = {R.x, R.y, R.z};
  anysl_store_global_color(context, ANYSL_Ci, &Ci);
}

static const double *const none = nullptr;
BY_HAND_LIBRARY("reflectonly", nullptr, 0, none, 0u);
