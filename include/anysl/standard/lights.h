//===-- anysl/standard/lights.h - the lights of a batch ---------------------------------------===//
//
// Part of AnySL, under the Apache License v2.0 with LLVM Exceptions. See LICENSE.
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===------------------------------------------------------------------------------------------===//
//
// Lights lie in AnyslShadeArgs and are evaluated in line: which kind a light is, and all of its
// data, are the same for every point, so widened code branches on the kind and computes the rest
// for all points at once. The formulas are those of the RenderMan Interface's standard light
// sources (version 3.2, appendix A.2.2). Only a light that casts shadows asks the renderer, through
// the runtime's own anysl_transmission.
//
//===------------------------------------------------------------------------------------------===//

#ifndef ANYSL_STANDARD_LIGHTS_H
#define ANYSL_STANDARD_LIGHTS_H

#include <anysl/domain.h>
#include <anysl/standard/context.h>

namespace anysl {

/// Where the shadow ray of a distant light ends: far outside a scene, and near enough that the
/// square of its length is a float.
inline constexpr double distantLightDistance = 1e12;

inline anysl_vector vectorFrom(const float (&a)[3]) {
  return {anysl_float(a[0]), anysl_float(a[1]), anysl_float(a[2])};
}

inline anysl_color colorFrom(const float (&a)[3]) {
  return {anysl_float(a[0]), anysl_float(a[1]), anysl_float(a[2])};
}

/// 3t^2 - 2t^3 between two edges, and a step where they coincide.
inline anysl_float smoothEdge(const anysl_float &low, const anysl_float &high,
                              const anysl_float &x) {
  anysl_float t = divide(x - low, high - low);
  t = select(t < 0, anysl_float(0), select(t > 1, anysl_float(1), t));
  return select(x < low, anysl_float(0), select(x >= high, anysl_float(1), t * t * (3 - 2 * t)));
}

} // namespace anysl

void anysl_ambient(anysl_color *result, anysl_context *context) {
  *result = anysl::colorFrom(context->args->ambient);
}

int32_t anysl_light_count(anysl_context *context) { return int32_t(context->args->light_count); }

bool anysl_light_is_nondiffuse(anysl_context *context, int32_t index) {
  return context->args->lights[index].flags & ANYSL_LIGHT_NONDIFFUSE;
}

bool anysl_light_is_nonspecular(anysl_context *context, int32_t index) {
  return context->args->lights[index].flags & ANYSL_LIGHT_NONSPECULAR;
}

bool anysl_light_sample(anysl_context *context, int32_t index, const anysl_point *P,
                        anysl_vector *L, anysl_color *Cl) {
  using namespace anysl;
  const AnyslLight &light = context->args->lights[index];
  anysl_vector direction = vectorFrom(light.direction);
  anysl_vector toLight = vectorFrom(light.from) - *P;
  anysl_float strength(1);
  bool reaches = true;
  switch (light.kind) {
  case ANYSL_LIGHT_DISTANT:
    toLight = -direction;
    break;
  case ANYSL_LIGHT_POINT:
    strength = divide(anysl_float(1), dot(toLight, toLight));
    break;
  case ANYSL_LIGHT_SPOT: {
    anysl_float length = lengthOf(toLight.x, toLight.y, toLight.z);
    anysl_float cosine = divide(-dot(toLight, direction), length);
    reaches = cosine > light.cos_outer;
    strength = divide(power(cosine, anysl_float(light.beam)), dot(toLight, toLight)) *
               smoothEdge(anysl_float(light.cos_outer), anysl_float(light.cos_inner), cosine);
    break;
  }
  default:
    reaches = false;
  }
  anysl_color color = colorFrom(light.color) * strength;
  anysl_float zero(0);
  *L = toLight;
  *Cl = {select(reaches, color.r, zero), select(reaches, color.g, zero),
         select(reaches, color.b, zero)};
  return reaches;
}

/// An operator of its own, so that only those points send a ray which the light reaches and which
/// face it.
void anysl_light_shadow(anysl_context *context, int32_t index, const anysl_point *P,
                        anysl_color *Cl) {
  using namespace anysl;
  const AnyslLight &light = context->args->lights[index];
  if (!(light.flags & ANYSL_LIGHT_CASTS_SHADOW))
    return;
  anysl_vector from = vectorFrom(light.from);
  if (light.kind == ANYSL_LIGHT_DISTANT)
    from = *P - vectorFrom(light.direction) * anysl_float(distantLightDistance);
  anysl_color passing;
  anysl_transmission(&passing, context, P, &from);
  *Cl = *Cl * passing;
}

#endif // ANYSL_STANDARD_LIGHTS_H
