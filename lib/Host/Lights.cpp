//===-- lib/Host/Lights.cpp - lights of the standard kinds and of shaders ---------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//

#include "lib/Host/LightRun.h"
#include "lib/STC/Effects.h"
#include <algorithm>
#include <cmath>
#include <cstring>

using namespace anysl::host;
namespace stc = anysl::stc;

namespace {

constexpr uint64_t bit(int global) { return uint64_t(1) << global; }

/// What a light shader gets of the light and of the question itself; the rest is the surface's.
constexpr uint64_t ofLight =
    bit(ANYSL_P) | bit(ANYSL_N) | bit(ANYSL_Ng) | bit(ANYSL_Ps) | bit(ANYSL_Ns) | bit(ANYSL_L) |
    bit(ANYSL_Cl) | bit(ANYSL_Ol) | bit(ANYSL_Ci) | bit(ANYSL_Oi) | bit(ANYSL_dPdu) |
    bit(ANYSL_dPdv) | bit(ANYSL_dNdu) | bit(ANYSL_dNdv) | bit(ANYSL_dNgdu) | bit(ANYSL_dNgdv);

const AnyslParamInfo *singleParam(const AnyslShaderInfo &shader, const char *name, uint32_t type) {
  const AnyslParamInfo *param = anysl_shader_param(&shader, name);
  return param && param->type == type && !param->array_length ? param : nullptr;
}

/// The fixed value of a flag; \p computed is set where the shader computes it.
bool readFlag(const AnyslInstance &instance, const char *name, bool &computed) {
  const AnyslParamInfo *param = singleParam(*instance.shader, name, ANYSL_FLOAT);
  if (!param)
    return false;
  computed |= (param->flags & ANYSL_PARAM_OUTPUT) != 0;
  return instance.cells[param->first_cell].number != 0;
}

AnyslStatus fromInstance(const AnyslInstance &instance, AnyslLight &light) {
  const AnyslShaderInfo &shader = *instance.shader;
  if (shader.kind != ANYSL_LIGHT)
    return fail(ANYSL_ERROR_TYPE, context(*instance.library, shader) + "it is a " +
                                      anysl_kind_name(shader.kind) + " shader, not a light shader");
  light = {};
  light.kind = ANYSL_LIGHT_SHADER;
  light.shader = &instance;
  static constexpr AnyslCell none = {};
  light.params = instance.cells.empty() ? &none : instance.cells.data();
  light.code = shader.code;
  bool computed = false;
  if (readFlag(instance, "__nondiffuse", computed))
    light.flags |= ANYSL_LIGHT_NONDIFFUSE;
  if (readFlag(instance, "__nonspecular", computed))
    light.flags |= ANYSL_LIGHT_NONSPECULAR;
  if (computed)
    light.flags |= ANYSL_LIGHT_COMPUTES_FLAGS;
  const AnyslSourceInfo source = sourceOf(*instance.library, shader);
  if (!(source.globals_written & bit(ANYSL_L)))
    light.flags |= ANYSL_LIGHT_AMBIENT;
  if (stc::has(source.effects, stc::Effect::Solar))
    light.flags |= ANYSL_LIGHT_FAR;
  if (const AnyslParamInfo *category = singleParam(shader, "__category", ANYSL_STRING))
    light.category = instance.cells[category->first_cell].string;
  double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  AnyslShadeArgs args;
  anysl_instance_fill_args(&instance, &args);
  if (instance.services.space_matrix)
    instance.services.space_matrix(instance.renderer, &args, "shader", "current", matrix);
  for (int k = 0; k < 3; ++k) {
    light.color[k] = 1;
    light.direction[k] = float(matrix[8 + k]);
    light.from[k] = float(matrix[12 + k]);
  }
  return ANYSL_OK;
}

/// In float and in the order in which the light shaders of examples/shaders compute, so that the
/// bits are theirs.
AnyslStatus makeStandard(uint32_t kind, const AnyslStandardLight &values, AnyslLight &light) {
  if (kind < ANYSL_LIGHT_DISTANT || kind > ANYSL_LIGHT_SPOT)
    return fail(ANYSL_ERROR_RANGE, "there is no standard light of kind " + std::to_string(kind));
  float axis[3], squares = 0;
  for (int k = 0; k < 3; ++k) {
    axis[k] = values.to[k] - values.from[k];
    squares += axis[k] * axis[k];
  }
  float length = std::sqrt(squares);
  if (kind != ANYSL_LIGHT_POINT && !(length > 0))
    return fail(ANYSL_ERROR_RANGE, "a light that shines from a point to that same point");
  light = {};
  light.kind = kind;
  for (int k = 0; k < 3; ++k) {
    light.color[k] = values.intensity * values.color[k] * values.share;
    light.from[k] = values.from[k];
    light.direction[k] = length > 0 ? axis[k] / length : 0;
  }
  light.cos_outer = float(std::cos(double(values.cone_angle)));
  light.cos_inner = float(std::cos(double(values.cone_angle - values.cone_delta_angle)));
  light.beam = values.beam_distribution;
  return ANYSL_OK;
}

} // namespace

int anysl::host::globalOfSurface(int global) {
  switch (global) {
  case ANYSL_dPsdu:
    return ANYSL_dPdu;
  case ANYSL_dPsdv:
    return ANYSL_dPdv;
  case ANYSL_dNsdu:
    return ANYSL_dNdu;
  case ANYSL_dNsdv:
    return ANYSL_dNdv;
  default:
    return global;
  }
}

extern "C" {

AnyslStatus anysl_light_from_instance(const AnyslInstance *instance, AnyslLight *light) {
  return guarded([&] { return fromInstance(*instance, *light); });
}

void anysl_standard_light_defaults(AnyslStandardLight *values) {
  constexpr float degree = float(3.14159265358979323846 / 180);
  *values = {1, {1, 1, 1}, {0, 0, 0}, {0, 0, 1}, 30 * degree, 5 * degree, 2, 1};
}

AnyslStatus anysl_light_standard(uint32_t kind, const AnyslStandardLight *values,
                                 AnyslLight *light) {
  return guarded([&] { return makeStandard(kind, *values, *light); });
}

uint64_t anysl_lights_globals(const AnyslLight *lights, uint32_t count) {
  uint64_t read = 0, globals = 0;
  for (uint32_t i = 0; i < count; ++i)
    if (lights[i].kind == ANYSL_LIGHT_SHADER)
      read |= static_cast<const AnyslInstance *>(lights[i].shader)->shader->globals_read;
  for (int global = 0; global < ANYSL_GLOBAL_COUNT; ++global)
    if ((read & ~ofLight) >> global & 1)
      globals |= uint64_t(1) << globalOfSurface(global);
  return globals;
}

} // extern "C"
