//===-- benchmarks/shading/ShadingPoints.cpp --------------------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "ShadingPoints.h"

#include <cmath>
#include <cstring>

namespace anysl::benchmarks {
namespace {

void trace(void *, const AnyslShadeArgs *, uint32_t, const double[3], const double direction[3],
           double color[3]) {
  color[0] = 0.3 + 0.1 * direction[0];
  color[1] = 0.4 + 0.2 * direction[1];
  color[2] = 0.5 + 0.3 * direction[1];
}

void tracePacket(void *, const AnyslShadeArgs *, uint32_t, uint32_t width, uint32_t, const float *,
                 const float *direction, float *color) {
  const float *x = direction, *y = direction + width;
  for (uint32_t i = 0; i < width; ++i) {
    color[i] = 0.3f + 0.1f * x[i];
    color[width + i] = 0.4f + 0.2f * y[i];
    color[2 * width + i] = 0.5f + 0.3f * y[i];
  }
}

AnyslServices makeServices() {
  AnyslServices result = {};
  result.struct_size = sizeof result;
  result.trace = trace;
  result.trace_packet = tracePacket;
  return result;
}

AnyslLight makeLight(uint32_t kind, float x, float y, float z, float strength) {
  AnyslLight light = {};
  light.kind = kind;
  for (float &channel : light.color)
    channel = strength;
  float *place = kind == ANYSL_LIGHT_DISTANT ? light.direction : light.from;
  place[0] = x, place[1] = y, place[2] = z;
  return light;
}

void write(AnyslBatch *batch, int global, uint32_t point, float x, float y = 0, float z = 0) {
  const float value[3] = {x, y, z};
  anysl_batch_write_float(batch, global, point, 1, value, 3);
}

} // namespace

const AnyslServices &services() {
  static const AnyslServices table = makeServices();
  return table;
}

void fillBatch(AnyslBatch *batch) {
  constexpr uint32_t side = 64;
  static_assert(side * side == pointCount);
  for (uint32_t i = 0; i < pointCount; ++i) {
    float x = 1.9f * (float(i % side) + 0.5f) / side - 0.95f;
    float y = 1.9f * (float(i / side) + 0.5f) / side - 0.95f;
    float r = std::sqrt(x * x + y * y);
    if (r > 0.99f) // outside the disc: pull in to the grazing rim
      x *= 0.99f / r, y *= 0.99f / r;
    float z = -std::sqrt(1 - x * x - y * y);
    float u = 0.5f + std::atan2(x, -z) * 0.159154943f, v = 0.5f + std::asin(y) * 0.318309886f;
    write(batch, ANYSL_P, i, x, y, z);
    write(batch, ANYSL_N, i, x, y, z);
    write(batch, ANYSL_Ng, i, x, y, z);
    write(batch, ANYSL_I, i, x, y, z + 3);
    write(batch, ANYSL_Cs, i, 0.9f, 0.6f, 0.3f);
    write(batch, ANYSL_Os, i, 1, 1, 1);
    write(batch, ANYSL_u, i, u);
    write(batch, ANYSL_v, i, v);
    write(batch, ANYSL_s, i, u);
    write(batch, ANYSL_t, i, v);
    write(batch, ANYSL_dPdu, i, -z, 0, x);
    write(batch, ANYSL_dPdv, i, 0, 1, 0);
    write(batch, ANYSL_du, i, 1.f / side);
    write(batch, ANYSL_dv, i, 1.f / side);
  }
  write(batch, ANYSL_E, 0, 0, 0, -3);
  static const AnyslLight lights[] = {makeLight(ANYSL_LIGHT_DISTANT, 0.6f, -0.48f, 0.64f, 0.8f),
                                      makeLight(ANYSL_LIGHT_POINT, -3, 4, -5, 20)};
  static const float ambient[3] = {0.1f, 0.1f, 0.1f};
  anysl_batch_set_lights(batch, lights, 2, ambient);
}

} // namespace anysl::benchmarks
