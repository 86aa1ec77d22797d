//===-- benchmarks/by-hand/plastic.cpp - examples/shaders/plastic.sl, by hand -----------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "ByHand.h"

#include <anysl/domain.h>

using namespace by_hand;

namespace {

enum Cell { Ka, Kd, Ks, roughness, specularcolor };

anysl_float numberOf(anysl_context *context, Cell cell) {
  return anysl_float(context->args->params[cell].number);
}

anysl_float largerOf(anysl_float a, anysl_float b) {
  anysl_float result;
  anysl_max_float(&result, &a, &b);
  return result;
}

anysl_float smallerOf(anysl_float a, anysl_float b) {
  anysl_float result;
  anysl_min_float(&result, &a, &b);
  return result;
}

/// Calls body(light, L, Cl) for each light in the hemisphere about N.
template <typename Body>
void illuminance(anysl_context *context, const anysl_point &P, const anysl_normal &N, Body body) {
  anysl_float rightAngle(1.57079632679489662);
  for (int32_t i = 0, count = anysl_light_count(context); i < count; ++i) {
    anysl_vector L;
    anysl_color Cl, Ol;
    if (anysl_light_sample(context, i, &P, &N, &L, &Cl, &Ol) && anysl_in_cone(&L, &N, &rightAngle))
      body(i, L, Cl);
  }
}

void add(anysl_color &sum, const anysl_color &a) {
  sum = anysl::each([](anysl_float x, anysl_float y) { return x + y; }, sum, a);
}

} // namespace

void anysl_shader_body(anysl_context *context) {
  anysl_point P = vectorOf<ANYSL_P>(context);
  anysl_vector I = vectorOf<ANYSL_I>(context);
  anysl_normal N = normalize(vectorOf<ANYSL_N>(context));
  anysl_normal Nf = dot(I, N) > 0 ? -N : N;
  anysl_vector V = -normalize(I);
  anysl_float exponent =
      anysl::divide(anysl_float(1), largerOf(numberOf(context, roughness), anysl_float(1e-8)));

  anysl_color diffuse = {}, specular = {};
  illuminance(context, P, Nf, [&](int32_t light, const anysl_vector &L, const anysl_color &Cl) {
    if (!anysl_light_is_nondiffuse(context, light, &P, &Nf))
      add(diffuse, Cl * largerOf(0, dot(normalize(L), Nf)));
  });
  illuminance(context, P, Nf, [&](int32_t light, const anysl_vector &L, const anysl_color &Cl) {
    if (anysl_light_is_nonspecular(context, light, &P, &Nf))
      return;
    anysl_float c = dot(Nf, normalize(normalize(L) + V));
    c = smallerOf(largerOf(c, 0), 1);
    add(specular, Cl * anysl::power(c, exponent));
  });

  anysl_color sum, Cs = colorOf<ANYSL_Cs>(context), Os = colorOf<ANYSL_Os>(context), tint;
  anysl_normal given = vectorOf<ANYSL_N>(context);
  anysl_ambient(&sum, context, &P, &given);
  sum = sum * numberOf(context, Ka);
  add(sum, diffuse * numberOf(context, Kd));
  sum = Cs * sum;
  anysl_load_param_color(&tint, context, specularcolor);
  add(sum, tint * numberOf(context, Ks) * specular);
  sum = Os * sum;
  anysl_store_global_color(context, ANYSL_Oi, &Os);
  anysl_store_global_color(context, ANYSL_Ci, &sum);
}

static const AnyslParamInfo params[] = {{"Ka", ANYSL_FLOAT, 0, 0, Ka},
                                        {"Kd", ANYSL_FLOAT, 0, 0, Kd},
                                        {"Ks", ANYSL_FLOAT, 0, 0, Ks},
                                        {"roughness", ANYSL_FLOAT, 0, 0, roughness},
                                        {"specularcolor", ANYSL_COLOR, 0, 0, specularcolor}};
static const double defaults[] = {1, 0.5, 0.5, 0.1, 1, 1, 1};
BY_HAND_LIBRARY("plastic", params, 5, defaults, 7u);
