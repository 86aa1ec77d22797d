//===-- runtimes/packet/light.cpp - light shaders, one point or a packet at a time ------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// The service `light` as trace.cpp has the others: nine results, L, Cl and Ol, come back through
// pointers.
//
//===------------------------------------------------------------------------------------------===//

#include "packet.h"
#include <anysl/standard/lights.h>

namespace {

using Light = void(const AnyslShadeArgs *args, uint32_t point, uint32_t light, float px, float py,
                   float pz, float nx, float ny, float nz, float *lx, float *ly, float *lz,
                   float *r, float *g, float *b, float *opaqueR, float *opaqueG, float *opaqueB);

template <int W, typename Mask>
using WideLight = void(const AnyslShadeArgs *args, uint32_t first, uint32_t light, Lanes<W> px,
                       Lanes<W> py, Lanes<W> pz, Lanes<W> nx, Lanes<W> ny, Lanes<W> nz, float *lx,
                       float *ly, float *lz, float *r, float *g, float *b, float *opaqueR,
                       float *opaqueG, float *opaqueB, Mask mask);

} // namespace

extern "C" {

ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M4uluvvvvvvl4l4l4l4l4l4l4l4l4_packet_light", packet_light_4)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M8uluvvvvvvl4l4l4l4l4l4l4l4l4_packet_light", packet_light_8)
ANYSL_VECTOR_VARIANT("_ZGV_LLVM_M16uluvvvvvvl4l4l4l4l4l4l4l4l4_packet_light", packet_light_16)
__attribute__((noinline)) Light packet_light;

} // extern "C"

void packet_light(const AnyslShadeArgs *args, uint32_t point, uint32_t light, float px, float py,
                  float pz, float nx, float ny, float nz, float *lx, float *ly, float *lz, float *r,
                  float *g, float *b, float *opaqueR, float *opaqueG, float *opaqueB) {
  double P[3] = {px, py, pz}, N[3] = {nx, ny, nz}, result[9] = {0, 0, 0, 0, 0, 0, 1, 1, 1};
  if (args->services->light)
    args->services->light(args->renderer, args, point, light, P, N, result);
  *lx = float(result[0]), *ly = float(result[1]), *lz = float(result[2]);
  *r = float(result[3]), *g = float(result[4]), *b = float(result[5]);
  *opaqueR = float(result[6]), *opaqueG = float(result[7]), *opaqueB = float(result[8]);
}

namespace {

/// Asks the packet form of the service or, where the renderer has none, the scalar form point by
/// point.
template <int W>
void ask(const AnyslShadeArgs *args, uint32_t first, uint32_t light, uint32_t mask, Packet<W> P,
         Packet<W> N, float *const (&to)[9]) {
  if (args->services->light_packet) {
    alignas(64) float result[9][W];
    args->services->light_packet(args->renderer, args, first, W, mask, light, P.data(), N.data(),
                                 result[0]);
    for (int i = 0; i < 9; ++i)
      store<W>(to[i], load<W>(result[i]));
    return;
  }
  const auto &p = P.component, &n = N.component;
  for (uint32_t i = 0; i < W; ++i)
    if (mask & (1u << i))
      packet_light(args, first + i, light, p[0][i], p[1][i], p[2][i], n[0][i], n[1][i], n[2][i],
                   to[0] + i, to[1] + i, to[2] + i, to[3] + i, to[4] + i, to[5] + i, to[6] + i,
                   to[7] + i, to[8] + i);
}

} // namespace

#define WIDE_FORM(W, Mask)                                                                         \
  extern "C" WideLight<W, Mask> packet_light_##W;                                                  \
  void packet_light_##W(const AnyslShadeArgs *args, uint32_t first, uint32_t light, Lanes<W> px,   \
                        Lanes<W> py, Lanes<W> pz, Lanes<W> nx, Lanes<W> ny, Lanes<W> nz,           \
                        float *lx, float *ly, float *lz, float *r, float *g, float *b,             \
                        float *opaqueR, float *opaqueG, float *opaqueB, Mask mask) {               \
    float *const to[] = {lx, ly, lz, r, g, b, opaqueR, opaqueG, opaqueB};                          \
    ask<W>(args, first, light, mask, {px, py, pz}, {nx, ny, nz}, to);                              \
  }

WIDE_FORM(4, uint8_t)
WIDE_FORM(8, uint8_t)
WIDE_FORM(16, uint16_t)

void anysl::askLight(anysl_context *context, int32_t index, const anysl_point &P,
                     const anysl_normal &N, anysl_vector &L, anysl_color &Cl, anysl_color &Ol) {
  float lx, ly, lz, r, g, b, opaqueR, opaqueG, opaqueB;
  packet_light(context->args, context->point, uint32_t(index), numberOf(P.x), numberOf(P.y),
               numberOf(P.z), numberOf(N.x), numberOf(N.y), numberOf(N.z), &lx, &ly, &lz, &r, &g,
               &b, &opaqueR, &opaqueG, &opaqueB);
  L = {lx, ly, lz};
  Cl = {r, g, b};
  Ol = {opaqueR, opaqueG, opaqueB};
}
