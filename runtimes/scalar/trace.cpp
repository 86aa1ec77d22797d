//===-- runtimes/scalar/trace.cpp - rays, one by one ------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// These functions stay calls and have no wide form: widened code calls them once for each point
// that asks.
//
//===------------------------------------------------------------------------------------------===//

#include <anysl/standard/ray-change.h>

using namespace anysl;

namespace {

constexpr double farAway = 1e30; // what a ray that the renderer does not trace has travelled

/// `change` is how the ray changes (copyRayChange()); null: it is not known.
__attribute__((noinline)) void scalarTrace(const AnyslShadeArgs *args, uint32_t point,
                                           anysl_number px, anysl_number py, anysl_number pz,
                                           anysl_number rx, anysl_number ry, anysl_number rz,
                                           const float *change, anysl_number *r, anysl_number *g,
                                           anysl_number *b) {
  const AnyslServices *services = args->services;
  double color[3] = {0, 0, 0};
  if (change && services->trace_derivatives) {
    float x = float(px), y = float(py), z = float(pz);
    float X = float(rx), Y = float(ry), Z = float(rz), seen[3] = {0, 0, 0};
    const float *const P[3] = {&x, &y, &z}, *const R[3] = {&X, &Y, &Z};
    float *const found[3] = {seen, seen + 1, seen + 2};
    AnyslRayDerivatives derivatives = rayDerivatives(change);
    services->trace_derivatives(args->renderer, args, point, 1, 1, P, R, &derivatives, found);
    for (int c = 0; c < 3; ++c)
      color[c] = double(seen[c]);
  } else if (services->trace) {
    double P[3] = {px, py, pz}, R[3] = {rx, ry, rz};
    services->trace(args->renderer, args, point, P, R, color);
  }
  *r = anysl_number(color[0]), *g = anysl_number(color[1]), *b = anysl_number(color[2]);
}

__attribute__((noinline)) void scalarTransmission(const AnyslShadeArgs *args, uint32_t point,
                                                  anysl_number fx, anysl_number fy, anysl_number fz,
                                                  anysl_number tx, anysl_number ty, anysl_number tz,
                                                  anysl_number *r, anysl_number *g,
                                                  anysl_number *b) {
  double from[3] = {fx, fy, fz}, to[3] = {tx, ty, tz}, color[3] = {1, 1, 1};
  if (args->services->transmission)
    args->services->transmission(args->renderer, args, point, from, to, color);
  *r = anysl_number(color[0]), *g = anysl_number(color[1]), *b = anysl_number(color[2]);
}

__attribute__((noinline)) anysl_number scalarTraceDistance(const AnyslShadeArgs *args,
                                                           uint32_t point, anysl_number px,
                                                           anysl_number py, anysl_number pz,
                                                           anysl_number rx, anysl_number ry,
                                                           anysl_number rz) {
  double P[3] = {px, py, pz}, R[3] = {rx, ry, rz};
  return anysl_number(args->services->trace_distance
                          ? args->services->trace_distance(args->renderer, args, point, P, R)
                          : farAway);
}

} // namespace

void anysl_trace_color(anysl_color *result, anysl_context *context, const anysl_point *P,
                       const anysl_vector *R) {
  anysl_number r, g, b;
  float change[rayChangeCount];
  if constexpr (hasDerivatives<anysl_float>)
    copyRayChange(context, *P, *R, change);
  scalarTrace(context->args, context->point, numberOf(P->x), numberOf(P->y), numberOf(P->z),
              numberOf(R->x), numberOf(R->y), numberOf(R->z),
              raysCarryDerivatives() ? change : nullptr, &r, &g, &b);
  *result = {r, g, b};
}

void anysl_trace_float(anysl_float *result, anysl_context *context, const anysl_point *P,
                       const anysl_vector *R) {
  *result = scalarTraceDistance(context->args, context->point, numberOf(P->x), numberOf(P->y),
                                numberOf(P->z), numberOf(R->x), numberOf(R->y), numberOf(R->z));
}

void anysl_transmission(anysl_color *result, anysl_context *context, const anysl_point *from,
                        const anysl_point *to) {
  anysl_number r, g, b;
  scalarTransmission(context->args, context->point, numberOf(from->x), numberOf(from->y),
                     numberOf(from->z), numberOf(to->x), numberOf(to->y), numberOf(to->z), &r, &g,
                     &b);
  *result = {r, g, b};
}
