//===-- benchmarks/by-hand/mirror.cpp - examples/shaders/mirror.sl, by hand -------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "ByHand.h"

using namespace by_hand;

void anysl_shader_body(anysl_context *context) {
  anysl_point P = vectorOf<ANYSL_P>(context);
  anysl_vector direction = reflect(vectorOf<ANYSL_I>(context), vectorOf<ANYSL_N>(context));
  anysl_color Ci;
  anysl_trace_color(&Ci, context, &P, &direction);
  anysl_store_global_color(context, ANYSL_Ci, &Ci);
  anysl_color Oi = opaque();
  anysl_store_global_color(context, ANYSL_Oi, &Oi);
}

static const double *const none = nullptr;
BY_HAND_LIBRARY("mirror", nullptr, 0, none, 0u);
