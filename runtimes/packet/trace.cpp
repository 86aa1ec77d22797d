//===-- runtimes/packet/trace.cpp - rays, one by one and in packets ---------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Each service of the renderer is wrapped in a scalar function that stays a call until widening
// replaces it by its wide form. The wide form receives one vector per component and the mask of
// asking points as an integer, lays the vectors out as AnyslServices wants them, and calls the
// renderer once. Results come back through pointers: each points to one real per point, points next
// to each other.
//
//===------------------------------------------------------------------------------------------===//

#include "packet.h"
#include <anysl/standard/ray-change.h>

using namespace anysl;

namespace {

constexpr double farAway = 1e30; // what a ray that the renderer does not trace has travelled

} // namespace

//===-- One point -----------------------------------------------------------------------------===//

namespace {

using Ray = void(const AnyslShadeArgs *args, uint32_t point, float px, float py, float pz, float rx,
                 float ry, float rz, float *r, float *g, float *b);
using Distance = float(const AnyslShadeArgs *args, uint32_t point, float px, float py, float pz,
                       float rx, float ry, float rz);

} // namespace

extern "C" {

ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M4ulvvvvvvl4l4l4_packet_trace", packet_trace_4)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M8ulvvvvvvl4l4l4_packet_trace", packet_trace_8)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M16ulvvvvvvl4l4l4_packet_trace", packet_trace_16)
__attribute__((noinline)) Ray packet_trace;

ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M4ulvvvvvvl4l4l4_packet_transmission", packet_transmission_4)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M8ulvvvvvvl4l4l4_packet_transmission", packet_transmission_8)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M16ulvvvvvvl4l4l4_packet_transmission", packet_transmission_16)
__attribute__((noinline)) Ray packet_transmission;

ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M4ulvvvvvv_packet_trace_distance", packet_trace_distance_4)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M8ulvvvvvv_packet_trace_distance", packet_trace_distance_8)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M16ulvvvvvv_packet_trace_distance", packet_trace_distance_16)
__attribute__((noinline)) Distance packet_trace_distance;

// With how the ray changes; by address, as in standard/hit-call.h.
#define TRACE_PARAMETERS                                                                           \
  const AnyslShadeArgs *args, uint32_t point, const float *px, const float *py, const float *pz,   \
      const float *rx, const float *ry, const float *rz, ANYSL_CHANGE_PARAMETERS, float *r,        \
      float *g, float *b
#define TRACE_LETTERS "ull4l4l4l4l4l4" ANYSL_CHANGE_LETTERS "l4l4l4"
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M4" TRACE_LETTERS "_packet_trace_change", packet_trace_change_4)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M8" TRACE_LETTERS "_packet_trace_change", packet_trace_change_8)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M16" TRACE_LETTERS "_packet_trace_change", packet_trace_change_16)
__attribute__((noinline)) void packet_trace_change(TRACE_PARAMETERS);

} // extern "C"

void packet_trace(const AnyslShadeArgs *args, uint32_t point, float px, float py, float pz,
                  float rx, float ry, float rz, float *r, float *g, float *b) {
  double P[3] = {px, py, pz}, R[3] = {rx, ry, rz}, color[3] = {0, 0, 0};
  if (args->services->trace)
    args->services->trace(args->renderer, args, point, P, R, color);
  *r = float(color[0]), *g = float(color[1]), *b = float(color[2]);
}

void packet_transmission(const AnyslShadeArgs *args, uint32_t point, float fx, float fy, float fz,
                         float tx, float ty, float tz, float *r, float *g, float *b) {
  double from[3] = {fx, fy, fz}, to[3] = {tx, ty, tz}, color[3] = {1, 1, 1};
  if (args->services->transmission)
    args->services->transmission(args->renderer, args, point, from, to, color);
  *r = float(color[0]), *g = float(color[1]), *b = float(color[2]);
}

float packet_trace_distance(const AnyslShadeArgs *args, uint32_t point, float px, float py,
                            float pz, float rx, float ry, float rz) {
  double P[3] = {px, py, pz}, R[3] = {rx, ry, rz};
  const AnyslServices *services = args->services;
  return float(services->trace_distance
                   ? services->trace_distance(args->renderer, args, point, P, R)
                   : farAway);
}

void packet_trace_change(TRACE_PARAMETERS) {
  const float *const P[3] = {px, py, pz}, *const R[3] = {rx, ry, rz};
  float *const color[3] = {r, g, b};
  AnyslRayDerivatives change = rayDerivatives(ANYSL_CHANGE_ARGUMENTS);
  if (args->services->trace_derivatives)
    args->services->trace_derivatives(args->renderer, args, point, 1, 1, P, R, &change, color);
  else
    packet_trace(args, point, *px, *py, *pz, *rx, *ry, *rz, r, g, b);
}

//===-- W points ------------------------------------------------------------------------------===//

namespace {

template <int W, typename Mask>
using WideRay = void(const AnyslShadeArgs *args, uint32_t first, Lanes<W> px, Lanes<W> py,
                     Lanes<W> pz, Lanes<W> rx, Lanes<W> ry, Lanes<W> rz, float *r, float *g,
                     float *b, Mask mask);
template <int W, typename Mask>
using WideDistance = Lanes<W>(const AnyslShadeArgs *args, uint32_t first, Lanes<W> px, Lanes<W> py,
                              Lanes<W> pz, Lanes<W> rx, Lanes<W> ry, Lanes<W> rz, Mask mask);
using PacketService = decltype(AnyslServices::trace_packet);

/// Asks the packet form of a service or, where the renderer has none, the scalar form point by
/// point.
template <int W>
void ask(PacketService service, Ray &scalar, const AnyslShadeArgs *args, uint32_t first,
         uint32_t mask, Packet<W> P, Packet<W> R, float *r, float *g, float *b) {
  if (service) {
    Packet<W> color;
    service(args->renderer, args, first, W, mask, P.data(), R.data(), color.data());
    store<W>(r, color.get(0));
    store<W>(g, color.get(1));
    store<W>(b, color.get(2));
    return;
  }
  const auto &p = P.component, &q = R.component;
  for (uint32_t i = 0; i < W; ++i)
    if (mask & (1u << i))
      scalar(args, first + i, p[0][i], p[1][i], p[2][i], q[0][i], q[1][i], q[2][i], r + i, g + i,
             b + i);
}

template <int W>
Lanes<W> askDistance(const AnyslShadeArgs *args, uint32_t first, uint32_t mask, Packet<W> P,
                     Packet<W> R) {
  alignas(64) float distance[W] = {};
  const AnyslServices *services = args->services;
  const auto &p = P.component, &q = R.component;
  if (services->trace_distance_packet)
    services->trace_distance_packet(args->renderer, args, first, W, mask, P.data(), R.data(),
                                    distance);
  else
    for (uint32_t i = 0; i < W; ++i)
      if (mask & (1u << i))
        distance[i] = packet_trace_distance(args, first + i, p[0][i], p[1][i], p[2][i], q[0][i],
                                            q[1][i], q[2][i]);
  return load<W>(distance);
}

template <int W>
void askWithChange(TRACE_PARAMETERS, uint32_t mask) {
  const AnyslServices *services = args->services;
  if (!services->trace_derivatives)
    return ask<W>(services->trace_packet, packet_trace, args, point, mask,
                  {load<W>(px), load<W>(py), load<W>(pz)}, {load<W>(rx), load<W>(ry), load<W>(rz)},
                  r, g, b);
  const float *const P[3] = {px, py, pz}, *const R[3] = {rx, ry, rz};
  float *const color[3] = {r, g, b};
  AnyslRayDerivatives change = rayDerivatives(ANYSL_CHANGE_ARGUMENTS);
  services->trace_derivatives(args->renderer, args, point, W, mask, P, R, &change, color);
}

} // namespace

#define WIDE_FORMS(W, Mask)                                                                        \
  extern "C" WideRay<W, Mask> packet_trace_##W, packet_transmission_##W;                           \
  extern "C" WideDistance<W, Mask> packet_trace_distance_##W;                                      \
  extern "C" void packet_trace_change_##W(TRACE_PARAMETERS, Mask mask);                            \
  void packet_trace_change_##W(TRACE_PARAMETERS, Mask mask) {                                      \
    askWithChange<W>(args, point, px, py, pz, rx, ry, rz, ANYSL_CHANGE_ARGUMENTS, r, g, b, mask);  \
  }                                                                                                \
  void packet_trace_##W(const AnyslShadeArgs *args, uint32_t first, Lanes<W> px, Lanes<W> py,      \
                        Lanes<W> pz, Lanes<W> rx, Lanes<W> ry, Lanes<W> rz, float *r, float *g,    \
                        float *b, Mask mask) {                                                     \
    ask<W>(args->services->trace_packet, packet_trace, args, first, mask, {px, py, pz},            \
           {rx, ry, rz}, r, g, b);                                                                 \
  }                                                                                                \
  void packet_transmission_##W(const AnyslShadeArgs *args, uint32_t first, Lanes<W> fx,            \
                               Lanes<W> fy, Lanes<W> fz, Lanes<W> tx, Lanes<W> ty, Lanes<W> tz,    \
                               float *r, float *g, float *b, Mask mask) {                          \
    ask<W>(args->services->transmission_packet, packet_transmission, args, first, mask,            \
           {fx, fy, fz}, {tx, ty, tz}, r, g, b);                                                   \
  }                                                                                                \
  Lanes<W> packet_trace_distance_##W(const AnyslShadeArgs *args, uint32_t first, Lanes<W> px,      \
                                     Lanes<W> py, Lanes<W> pz, Lanes<W> rx, Lanes<W> ry,           \
                                     Lanes<W> rz, Mask mask) {                                     \
    return askDistance<W>(args, first, mask, {px, py, pz}, {rx, ry, rz});                          \
  }

WIDE_FORMS(4, uint8_t)
WIDE_FORMS(8, uint8_t)
WIDE_FORMS(16, uint16_t)

//===-- Operators -----------------------------------------------------------------------------===//

void anysl_trace_color(anysl_color *result, anysl_context *context, const anysl_point *P,
                       const anysl_vector *R) {
  float r, g, b;
  float px = numberOf(P->x), py = numberOf(P->y), pz = numberOf(P->z);
  float rx = numberOf(R->x), ry = numberOf(R->y), rz = numberOf(R->z);
  withKnownChange(context, *P, *R, [&](auto... change) {
    if constexpr (sizeof...(change) > 0)
      if (raysCarryDerivatives())
        return packet_trace_change(context->args, context->point, &px, &py, &pz, &rx, &ry, &rz,
                                   change..., &r, &g, &b);
    packet_trace(context->args, context->point, px, py, pz, rx, ry, rz, &r, &g, &b);
  });
  *result = {r, g, b};
}

void anysl_trace_float(anysl_float *result, anysl_context *context, const anysl_point *P,
                       const anysl_vector *R) {
  *result = packet_trace_distance(context->args, context->point, numberOf(P->x), numberOf(P->y),
                                  numberOf(P->z), numberOf(R->x), numberOf(R->y), numberOf(R->z));
}

void anysl_transmission(anysl_color *result, anysl_context *context, const anysl_point *from,
                        const anysl_point *to) {
  float r, g, b;
  packet_transmission(context->args, context->point, numberOf(from->x), numberOf(from->y),
                      numberOf(from->z), numberOf(to->x), numberOf(to->y), numberOf(to->z), &r, &g,
                      &b);
  *result = {r, g, b};
}
