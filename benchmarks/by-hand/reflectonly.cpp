//===-- benchmarks/by-hand/reflectonly.cpp - examples/shaders/reflectonly.sl, by hand ---------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "ByHand.h"

using namespace by_hand;

void anysl_shader_body(anysl_context *context) {
  anysl_vector I = vectorOf<ANYSL_I>(context);
  anysl_normal N = normalize(vectorOf<ANYSL_N>(context));
  anysl_normal Nf = dot(I, N) > 0 ? -N : N;
  anysl_vector R = reflect(normalize(I), Nf);
  anysl_float half(0.5);
  anysl_color Ci = {half + half * R.x, half + half * R.y, half + half * R.z};
  anysl_store_global_color(context, ANYSL_Ci, &Ci);
  anysl_color Oi = opaque();
  anysl_store_global_color(context, ANYSL_Oi, &Oi);
}

static const double *const none = nullptr;
BY_HAND_LIBRARY("reflectonly", nullptr, 0, none, 0u);
