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

#include <anysl/standard/context.h>

namespace {

constexpr double farAway = 1e30; // what a ray that the renderer does not trace has travelled

__attribute__((noinline)) void scalarTrace(const AnyslShadeArgs *args, uint32_t point,
                                           anysl_float px, anysl_float py, anysl_float pz,
                                           anysl_float rx, anysl_float ry, anysl_float rz,
                                           anysl_float *r, anysl_float *g, anysl_float *b) {
  double P[3] = {px, py, pz}, R[3] = {rx, ry, rz}, color[3] = {0, 0, 0};
  if (args->services->trace)
    args->services->trace(args->renderer, args, point, P, R, color);
  *r = anysl_float(color[0]), *g = anysl_float(color[1]), *b = anysl_float(color[2]);
}

__attribute__((noinline)) void scalarTransmission(const AnyslShadeArgs *args, uint32_t point,
                                                  anysl_float fx, anysl_float fy, anysl_float fz,
                                                  anysl_float tx, anysl_float ty, anysl_float tz,
                                                  anysl_float *r, anysl_float *g, anysl_float *b) {
  double from[3] = {fx, fy, fz}, to[3] = {tx, ty, tz}, color[3] = {1, 1, 1};
  if (args->services->transmission)
    args->services->transmission(args->renderer, args, point, from, to, color);
  *r = anysl_float(color[0]), *g = anysl_float(color[1]), *b = anysl_float(color[2]);
}

__attribute__((noinline)) anysl_float scalarTraceDistance(const AnyslShadeArgs *args,
                                                          uint32_t point, anysl_float px,
                                                          anysl_float py, anysl_float pz,
                                                          anysl_float rx, anysl_float ry,
                                                          anysl_float rz) {
  double P[3] = {px, py, pz}, R[3] = {rx, ry, rz};
  return anysl_float(args->services->trace_distance
                         ? args->services->trace_distance(args->renderer, args, point, P, R)
                         : farAway);
}

} // namespace

void anysl_trace_color(anysl_color *result, anysl_context *context, const anysl_point *P,
                       const anysl_vector *R) {
  anysl_color color;
  scalarTrace(context->args, context->point, P->x, P->y, P->z, R->x, R->y, R->z, &color.r, &color.g,
              &color.b);
  *result = color;
}

void anysl_trace_float(anysl_float *result, anysl_context *context, const anysl_point *P,
                       const anysl_vector *R) {
  *result = scalarTraceDistance(context->args, context->point, P->x, P->y, P->z, R->x, R->y, R->z);
}

void anysl_transmission(anysl_color *result, anysl_context *context, const anysl_point *from,
                        const anysl_point *to) {
  anysl_color color;
  scalarTransmission(context->args, context->point, from->x, from->y, from->z, to->x, to->y, to->z,
                     &color.r, &color.g, &color.b);
  *result = color;
}
